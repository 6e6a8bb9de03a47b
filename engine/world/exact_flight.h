// One island through one step by the times of its impacts: fly, find the earliest impact, resolve
// it, look again at the pairs of the balls that it changed, until the step ends. Flight is per
// ball, so an event costs what its neighbourhood costs, and the integrator's order survives every
// impact.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contacts/contact.h"
#include "flight/trajectory.h"
#include "state/world.h"

namespace wells {

/// What all islands of a step share.
struct StepInput {
  const Settings& settings;
  const Arena& arena;
  FlightModel model;
};

enum class IslandFate : std::uint8_t {
  Done,       // the balls are at the end of the step
  Sustained,  // a contact lasts, or inelastic impacts pile up: for the solver of lasting contacts
  TooFar      // a ball left its reach, so pairs may be missing: enlarge it and start again
};

/// After so many attempts at a step with ever larger reaches all of it is left to the substeps: a
/// heap that throws its balls further each time is not worth more.
inline constexpr int kMostExactAttempts = 8;

/// The method of the given attempt (from 1) at a step: what is asked for, but substeps where the
/// integrator has no dense output and after kMostExactAttempts.
inline ContactMethod methodOf(const Settings& settings, const Integrator& integrator, int attempt) {
  return integrator.isDense && attempt <= kMostExactAttempts ? settings.contactMethod
                                                             : ContactMethod::Substep;
}

struct ExactCounts {
  std::int64_t impacts = 0;   // contacts that got an impulse, once for each reflection
  std::int64_t clusters = 0;  // instants at which several of them hung together
};

/// What is left to the solver of lasting contacts: inelastic impacts (e < 1) slower than what the
/// pressing acceleration builds up in half a substep, whose bounces would be shorter than one; and
/// islands with more impacts in one step than these. Elastic impacts are never too slow, and their
/// limit is far above what physics asks for (Galperin's billiard at mass ratio 10^8 has 31,415 in
/// all); it is met by elastic heaps that a strong well presses together.
inline constexpr std::int64_t kMostInelasticImpacts = 1000;
inline constexpr std::int64_t kMostElasticImpacts = 50'000;

class ExactFlight {
 public:
  /// Advances the balls of an island, with all pairs that may meet in the step, by
  /// settings.dt. `balls` holds states at the start, and at the end of the step if Done; else
  /// it is unchanged. reach[i] (m) is how far ball i may move for `pairs` to be complete; where
  /// TooFar is returned, it has been enlarged.
  IslandFate run(const StepInput& in, std::span<const std::uint32_t> island,
                 std::span<const Contact> pairs, std::span<double> reach, Balls& balls);

  /// Of the last run that was Done.
  const ExactCounts& counts() const { return counts_; }

 private:
  struct Event {
    double time;  // s since the start of the step
    std::uint32_t pair;
    std::uint32_t versionA;
    std::uint32_t versionB;
  };

  static bool later(const Event& x, const Event& y);

  void begin(double dt, std::span<const std::uint32_t> island, std::span<const Contact> pairs,
             const Balls& balls);
  IslandFate simulate(const StepInput& in, std::span<const Contact> pairs, std::span<double> reach,
                      Balls& balls);
  /// Adds the next impact of pair p. False: its contact lasts.
  bool foresee(const StepInput& in, std::span<const Contact> pairs, std::uint32_t p);
  /// The same for all pairs of the cluster's balls.
  bool foreseeCluster(const StepInput& in, std::span<const Contact> pairs);
  bool isOutdated(const Event& event, const Contact& pair) const;
  void gatherCluster(const StepInput& in, std::span<const Contact> pairs, const Event& event,
                     Balls& balls);
  bool isTooSlow(const StepInput& in, double time, const Balls& balls) const;
  bool isTooFar(std::uint32_t ball, const Balls& balls, std::span<double> reach) const;

  // By ball, sized for the world; only those of the island are valid.
  std::vector<Trajectory> path_;
  std::vector<BallState> start_;
  std::vector<std::uint32_t> version_;  // rises at each event of the ball
  std::vector<std::uint32_t> firstPair_;
  std::vector<std::uint32_t> pairCount_;
  // By island.
  std::vector<std::uint32_t> pairsOf_;
  std::vector<Event> events_;  // heap, earliest first
  std::vector<Contact> cluster_;
  std::vector<std::uint32_t> clusterBalls_;
  std::vector<std::uint8_t> inCluster_;  // by pair of the island
  ExactCounts counts_;
  double dt_ = 0;                   // s
  const double* radius_ = nullptr;  // m, by ball
};

}  // namespace wells
