#include "simulation/draw_schedule.h"

#include <algorithm>

#include "math/random.h"

namespace wells::simulation {
namespace {

// Healing takes: two leases of listening for who has just started, two more when it waits for one
// who started earlier, a third for another id, and synchronising.
constexpr double kHealing = 18;  // s before the end
constexpr double kStopped = 5;   // s before the end

constexpr double kMaxLoss = 0.3;
constexpr double kMaxDuplication = 0.5;
constexpr double kMaxDelay = 0.15;      // s
constexpr double kMaxClockOffset = 10;  // s

class Draw {
 public:
  Draw(std::uint64_t seed, const SessionShape& shape) : random_(seed ^ 0x5eed), shape_(shape) {
    schedule_.seed = seed;
    schedule_.peers = shape.peers;
    schedule_.balls = shape.balls;
    schedule_.end = shape.seconds;
    schedule_.heal = shape.seconds - kHealing;
    schedule_.stop = shape.seconds - kStopped;
    schedule_.latency = random_.uniform(0, 0.02);
  }

  Schedule schedule() {
    starts();
    const auto episodes =
        static_cast<int>(static_cast<double>(5 + random_.below(8)) * schedule_.heal / 42);
    for (int i = 0; i < episodes; ++i) episode();
    comeBack();
    std::ranges::stable_sort(schedule_.faults, {}, &Fault::at);
    return schedule_;
  }

 private:
  void starts() {
    const bool together = random_.below(2) == 0;
    const double spread = random_.below(2) == 0 ? 3 : 12;
    for (int slot = 0; slot < shape_.peers; ++slot)
      add({.at = together ? 0 : random_.uniform(0, spread),
           .kind = FaultKind::Start,
           .slot = slot});
    for (int slot = 0; slot < shape_.peers; ++slot)
      add({.at = 0,
           .kind = FaultKind::ClockJump,
           .slot = slot,
           .amount = random_.uniform(-kMaxClockOffset, kMaxClockOffset)});
  }

  void episode() {
    Fault fault{
        .at = random_.uniform(0, schedule_.heal - 2),
        .kind = static_cast<FaultKind>(random_.below(kFaultKinds)),
        .slot = anySlot(),
        .other = anySlot(),
        .duration = random_.below(2) == 0 ? random_.uniform(0.2, 3) : random_.uniform(2, 12)};
    if (random_.below(4) > 0) {
      fault.state = static_cast<PeerState>(random_.below(kPeerStates));
      if (random_.below(4) > 0) fault.slot = Fault::kAnySlot;
    }
    switch (fault.kind) {
      case FaultKind::Loss:
        fault.amount = random_.uniform(0.02, kMaxLoss);
        break;
      case FaultKind::Duplication:
        fault.amount = random_.uniform(0.05, kMaxDuplication);
        break;
      case FaultKind::Delay:
        fault.amount = random_.uniform(0.01, kMaxDelay);
        break;
      case FaultKind::ClockJump:
        fault.amount = random_.uniform(-kMaxClockOffset, kMaxClockOffset);
        break;
      case FaultKind::TinyBuffer:
        fault.amount = static_cast<double>(2 + random_.below(8));
        break;
      case FaultKind::ReplayLog:
        fault.amount = random_.uniform(0.5, 30);
        break;
      case FaultKind::Setting:
        fault.amount = random_.uniform(0, 1);
        break;
      case FaultKind::Pause:
        fault.duration = random_.uniform(0.2, 3);
        break;
      case FaultKind::Crash:
      case FaultKind::CrashBeforeOffer:
      case FaultKind::CrashAfterOffer:
      case FaultKind::CrashAfterAnswer:
      case FaultKind::Leave:
        fault.duration = random_.below(16) == 0 ? 0 : random_.uniform(0.1, 6);
        fault.amount = random_.below(3) == 0 ? 1 : 0;
        break;
      default:
        break;
    }
    add(fault);
    if (fault.state && random_.below(2) == 0) lead(fault);
  }

  /// Sees to it that a peer gets into a state that is rare.
  void lead(const Fault& fault) {
    Fault before{.at = std::max(0.0, fault.at - random_.uniform(0, 0.5)),
                 .slot = Fault::kAnySlot,
                 .state = PeerState::Owns,
                 .duration = random_.uniform(0.3, 3)};
    switch (*fault.state) {
      case PeerState::Paused:
        before.kind = FaultKind::Pause;
        break;
      case PeerState::Leaving:
        before.kind = FaultKind::Leave;
        break;
      case PeerState::Bereft:
      case PeerState::Syncing:
      case PeerState::Joining:
        before.kind = FaultKind::Crash;
        break;
      default:
        return;
    }
    add(before);
  }

  /// When the faults end, some who are gone start again; two, at least, are there.
  void comeBack() {
    const int first = anySlot();
    for (int slot = 0; slot < shape_.peers; ++slot)
      if (slot == first || slot == (first + 1) % shape_.peers || random_.below(2) == 0)
        add({.at = schedule_.heal, .kind = FaultKind::Start, .slot = slot});
  }

  int anySlot() {
    return static_cast<int>(random_.below(static_cast<std::uint64_t>(shape_.peers)));
  }

  void add(const Fault& fault) {
    schedule_.faults.push_back(fault);
    schedule_.faults.back().at = std::min(fault.at, schedule_.heal);
  }

  Random random_;
  SessionShape shape_;
  Schedule schedule_;
};

}  // namespace

Schedule drawSchedule(std::uint64_t seed, const SessionShape& shape) {
  return Draw(seed, shape).schedule();
}

}  // namespace wells::simulation
