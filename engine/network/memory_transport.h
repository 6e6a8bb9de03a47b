// A network in memory: any number of endpoints in one process, with seeded faults on a simulated
// clock. The same seed and the same calls give the same arrivals in the same order.
//
// It has no threads, no wall clock and no locks: network and endpoints belong to one thread.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "math/random.h"
#include "network/transport.h"

namespace wells {

/// What may happen to a message on its way to each single receiver. The default is a perfect
/// network, on which a message arrives at the instant it was published.
struct MemoryFaults {
  double loss = 0;         // probability, 0 .. 1
  double duplication = 0;  // probability that a second copy arrives, with a delay of its own
  double delay = 0;        // s, shortest
  double jitter = 0;       // s, each copy takes delay + uniform [0, jitter): messages overtake
};

enum class MemoryLink { Up, Cut };

class MemoryTransport;

class MemoryNetwork {
 public:
  /// Messages that may wait for one endpoint, under way or arrived; more are counted as dropped by
  /// it.
  static constexpr std::size_t kCapacity = 100'000;  // unless setCapacity() says otherwise

  /// Throws std::invalid_argument when a probability is outside [0, 1] or a time is negative.
  explicit MemoryNetwork(std::uint64_t seed = 1, const MemoryFaults& faults = {});

  /// Holds for messages published from now on. Throws as the constructor does.
  void setFaults(const MemoryFaults& faults);

  /// One way, between endpoint numbers. A message already under way still arrives.
  void setLink(int from, int to, MemoryLink link);

  /// Room for the messages of one endpoint, for a receive buffer that is too small. It holds for
  /// what is published from now on.
  void setCapacity(int endpoint, std::size_t messages);

  /// s; starts at 0.
  double now() const { return now_; }

  /// Lets `seconds` >= 0 of simulated time pass.
  void advance(double seconds) { now_ += seconds; }

 private:
  friend class MemoryTransport;

  struct Message {
    std::string channel;
    std::vector<std::byte> bytes;
  };
  // Ordered by arrival time; equal times in the order of sending, which a multimap keeps.
  struct Inbox {
    std::multimap<double, std::shared_ptr<const Message>> messages;
    std::size_t capacity = kCapacity;
    std::int64_t dropped = 0;
  };

  int open();
  void close(int endpoint) { inboxes_.erase(endpoint); }
  void publish(int from, std::string_view channel, std::span<const std::byte> bytes);
  void deliver(Inbox& inbox, const std::shared_ptr<const Message>& message);

  Random random_;
  MemoryFaults faults_;
  double now_ = 0;
  int nextEndpoint_ = 0;
  std::map<int, Inbox> inboxes_;
  std::set<std::pair<int, int>> cuts_;
};

/// One endpoint. It hears its own messages too, as with LCM's multicast. Destroying it is how a
/// test crashes a peer: what was under way to it is lost, what it sent still arrives.
class MemoryTransport final : public Transport {
 public:
  explicit MemoryTransport(std::shared_ptr<MemoryNetwork> network);
  ~MemoryTransport() override;
  MemoryTransport(const MemoryTransport&) = delete;
  MemoryTransport& operator=(const MemoryTransport&) = delete;

  /// Number in its network: 0, 1, 2 ... in order of creation; never used again.
  int endpoint() const { return endpoint_; }

  void publish(std::string_view channel, std::span<const std::byte> bytes) override;

  /// Hands over what has arrived by now(). What the handler publishes waits for the next poll.
  void poll(const Handler& handler) override;

  TransportCounts counts() const override;
  std::string description() const override { return "memory"; }

 private:
  std::shared_ptr<MemoryNetwork> network_;
  int endpoint_;
  TransportCounts counts_;
};

}  // namespace wells
