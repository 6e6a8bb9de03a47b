// The impulses of one small island of contacts, found together to rounding accuracy: no contact
// closes, only pressed ones push, friction within Coulomb's circular cone and opposite to what
// slips.
//
// With w the velocities at the contacts after the impulses (w_n along the normal, parting, less
// what restitution asks for; w_t the slip) and y the impulses,
//   w_n >= 0,  y_n >= 0,  w_n y_n = 0;   |y_t| <= mu y_n,  y_t = -mu y_n w_t/|w_t| where w_t != 0
// is the same as (Alart & Curnier, "A mixed formulation for frictional contact problems prone to
// Newton like solution methods", 1991), for z = y - w,
//   y_n = max(0, z_n),   y_t = z_t, shortened to mu max(0, z_n) if it is longer.
// Rolling resistance is a second cone of each contact, with the torque and the rolling part of the
// relative angular velocity in the place of y_t and w_t, and the lever arm in that of mu.
//
// y and w are measured in units in which each impulse changes its own w by 1. The equations are
// solved by Newton's method, piece by piece smooth. It starts from the impulses of the substep
// before, which mostly leaves nothing to do.
//
// With more contacts than the balls have freedoms, forces are not unique and Newton's matrix is
// singular; those nearest to the start are taken, by proximal points: with w + p (y - c) in place
// of w the solution is unique, and c, set to it again and again, goes to a solution of the
// equations (Rockafellar, "Monotone operators and the proximal point algorithm", 1976). A tiny p
// does in one round, mostly; a larger one, made smaller round by round, keeps Newton's steps short
// where it does not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contacts/contact.h"

namespace wells {

/// Islands of up to this many contacts are solved directly, unless something bounces in them. In
/// heaps of 10 and 25 balls about a well 16 were always solved, within 1.1 ms a step at the worst;
/// of 24, all but 37 of some thousand, within 7 ms; of 32, half were not, at 10 ms a step in the
/// mean. Such heaps have more contacts than balls have freedoms.
inline constexpr std::size_t kMostDirect = 24;
/// Likewise where balls move against each other: there the solution lasts for one substep, and a
/// larger island costs more (with the cube of its contacts) than that is worth.
inline constexpr std::size_t kMostDirectMoving = 10;

class DirectSolver {
 public:
  struct Impulse {
    double normal = 0;            // N s, >= 0
    Vec3 tangent = Vec3::Zero();  // N s on a
    Vec3 rolling = Vec3::Zero();  // N m s on a, of rolling resistance
  };

  /// Finds the impulses of these contacts, whose geometry, masses and bounceSpeed are set. The
  /// velocities and spins of `balls` already contain the impulses that the contacts hold. Changes
  /// neither. False: not found in kMostSteps; impulses() are then of no use.
  /// rollingResistance: m.
  bool solve(double friction, std::span<Contact* const> contacts, const Balls& balls,
             double rollingResistance = 0);

  /// By contact of the last solve().
  std::span<const Impulse> impulses() const { return impulses_; }

  static constexpr int kMostSteps = 60;  // of Newton's method, in all rounds
  static constexpr int kMostInRound = 15;

  // Residuals, in parts of the largest impulse.
  static constexpr double kTolerance = 1e-15;
  static constexpr double kStalled = 1e-12;  // near enough where rounding stops the steps

  // p of the first round; of the second, where the first did not do; and by how much it grows after
  // a round that fails and shrinks after one that does not.
  static constexpr double kLeastProximity = 1e-10;
  static constexpr double kSafeProximity = 1e-2;
  static constexpr double kMostProximity = 1;
  static constexpr double kGrowth = 100;
  static constexpr double kShrinking = 10;

 private:
  /// One unknown: an impulse on a along `push`, which turns the balls about turnA and turnB. Of a
  /// torque, push is 0 and turnA and turnB are 1/radius long.
  struct Row {
    Vec3 push;
    Vec3 turnA;
    Vec3 turnB;
    double scale;  // sqrt(kg), of a torque sqrt(kg) m: impulse in SI over the solver's units
  };
  /// Two unknowns, from `first` on, whose size is limited by the normal one of their contact.
  struct Cone {
    std::size_t normal;
    std::size_t first;
    double limit;  // in the solver's units
  };

  void makeRoom(std::size_t most);
  void setUp(std::span<Contact* const> contacts, const Balls& balls);
  double couplingOf(std::span<Contact* const> contacts, std::size_t i, std::size_t j) const;
  bool approach();
  /// Full steps may go uphill, and out of where damped ones get stuck.
  enum class Steps : std::uint8_t { Damped, Full };
  /// One round. False: it got stuck.
  bool runNewton(Steps steps);
  /// Sets velocity_, residual_ and error_ of impulse_; returns the square sum of the residual.
  double evaluate();
  void linearise();
  void keepImpulses(std::span<Contact* const> contacts, const Balls& balls);

  std::size_t rowsPerContact_ = 3;  // normal, two tangents, two torques
  double friction_ = 0;
  double rollingResistance_ = 0;  // m
  double scale_ = 0;
  double error_ = 0;
  double proximity_ = 0;
  int stepsLeft_ = 0;
  std::vector<Row> rows_;
  std::vector<Cone> cones_;
  std::vector<double> coupling_;  // by row and row: what impulse does to velocity
  std::vector<double> start_, startVelocity_, center_;
  std::vector<double> impulse_, velocity_, residual_;  // y, w and what is left of the equations
  std::vector<double> matrix_, step_, before_;
  std::vector<Impulse> impulses_;
};

}  // namespace wells
