// One island through one step by the times of its events: move on, find the earliest impact (or the
// time at which a ball on ground or wall begins to slide, to roll or to lift off), resolve it, look
// again at the pairs of the balls that it changed, until the step ends. Paths are per ball, so an
// event costs what its neighbourhood costs, and the integrator's order survives every impact.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/broadphase.h"
#include "contacts/impact_time.h"
#include "contacts/ledger.h"
#include "state/world.h"

namespace wells {

/// What all islands of a step share.
struct StepInput {
  StepInput(const World& world, const Field& field, const Integrator& integrator)
      : settings(world.settings), model{&field,
                                        &integrator,
                                        &world.arena,
                                        settings.drag,
                                        settings.friction,
                                        settings.rollingResistance} {}

  const Settings& settings;
  PathModel model;
};

enum class IslandFate : std::uint8_t {
  Done,       // the balls are at the end of the step
  Alone,      // nothing meets: all fly through the step as if each were alone
  Sustained,  // a contact lasts, or inelastic impacts pile up: for the solver of lasting contacts
  TooFar,     // a ball left its reach, so pairs may be missing: enlarge it and start again
  TooMany     // more elastic impacts than settings.mostImpacts
};

/// After so many attempts at a step with ever larger reaches an island that is still thrown beyond
/// them is left to the substeps: it is not worth more. Not so where impacts are lossless, which
/// substeps would not keep so: there attempts go on until reaches suffice.
inline constexpr int kMostExactAttempts = 8;

/// The method of a step: what is asked for, but substeps where the integrator has no dense output.
inline ContactMethod methodOf(const Settings& settings, const Field& field,
                              const Integrator& integrator) {
  return isDenseIn(integrator, field, settings.drag) ? settings.contactMethod
                                                     : ContactMethod::Substep;
}

struct ExactCounts {
  std::int64_t impacts = 0;   // contacts that got an impulse, once for each reflection
  std::int64_t clusters = 0;  // instants at which several of them hung together
};

/// An island with more inelastic impacts or changes of motion in one step than this, or for each of
/// its balls than that, whichever is more, is left to the solver of lasting contacts. So is one
/// with an inelastic impact that is slower than what presses the balls together in half a substep:
/// its bounces would be shorter than one. (Not so one ball that bounces on ground or wall alone;
/// see kSettlingTime.)
inline constexpr std::int64_t kMostInelasticImpacts = 1000;
inline constexpr std::int64_t kMostInelasticOfBall = 10;

/// The bounces of one ball on ground or wall follow each other in a geometric series of ratio e.
/// When what is left of it is shorter than this (of the step), or the next one lower than this (of
/// the size of the coordinates; rounding is not far), the surface holds the ball from then on.
inline constexpr double kSettlingTime = 1e-6;
inline constexpr double kSettlingHeight = 1e-14;

class ExactFlight {
 public:
  /// Advances the balls of an island, with all pairs that may meet in the step, by
  /// settings.dt. `balls` holds states at the start, and at the end of the step if Done; else
  /// it is unchanged (also if Alone: many flights at once cost less). reach[i] (m) is how far ball
  /// i may move for `pairs` to be complete; where TooFar is returned, it has been enlarged.
  IslandFate run(const StepInput& in, std::span<const std::uint32_t> island,
                 std::span<const BallPair> pairs, std::span<double> reach, Balls& balls);

  /// From now on runs are booked.
  void openBooks() { keepsBooks_ = true; }

  /// Of the last run that was Done.
  const ExactCounts& counts() const { return counts_; }
  const Books& books() const { return books_; }

 private:
  struct Event {
    double time;         // s since the start of the step
    std::uint32_t pair;  // kEndOfMotion: of ball `ball`
    std::uint32_t ball;
    std::uint32_t versionA;
    std::uint32_t versionB;
  };
  static constexpr std::uint32_t kEndOfMotion = 0xffffffff;

  /// A ball beside its path.
  struct Flown {
    double pull;  // m/s^2, bound on that of wells and drag along the path, in flight
    double end;   // s, of its path; at most dt_
    BallState start;
    std::uint32_t version;  // rises at each event of the ball
    std::uint32_t firstPair;
    std::uint32_t pairCount;
    bool isInCluster = false;
  };

  static bool later(const Event& x, const Event& y);

