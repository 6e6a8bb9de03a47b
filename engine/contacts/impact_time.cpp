#include "contacts/impact_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wells {
namespace {

// A graze (closing speed near 0 at the contact) converges by halves; what is not decided after so
// many looks is closer than rounding and left to the next step.
constexpr int kMostLooks = 200;

/// A gap at one time: its value (m), its closing speed (m/s) and by how much that can grow (m/s^2).
struct GapNow {
  double gap;
  double closing;
  double growth;
};

/// The longest time in which a gap >= gap - closing s - growth s^2 / 2 stays open; infinite if it
/// always does.
double safeTime(const GapNow& now) {
  const double root = std::sqrt(now.closing * now.closing + 2 * now.growth * now.gap);
  if (now.closing > 0) return 2 * now.gap / (now.closing + root);
  if (now.growth == 0) return std::numeric_limits<double>::infinity();
  return (root - now.closing) / now.growth;
}

/// Closing speeds up to this, times the speeds that they are made of, are rounding.
constexpr double kClosingNoise = 1e-14;

double withoutNoise(double closing, double speed) {
  return std::abs(closing) <= kClosingNoise * speed ? 0 : closing;
}

/// Follows `gapAt` from `from`; `closed` is the gap (in its own unit) that counts as none.
template <class GapAt>
Encounter follow(GapAt gapAt, double closed, double from, double until) {
  double t = from;
  for (int look = 0; look < kMostLooks; ++look) {
    GapNow now = gapAt(t, until);
    if (now.gap <= closed) {
      // The last, tiny step of Newton's method takes the contact to where rounding allows.
      if (now.closing > 0)
        return {Meeting::Impact, std::min(until, t + std::max(0.0, now.gap / now.closing))};
      now.gap = 0;
      if (now.closing == 0 && now.growth > 0) return {Meeting::Sustained, t};
    }
    const double step = safeTime(now);
    if (!(t + step <= until)) return {};
    if (t + step == t) return {now.closing > 0 ? Meeting::Impact : Meeting::Sustained, t};
    t += step;
  }
  return {};
}

double horizontal(const Vec3& v) {
  return std::sqrt(v.x() * v.x() + v.z() * v.z());
}

Encounter encounterWithGround(const FlightModel& model, const Arena& arena, const Trajectory& ball,
                              double radius, double from, double until) {
  const double gravity = std::abs(model.field->gravity.y());
  const auto gapAt = [&](double t, double end) -> GapNow {
    const BallState now = stateAt(model, ball, t);
    return {groundGap(arena, now.position, radius),
            withoutNoise(-now.velocity.y(), length(now.velocity)),
            gravity + accelerationBound(model, now, t, end - t)};
  };
  const double size = std::abs(arena.center.y()) + std::abs(ball.state.position.y()) + radius;
  return follow(gapAt, kClosedGap * size, from, until);
}

Encounter encounterWithWall(const FlightModel& model, const Arena& arena, const Trajectory& ball,
                            double radius, double from, double until) {
  const double reach = arena.radius - radius;  // of the centre from the axis
  const double gravity = horizontal(model.field->gravity);
  const auto gapAt = [&](double t, double end) -> GapNow {
    const BallState now = stateAt(model, ball, t);
    const Vec3 p = now.position - arena.center;
    const double pull = gravity + accelerationBound(model, now, t, end - t);
    const double fastest = horizontal(now.velocity) + pull * (end - t);
    // (R^2 - rho^2)'' = -2 (v^2 + p.a)
    return {reach * reach - p.x() * p.x() - p.z() * p.z(),
            2 * withoutNoise(p.x() * now.velocity.x() + p.z() * now.velocity.z(),
                             reach * length(now.velocity)),
            2 * (fastest * fastest + reach * pull)};
  };
  const double size = horizontal(arena.center) + arena.radius;
  return follow(gapAt, 2 * reach * kClosedGap * size, from, until);
}

}  // namespace

Encounter encounterOfBalls(const FlightModel& model, const Trajectory& a, double radiusA,
                           const Trajectory& b, double radiusB, double from, double until) {
  const auto gapAt = [&](double t, double end) -> GapNow {
    const BallState nowA = stateAt(model, a, t);
    const BallState nowB = stateAt(model, b, t);
    const Vec3 d = nowB.position - nowA.position;
    const double distance = length(d);
    // Coincident centres: as deep as can be, and nowhere to go.
    if (distance == 0) return {-radiusA - radiusB, 0, 1};
    // Gravity is the same for both.
    return {
        distance - radiusA - radiusB,
        withoutNoise(dot(nowA.velocity - nowB.velocity, d) / distance,
                     length(nowA.velocity) + length(nowB.velocity)),
        accelerationBound(model, nowA, t, end - t) + accelerationBound(model, nowB, t, end - t)};
  };
  const double size = length(a.state.position) + length(b.state.position) + radiusA + radiusB;
  return follow(gapAt, kClosedGap * size, from, until);
}

Encounter encounterWithArena(const FlightModel& model, const Arena& arena, const Trajectory& ball,
                             double radius, std::uint32_t partner, double from, double until) {
  return partner == kGround ? encounterWithGround(model, arena, ball, radius, from, until)
                            : encounterWithWall(model, arena, ball, radius, from, until);
}

}  // namespace wells
