// The impulses of one island of contacts by passes: one contact after another, each impulse
// accumulated and clamped (see sequential_impulses.h). Works on copies: 64 bytes of each ball and
// what each contact needs, so that a pass computes nothing twice and touches little memory.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contacts/ledger.h"
#include "state/settings.h"

namespace wells {

class IslandPasses {
 public:
  /// Passes over the contacts of an island that act, until one changes no relative velocity by more
  /// than `solved` (m/s), at most `most`. `balls` contain the impulses that the contacts hold; both
  /// get the new ones.
  void solve(const Settings& settings, std::span<Contact* const> island, int most, double solved,
             Balls& balls, const Ledger& ledger);

 private:
  struct Body {
    Vec3 velocity;         // m/s
    Vec3 surface;          // m/s, radius times spin
    double inverseMass;    // 1/kg; 0: the arena
    double inverseRadius;  // 1/m; likewise
  };
  struct Row {
    Contact* contact;
    std::uint32_t a, b;  // bodies
    Vec3 normal;
    double normalMass, inverseNormalMass;  // kg, 1/kg
    double tangentMass;                    // kg, of the tangent plane
    double bounceSpeed;                    // m/s
    double inverseTurning;                 // 1/(kg m^2)
    double normalImpulse;                  // N s
    Vec3 tangentImpulse, rollingImpulse;   // N s, N m s
  };
  static constexpr std::uint32_t kArena = 0;

  void take(const Settings& settings, std::span<Contact* const> island, const Balls& balls);
  std::uint32_t bodyOf(std::uint32_t ball, double inverseMass, const Balls& balls);
  // These return the square of the change of relative velocity, m^2/s^2.
  double solvePush(double friction, Row& row);
  double solveRolling(double resistance, Row& row);
  void giveBack(Balls& balls, const Ledger& ledger) const;

  std::vector<Row> rows_;
  std::vector<Body> bodies_;
  std::vector<std::uint32_t> ballOf_;  // by body
  std::vector<std::uint32_t> number_;  // by ball; valid where ballOf_[number_[i]] == i
};

}  // namespace wells
