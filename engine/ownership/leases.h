// Who counts as alive. A lease belongs to one incarnation of a peer and lives on the listener's own
// monotonic clock, which callers pass in as a number of seconds; simulated time plays no part.
//
//  - It begins when the incarnation is first heard, and is renewed only by a message whose
//  committed
//    step has advanced or that says that the step stands still on purpose: a peer whose network
//    thread lives on while its simulation hangs is gone.
//  - Without renewal it runs out. The same incarnation, heard again and advancing, begins a new
//  one:
//    it was suspected wrongly. What was adopted from it meanwhile stays adopted, by its version.
//  - A newer incarnation of the peer ends it at once, if it has been silent for half its time:
//    supersede(). One that restarted or fenced itself has; of two machines that both got the same
//    id neither has, and both live until one takes another id.
//  - A good-bye ends it for good: end().
#pragma once

#include <map>
#include <optional>

#include "ownership/version.h"

namespace wells {

enum class Progress : std::uint8_t {
  Running,  // the committed step must advance
  Paused,   // it stands still on purpose
};

class Leases {
 public:
  /// A message of `who` came, in which its committed step is `step`. `duration` (s) is how long its
  /// silence is borne from now on. True when that begins or renews the lease.
  bool hear(const Incarnation& who, std::int64_t step, Progress progress, double duration,
            double now);

  /// Somebody says that `who` was alive at `time`. One who is unknown gets one lease from then on.
  void expect(const Incarnation& who, double duration, double time);

  /// Ends the lease of `who` for good.
  void end(const Incarnation& who, double now);

  /// Ends the leases of every other incarnation of newest.peer that were not renewed for half their
  /// duration. Whether such a one may be heard again is for the caller to know: not as long as
  /// `newest` lives.
  void supersede(const Incarnation& newest, double now);

  bool isLiving(const Incarnation& who, double now) const { return !endedAt(who, now); }

  /// True after end().
  bool isOver(const Incarnation& who) const;

  /// When the lease ended (s); nothing while it lasts. -infinity for one who is unknown.
  std::optional<double> endedAt(const Incarnation& who, double now) const;

  /// When the lease ends if it is not renewed, or has ended (s); -infinity for one who is unknown.
  double runsOutAt(const Incarnation& who, double now) const;

  /// Forgets the leases that ended before `time`.
  void forget(double time, double now);

  void clear() { leases_.clear(); }

 private:
  struct Lease {
    std::int64_t step = 0;
    double duration = 0;            // s
    double renewed = 0;             // s
    std::optional<double> ended{};  // s; set: it did not just run out
    bool isOver = false;            // for good
  };
  std::optional<double> endedAt(const Lease& lease, double now) const;
  std::map<Incarnation, Lease> leases_;
};

/// True when an owner whose loop last ran at `last` must not send as the one it was: others may
/// have counted it out. It drops what it owns and takes a new incarnation. Half a lease leaves the
/// other half to the journey of its last message and to the difference of the clocks' rates.
inline bool mustFence(double last, double now, double lease) {
  return now - last > lease / 2;
}

}  // namespace wells
