#include "network/lcm_transport.h"

#include <lcm/lcm.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "math/step_timer.h"
#include "network/multicast_check.h"
#include "network/socket_drops.h"
#include "threads/placement.h"

namespace wells {
namespace {

constexpr std::chrono::milliseconds kReceivePatience{50};
constexpr std::chrono::seconds kLookInterval{1};

double checkedRate(double rate) {
  if (!(rate > 0)) {
    throw std::invalid_argument("network rate is " + std::to_string(rate) +
                                " Hz; it must be greater than 0");
  }
  return rate;
}

std::string clippedBufferNote(int granted, int wanted) {
  return "The kernel grants " + std::to_string(granted) + " of the " + std::to_string(wanted) +
         " bytes of receive buffer; a busy session may lose messages. This raises it: sudo sysctl "
         "-w net.core.rmem_max=" +
         std::to_string(wanted);
}

std::string failureText(const LcmUrl& url, const MulticastCheck& check) {
  const std::string where = url.group + ":" + std::to_string(url.port);
  if (check.result == MulticastCheck::Result::NoRoute) {
    return "No multicast route for " + where + " (" + check.reason +
           "); this adds one: sudo ip route add 224.0.0.0/4 dev <interface>";
  }
  return "Multicast to " + where + " does not pass on this host (" + check.reason +
         "); look at the firewall and at: ip route get " + url.group;
}

// Signals are for the main thread.
void blockSignals() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

void LcmTransport::Closer::operator()(_lcm_t* lcm) const {
  lcm_destroy(lcm);
}

LcmTransport::LcmTransport(std::string_view url, double targetRate)
    : url_(parseLcmUrl(url)), targetRate_(checkedRate(targetRate)) {
  open();
  receiver_ = std::jthread([this](const std::stop_token& stop) { receiveLoop(stop); });
  sender_ = std::jthread([this](const std::stop_token& stop) { sendLoop(stop); });
}

void LcmTransport::open() {
  const MulticastCheck check = checkMulticast(url_);
  if (check.result != MulticastCheck::Result::Passes) {
    throw TransportError(failureText(url_, check));
  }
  // LCM is asked for what the kernel grants anyway, because it would print a warning of its own.
  LcmUrl granted = url_;
  granted.receiveBuffer = check.receiveBuffer;
  if (granted.receiveBuffer < url_.receiveBuffer) {
    note_ = clippedBufferNote(granted.receiveBuffer, url_.receiveBuffer);
  }
  const std::set<int> others = udpSocketsOn(url_.port);
  lcm_.reset(lcm_create(granted.text().c_str()));
  if (!lcm_) throw TransportError("LCM could not be opened on " + granted.text());

  // LCM calls back only from lcm_handle_timeout, so not before receiveLoop runs.
  const auto handler = [](const lcm_recv_buf_t* message, const char* channel, void* self) {
    static_cast<LcmTransport*>(self)->receive(*message, channel);
  };
  const std::string channels = std::string(kChannelPrefix) + ".*";
  lcm_subscription_t* subscription = lcm_subscribe(lcm_.get(), channels.c_str(), handler, this);
  if (!subscription) throw TransportError("LCM could not listen on " + granted.text());
  // LCM's default of 30 drops the rest of a burst without a word.
  lcm_subscription_set_queue_capacity(subscription, static_cast<int>(kInboxCapacity));
  sockets_ = udpSocketsOn(url_.port);
  for (const int other : others) sockets_.erase(other);
}

void LcmTransport::publish(std::string_view channel, std::span<const std::byte> bytes) {
  const std::lock_guard lock(outMutex_);
  if (bytes.size() > kMaxMessageBytes || !outbox_.push(channel, bytes)) ++out_.droppedSending;
}

void LcmTransport::poll(const Handler& handler) {
  polled_.clear();
  {
    const std::lock_guard lock(inMutex_);
    std::swap(inbox_, polled_);
  }
  for (std::size_t i = 0; i < polled_.size(); ++i) handler(polled_.channel(i), polled_.bytes(i));
}

void LcmTransport::receive(const lcm_recv_buf_t& message, std::string_view channel) {
  // The size comes first: LCM passes on a broken datagram with a size beyond its data.
  const std::size_t size = message.data_size;
  const std::lock_guard lock(inMutex_);
  if (size > kMaxMessageBytes ||
      !inbox_.push(channel, {static_cast<const std::byte*>(message.data), size})) {
    ++in_.droppedReceiving;
    return;
  }
  ++in_.messagesReceived;
  in_.bytesReceived += static_cast<std::int64_t>(size);
}

void LcmTransport::receiveLoop(const std::stop_token& stop) {
  blockSignals();
  nameThisThread("network in");
  auto nextLook = Clock::now();
  while (!stop.stop_requested()) {
    const int handled = lcm_handle_timeout(lcm_.get(), static_cast<int>(kReceivePatience.count()));
    if (handled < 0) std::this_thread::sleep_for(kReceivePatience);
    if (Clock::now() < nextLook) continue;
    nextLook = Clock::now() + kLookInterval;
    lookAtSocket();
  }
}

void LcmTransport::lookAtSocket() {
  std::int64_t dropped = 0;
  for (const int socket : sockets_) dropped += droppedAtSocket(socket);
  const std::lock_guard lock(inMutex_);
  in_.droppedByKernel = dropped;
}

void LcmTransport::sendLoop(const std::stop_token& stop) {
  blockSignals();
  nameThisThread("network out");
  StepTimer timer(targetRate_);
  while (!stop.stop_requested()) {
    if (timer.targetRate() != targetRate_) timer.setTargetRate(targetRate_);
    const auto due = std::max(timer.nextTick(), Clock::now());
    timer.waitForNextTick();
    sendOutbox(due);
    const std::lock_guard lock(outMutex_);
    rate_ = {timer.recentRate(), timer.meanRate()};
  }
  sendOutbox(Clock::now());
}

void LcmTransport::sendOutbox(Clock::time_point due) {
  sending_.clear();
  {
    const std::lock_guard lock(outMutex_);
    std::swap(outbox_, sending_);
  }
  const std::size_t burstSize = burst(sending_.size());
  auto aliveAt = due;
  for (std::size_t i = 0; i < sending_.size(); ++i) {
    // After a stall of the whole process these are the words of one whom others may have counted
    // out meanwhile.
    if (Clock::now() - aliveAt > kStall) {
      const std::lock_guard lock(outMutex_);
      out_.droppedSending += static_cast<std::int64_t>(sending_.size() - i);
      return;
    }
    aliveAt = Clock::now();
    if (sinceRest_ >= burstSize) {
      std::this_thread::sleep_for(kBurstInterval);
      sinceRest_ = 0;
    }
    ++sinceRest_;
    const auto bytes = sending_.bytes(i);
    const bool sent = lcm_publish(lcm_.get(), sending_.channel(i).data(), bytes.data(),
                                  static_cast<unsigned>(bytes.size())) == 0;
    const std::lock_guard lock(outMutex_);
    if (sent) {
      ++out_.messagesSent;
      out_.bytesSent += static_cast<std::int64_t>(bytes.size());
    } else {
      ++out_.droppedSending;
    }
  }
}

std::size_t LcmTransport::burst(std::size_t messages) const {
  const double bursts = 0.75 / targetRate_ / std::chrono::duration<double>(kBurstInterval).count();
  const double evenly = std::ceil(static_cast<double>(messages) / bursts);
  return static_cast<std::size_t>(std::clamp<double>(evenly, kSmallBurst, kLargeBurst));
}

TransportCounts LcmTransport::counts() const {
  const std::scoped_lock lock(inMutex_, outMutex_);
  TransportCounts counts = out_;
  counts.messagesReceived = in_.messagesReceived;
  counts.bytesReceived = in_.bytesReceived;
  counts.droppedReceiving = in_.droppedReceiving;
  counts.droppedByKernel = in_.droppedByKernel;
  return counts;
}

std::string LcmTransport::description() const {
  return "lcm " + url_.text();
}

void LcmTransport::setTargetRate(double targetRate) {
  targetRate_ = checkedRate(targetRate);
}

bool LcmTransport::pin(std::span<const int> cores) {
  return pinThread(receiver_.native_handle(), cores) && pinThread(sender_.native_handle(), cores);
}

LcmTransport::Rate LcmTransport::networkRate() const {
  const std::lock_guard lock(outMutex_);
  return rate_;
}

}  // namespace wells
