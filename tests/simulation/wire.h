// The network of a simulated session with everything that is wrong with it at the moment: loss,
// cut links, small buffers; and what was sent, so that it can be played back and forged.
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "network/memory_transport.h"
#include "simulation/fault.h"
#include "simulation/forge.h"

namespace wells::simulation {

class Wire {
 public:
  enum class Recording { Off, On };  // costs time; playing back needs it

  Wire(std::uint64_t seed, double latency, Recording recording);

  const std::shared_ptr<MemoryNetwork>& network() { return network_; }
  double now() const { return network_->now(); }
  void advanceTo(double time) { network_->advance(time - network_->now()); }

  /// Where a slot's process is connected.
  struct Plug {
    int slot = 0;
    int endpoint = 0;
  };

  /// Makes the network what the faults that last at the moment make of it.
  void apply(std::span<const Fault> lasting, std::span<const Plug> plugs);

  /// A message of `slot` went out.
  void record(int slot, std::string_view channel, std::span<const std::byte> bytes);

  /// Somebody who is no peer says something; it may get lost as any message.
  void say(std::string_view channel, std::span<const std::byte> bytes);

  /// What `slot` (kAnySlot: anybody) sent between the times arrives once more, at once.
  void replay(int slot, double from, double to);

  /// Spoiled forms of what was sent last arrive.
  void forge(std::size_t balls);

 private:
  struct Sent {
    double time = 0;  // s
    int slot = 0;
    RawMessage message;
  };
  static constexpr double kKept = 40;  // s
  static constexpr std::size_t kMostReplayed = 300;
  static constexpr int kForged = 12;

  double latency_;
  Recording recording_;
  Random random_;
  std::shared_ptr<MemoryNetwork> network_;
  std::deque<Sent> sent_;
};

}  // namespace wells::simulation