  /// Ball i is on this path from now on.
  void set(const StepInput& in, std::uint32_t i, const Path& path);
  /// For balls of the island.
  Path& pathOf(std::uint32_t i) { return path_[place_[i]]; }
  const Path& pathOf(std::uint32_t i) const { return path_[place_[i]]; }
  Flown& of(std::uint32_t i) { return flown_[place_[i]]; }
  const Flown& of(std::uint32_t i) const { return flown_[place_[i]]; }
  Flyer flyer(std::uint32_t i) const { return {&pathOf(i), of(i).pull}; }
  /// True where it is certain without following paths that the pair does not meet by the end of the
  /// step, as its balls move now.
  bool stayApart(const StepInput& in, const BallPair& pair) const;
  IslandFate tryStep(const StepInput& in, std::span<const std::uint32_t> island,
                     std::span<const BallPair> pairs, std::span<double> reach, Balls& balls);
  /// Whoever goes on with a large island needs room, too.
  void giveRoomBack();
  /// As if all were in flight.
  void begin(const StepInput& in, std::span<const std::uint32_t> island, const Balls& balls);
  /// Looks who is held, and lists the pairs of each ball.
  void takeHold(const StepInput& in, std::span<const std::uint32_t> island,
                std::span<const BallPair> pairs, const Balls& balls);
  IslandFate simulate(const StepInput& in, std::span<const BallPair> pairs, std::span<double> reach,
                      Balls& balls);
  /// Moves all to the end of the step, which nothing disturbs any more.
  void endStep(const StepInput& in, std::span<const std::uint32_t> island, std::span<double> reach,
               Balls& balls);
  /// At an event, with the states of the cluster's balls in `balls`.
  IslandFate resolve(const StepInput& in, double time, Balls& balls);
  enum class Bounce : std::uint8_t {
    OfMany,        // not of one ball alone that ground or wall presses back
    OneOfASeries,  // which has an end, see kSettlingTime
    Last           // that counts
  };
  /// Of the cluster.
  Bounce bounceOfLoneBall(const StepInput& in, double time, const Balls& balls) const;
  /// m/s^2, of a lone ball to ground or wall.
  static double pressingOn(const StepInput& in, double time, const Contact& c, const Balls& balls);
  /// True when the bounce at ground or wall is the last that counts. `pressing` in m/s^2.
  bool settles(const Arena& arena, double elasticity, double pressing, const Contact& c,
               const Balls& balls) const;
  /// True when a ball that leaves the surface at `rising` (m/s) hardly leaves it.
  static bool isTooLow(const Arena& arena, double rising, double pressing, const Contact& c,
                       const Balls& balls);
  /// Of a lone ball in the corner: friction on one surface makes it leave the other, but so slowly
  /// that rounding hides the hop.
  void endHops(const StepInput& in, double time, Balls& balls);
  /// Adds the next impact of pair p. False: its contact lasts.
  bool foresee(const StepInput& in, std::span<const BallPair> pairs, std::uint32_t p);
  /// Ball i has followed its path until t.
  void book(const StepInput& in, std::uint32_t i, double t, const Balls& balls);
  /// A surface may have taken hold of ball i, which had `before`.
  void bookHold(std::uint32_t i, const BallState& before, const Balls& balls);
  void foreseeEndOfMotion(const StepInput& in, std::uint32_t ball);
  void add(const Event& event);
  /// Both for the cluster's balls and all their pairs.
  bool foreseeCluster(const StepInput& in, std::span<const BallPair> pairs);
  bool isOutdated(std::span<const BallPair> pairs, const Event& event) const;
  void gatherCluster(const StepInput& in, std::span<const BallPair> pairs, const Event& event,
                     Balls& balls);
  /// Bound (m/s^2) on what presses a contact together.
  double pressingBound(const StepInput& in, double time, const Contact& c,
                       const Balls& balls) const;
  bool mayBePressed(const StepInput& in, double time, const Balls& balls) const;
  bool isTooSlow(const StepInput& in, double time, const Balls& balls) const;
  /// At time t: where the ball may leave its reach by the end of the step, it grows. The run goes
  /// on, to find all that are too short before the step starts over.
  void checkReach(const StepInput& in, std::uint32_t ball, double t, const Balls& balls,
                  std::span<double> reach);

  std::vector<std::uint32_t> place_;  // by ball of the world, in the island; of no others valid
  // By place in the island, with room for the largest so far.
  std::vector<Path> path_;
  std::vector<Flown> flown_;
  // By island.
  std::vector<std::uint32_t> pairsOf_;
  std::vector<Event> events_;  // heap, earliest first
  std::vector<Contact> cluster_;
  std::vector<std::uint32_t> clusterBalls_;
  std::vector<std::uint32_t> flying_;    // at the end of the step
  std::vector<std::uint8_t> inCluster_;  // by pair of the island
  ExactCounts counts_;
  bool keepsBooks_ = false;
  Books books_;
  Ledger ledger_;
  std::int64_t motionsEnded_ = 0;
  bool anyTooFar_ = false;
  std::int64_t mostInelastic_ = 0;
  double dt_ = 0;  // s
};

}  // namespace wells
