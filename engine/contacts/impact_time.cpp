#include "contacts/impact_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wells {
namespace {

// Within one horizon. A graze converges by halves; a ball that the pull of a well lifts off slowly
// takes the most, about a thousand. What is not decided then is for the solver of lasting contacts.
constexpr int kMostLooks = 5000;

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

/// Follows gapAt(t, end), whose bounds hold from t to end, from `from` to `until`; `closed` is the
/// gap (in its own unit) that counts as none. Looks no further ahead than `stretch` at a time,
/// within which the bounds are close to the truth.
template <class GapAt>
Encounter follow(GapAt gapAt, double closed, double stretch, double from, double until) {
  double t = from;
  double horizon = std::min(until, t + stretch);
  for (int look = 0; look < kMostLooks; ++look) {
    GapNow now = gapAt(t, horizon);
    if (now.gap <= closed) {
      // The last, tiny step takes the contact to where rounding allows.
      if (now.closing > 0)
        return {Meeting::Impact, std::min(until, t + (now.gap > 0 ? safeTime(now) : 0))};
      now.gap = 0;
      if (now.closing == 0 && now.growth > 0) return {Meeting::Sustained, t};
    }
    const double step = safeTime(now);
    if (!(t + step <= horizon)) {
      if (horizon == until) return {};
      t = horizon;
      horizon = std::min(until, t + stretch);
      look = 0;
      continue;
    }
    if (t + step == t) return {now.closing > 0 ? Meeting::Impact : Meeting::Sustained, t};
    t += step;
  }
  return {Meeting::Sustained, t};
}

/// A ball that touches a surface, stands still towards it and is not pressed to it is about to
/// leave by its acceleration. It is followed from where it has left: after this share of the time,
/// or, as it may be back by then, after a share of that, and so on.
constexpr double kLeaving = 1.0 / 64;
constexpr double kSooner = 1.0 / 8;
constexpr int kMostSooner = 7;

template <class GapAt>
Encounter followFromContact(GapAt gapAt, double closed, double stretch, double from, double until) {
  const GapNow first = gapAt(from, until);
  if (!(first.gap <= closed && first.closing == 0 && first.growth > 0))
    return follow(gapAt, closed, stretch, from, until);
  double ahead = kLeaving * (until - from);
  for (int i = 0; i <= kMostSooner; ++i, ahead *= kSooner)
    if (gapAt(from + ahead, until).gap > closed)
      return follow(gapAt, closed, stretch, from + ahead, until);
  if (gapAt(until, until).gap >= -closed) return {};  // hardly away when the step ends
  return {Meeting::Sustained, from};
}

double horizontal(const Vec3& v) {
  return std::sqrt(v.x() * v.x() + v.z() * v.z());
}

Encounter encounterWithGround(const PathModel& model, const Path& ball, double from, double until) {
  const Arena& arena = *model.arena;
  const double gravity = std::abs(model.field->gravity.y());
  const auto gapAt = [&](double t, double end) -> GapNow {
    const BallState now = stateAt(model, ball, t);
    return {groundGap(arena, now.position, ball.radius),
            withoutNoise(-now.velocity.y(), length(now.velocity)),
            gravity + accelerationBound(model, ball, now, t, end - t)};
  };
  const double size = std::abs(arena.center.y()) + std::abs(ball.state.position.y()) + ball.radius;
  const double closed = kClosedGap * size;
  return followFromContact(gapAt, closed, model.field->stretch, from, until);
}

Encounter encounterWithWall(const PathModel& model, const Path& ball, double from, double until) {
  const Arena& arena = *model.arena;
  const double reach = arena.radius - ball.radius;  // of the centre from the axis
  const double gravity = horizontal(model.field->gravity);
  const auto gapAt = [&](double t, double end) -> GapNow {
    const BallState now = stateAt(model, ball, t);
    const Vec3 p = now.position - arena.center;
    const double pull = gravity + accelerationBound(model, ball, now, t, end - t);
    const double fastest = horizontal(now.velocity) + pull * (end - t);
    // (R^2 - rho^2)'' = -2 (v^2 + p.a)
    return {reach * reach - p.x() * p.x() - p.z() * p.z(),
            2 * withoutNoise(p.x() * now.velocity.x() + p.z() * now.velocity.z(),
                             reach * length(now.velocity)),
            2 * (fastest * fastest + reach * pull)};
  };
  const double size = horizontal(arena.center) + arena.radius;
  return followFromContact(gapAt, 2 * reach * kClosedGap * size, model.field->stretch, from, until);
}

}  // namespace

Encounter encounterOfBalls(const PathModel& model, const Path& a, const Path& b, double from,
                           double until) {
  const auto gapAt = [&](double t, double end) -> GapNow {
    const BallState nowA = stateAt(model, a, t);
    const BallState nowB = stateAt(model, b, t);
    const Vec3 d = nowB.position - nowA.position;
    const double distance = length(d);
    // Coincident centres: as deep as can be, and nowhere to go.
    if (distance == 0) return {-a.radius - b.radius, 0, 1};
    return {distance - a.radius - b.radius,
            withoutNoise(dot(nowA.velocity - nowB.velocity, d) / distance,
                         length(nowA.velocity) + length(nowB.velocity)),
            approachBound(model, a, nowA, b, nowB, t, end - t)};
  };
  const double size = length(a.state.position) + length(b.state.position) + a.radius + b.radius;
  return follow(gapAt, kClosedGap * size, model.field->stretch, from, until);
}

Encounter encounterWithArena(const PathModel& model, const Path& ball, std::uint32_t partner,
                             double from, double until) {
  if (ball.motion != Motion::Flying && (ball.surface == partner || ball.surface == kCorner))
    return {};
  return partner == kGround ? encounterWithGround(model, ball, from, until)
                            : encounterWithWall(model, ball, from, until);
}

}  // namespace wells
