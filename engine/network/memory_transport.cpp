#include "network/memory_transport.h"

#include <stdexcept>

namespace wells {
namespace {

void checkProbability(const char* name, double value) {
  if (!(value >= 0 && value <= 1)) {
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) +
                                "; it must be a probability, 0 to 1");
  }
}

void checkTime(const char* name, double value) {
  if (!(value >= 0)) {
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) +
                                " s; it must not be negative");
  }
}

}  // namespace

MemoryNetwork::MemoryNetwork(std::uint64_t seed, const MemoryFaults& faults) : random_(seed) {
  setFaults(faults);
}

void MemoryNetwork::setFaults(const MemoryFaults& faults) {
  checkProbability("loss", faults.loss);
  checkProbability("duplication", faults.duplication);
  checkTime("delay", faults.delay);
  checkTime("jitter", faults.jitter);
  faults_ = faults;
}

void MemoryNetwork::setLink(int from, int to, MemoryLink link) {
  if (link == MemoryLink::Cut) {
    cuts_.emplace(from, to);
  } else {
    cuts_.erase({from, to});
  }
}

void MemoryNetwork::setCapacity(int endpoint, std::size_t messages) {
  inboxes_.at(endpoint).capacity = messages;
}

int MemoryNetwork::open() {
  const int endpoint = nextEndpoint_++;
  inboxes_.try_emplace(endpoint);
  return endpoint;
}

void MemoryNetwork::publish(int from, std::string_view channel, std::span<const std::byte> bytes) {
  const auto message =
      std::make_shared<const Message>(Message{std::string(channel), {bytes.begin(), bytes.end()}});
  for (auto& [to, inbox] : inboxes_) {
    if (cuts_.contains({from, to})) continue;
    if (random_.uniform() < faults_.loss) continue;
    deliver(inbox, message);
    if (random_.uniform() < faults_.duplication) deliver(inbox, message);
  }
}

void MemoryNetwork::deliver(Inbox& inbox, const std::shared_ptr<const Message>& message) {
  if (inbox.messages.size() >= inbox.capacity) {
    ++inbox.dropped;
    return;
  }
  inbox.messages.emplace(now_ + faults_.delay + faults_.jitter * random_.uniform(), message);
}

MemoryTransport::MemoryTransport(std::shared_ptr<MemoryNetwork> network)
    : network_(std::move(network)), endpoint_(network_->open()) {}

MemoryTransport::~MemoryTransport() {
  network_->close(endpoint_);
}

void MemoryTransport::publish(std::string_view channel, std::span<const std::byte> bytes) {
  if (bytes.size() > kMaxMessageBytes) {
    ++counts_.droppedSending;
    return;
  }
  ++counts_.messagesSent;
  counts_.bytesSent += static_cast<std::int64_t>(bytes.size());
  network_->publish(endpoint_, channel, bytes);
}

void MemoryTransport::poll(const Handler& handler) {
  auto& inbox = network_->inboxes_.at(endpoint_).messages;
  // Taken out before the handler runs, because the handler may publish, and hears itself.
  decltype(MemoryNetwork::Inbox::messages) arrived;
  while (!inbox.empty() && inbox.begin()->first <= network_->now()) {
    arrived.insert(arrived.end(), inbox.extract(inbox.begin()));
  }
  for (const auto& [time, message] : arrived) {
    ++counts_.messagesReceived;
    counts_.bytesReceived += static_cast<std::int64_t>(message->bytes.size());
    handler(message->channel, message->bytes);
  }
}

TransportCounts MemoryTransport::counts() const {
  TransportCounts counts = counts_;
  counts.droppedReceiving = network_->inboxes_.at(endpoint_).dropped;
  return counts;
}

}  // namespace wells
