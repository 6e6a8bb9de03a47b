// LCM multicast behind Transport. Two threads of its own: one sends at the network's target rate,
// one takes what arrives at once. Any thread may call publish; poll is for one thread at a time.
//
// It moves bytes; it does not know what they mean.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include "network/lcm_url.h"
#include "network/message_queue.h"
#include "network/transport.h"
#include "network/transport_error.h"

struct _lcm_t;
struct _lcm_recv_buf_t;

namespace wells {

class LcmTransport final : public Transport {
 public:
  /// Only channels with this prefix are received; other programs may share the group.
  static constexpr std::string_view kChannelPrefix = "WELLS_";

  /// Messages that wait for poll(), and, in LCM, for our receiving thread: ten frames of 10,000
  /// balls, 12 balls a message. More are dropped and counted.
  static constexpr std::size_t kInboxCapacity = 8340;

  /// Messages that wait for the next sending tick. More are dropped and counted.
  static constexpr std::size_t kOutboxCapacity = 8340;

  /// Sending is paced: a tick's messages go out in bursts kBurstInterval apart, as small as three
  /// quarters of the tick allow, because a receiver whose thread has to wait for a processor loses
  /// what does not fit its kernel buffer. A message of 1,400 bytes takes 2,304 bytes of that (Linux
  /// counts its own book-keeping), so of the 212,992 bytes that Linux grants by default, and
  /// doubles for this reason, 184 messages may wait: 11 ms at kSmallBurst, 2.9 ms at kLargeBurst.
  /// kLargeBurst is 64,000 messages/s; all of 10,000 balls at 60 Hz are 834 * 60 = 50,040.
  static constexpr std::size_t kSmallBurst = 16;
  static constexpr std::size_t kLargeBurst = 64;
  static constexpr std::chrono::microseconds kBurstInterval{1000};

  /// When the sending thread stood still for longer, what waited to be sent is dropped and counted.
  static constexpr std::chrono::milliseconds kStall{250};

  struct Rate {
    double recent = 0;  // Hz, over about the last second
    double mean = 0;    // Hz, since the start
  };

  /// Opens the session's group and waits until a message of its own has come back.
  ///   targetRate  sending ticks, Hz, > 0; what is published waits for the next tick
  /// Throws LcmUrlError for a wrong URL, std::invalid_argument for a wrong rate, TransportError
  /// when multicast does not pass on this host.
  LcmTransport(std::string_view url, double targetRate);

  /// Sends what still waits, paced, which takes 0.3 s at the most, and ends the threads.
  ~LcmTransport() override = default;
  LcmTransport(const LcmTransport&) = delete;
  LcmTransport& operator=(const LcmTransport&) = delete;

  void publish(std::string_view channel, std::span<const std::byte> bytes) override;
  void poll(const Handler& handler) override;
  TransportCounts counts() const override;

  /// "lcm udpm://..."
  std::string description() const override;

  /// Takes effect at the next tick. Throws std::invalid_argument unless > 0 Hz.
  void setTargetRate(double targetRate);
  double targetRate() const { return targetRate_; }

  /// Of the sending ticks.
  Rate networkRate() const;

  /// From now on its threads run on these cores only. False: the system does not let them.
  bool pin(std::span<const int> cores);

  /// What the user may want to know about the set-up, one sentence; empty when all is well.
  std::string note() const { return note_; }

 private:
  using Clock = std::chrono::steady_clock;

  struct Closer {
    void operator()(_lcm_t* lcm) const;
  };

  void open();
  void lookAtSocket();
  void receiveLoop(const std::stop_token& stop);
  void sendLoop(const std::stop_token& stop);
  void sendOutbox(Clock::time_point due);
  std::size_t burst(std::size_t messages) const;
  void receive(const _lcm_recv_buf_t& message, std::string_view channel);

  LcmUrl url_;
  std::string note_;
  std::atomic<double> targetRate_;
  std::unique_ptr<_lcm_t, Closer> lcm_;
  std::set<int> sockets_;  // on which lcm_ listens: one, which it owns

  mutable std::mutex inMutex_;  // guards the next two
  MessageQueue inbox_{kInboxCapacity};
  TransportCounts in_;
  MessageQueue polled_{kInboxCapacity};  // poll()'s own

  mutable std::mutex outMutex_;  // guards the next three
  MessageQueue outbox_{kOutboxCapacity};
  TransportCounts out_;
  Rate rate_;
  MessageQueue sending_{kOutboxCapacity};  // the sending thread's own

  std::size_t sinceRest_ = 0;  // likewise: messages sent since the last burst's end

  // Last, so that they end before what they use: first the sender, then the receiver.
  std::jthread receiver_;
  std::jthread sender_;
};

}  // namespace wells
