#include "contacts/impact_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contacts/support.h"

namespace wells {
namespace {

// Within one horizon. A graze converges by halves; a ball that the pull of a well lifts off slowly
// takes the most, about a thousand. What is not decided then is for the solver of lasting contacts.
constexpr int kMostLooks = 5000;

/// A gap at one time: its value (m), its closing speed (m/s), and by how much that can grow and
/// shrink (m/s^2).
struct GapNow {
  double gap;
  double closing;
  double growth;
  double decline;
};

/// The longest time in which a gap >= gap - closing s - growth s^2 / 2 stays open; infinite if it
/// always does.
double safeTime(const GapNow& now) {
  const double root = std::sqrt(now.closing * now.closing + 2 * now.growth * now.gap);
  if (now.closing > 0) return 2 * now.gap / (now.closing + root);
  if (now.growth == 0) return std::numeric_limits<double>::infinity();
  return (root - now.closing) / now.growth;
}

/// True where the gap still closes after a safeTime(), and is then at most `closed`.
bool landsAfter(double safe, const GapNow& now, double closed) {
  return now.decline * safe < now.closing && (now.growth + now.decline) * safe * safe / 2 <= closed;
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
    if (landsAfter(step, now, closed)) return {Meeting::Impact, t + step};
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

/// Of a ball that is pulled by no more than `bound` (m/s^2) besides gravity.
GapNow gapToGround(const PathModel& model, const BallState& ball, double radius, double bound) {
  const double pull = std::abs(model.field->gravity.y()) + bound;
  return {groundGap(*model.arena, ball.position, radius),
          withoutNoise(-ball.velocity.y(), length(ball.velocity)), pull, pull};
}

double closedAtGround(const Arena& arena, const BallState& ball, double radius) {
  return kClosedGap * (std::abs(arena.center.y()) + std::abs(ball.position.y()) + radius);
}

/// In R^2 - rho^2, for the next `duration` seconds.
GapNow gapToWall(const PathModel& model, const BallState& ball, double radius, double bound,
                 double duration) {
  const double reach = model.arena->radius - radius;  // of the centre from the axis
  const Vec3 p = ball.position - model.arena->center;
  const double pull = horizontal(model.field->gravity) + bound;
  const double fastest = horizontal(ball.velocity) + pull * duration;
  // (R^2 - rho^2)'' = -2 (v^2 + p.a)
  return {reach * reach - p.x() * p.x() - p.z() * p.z(),
          2 * withoutNoise(p.x() * ball.velocity.x() + p.z() * ball.velocity.z(),
                           reach * length(ball.velocity)),
          2 * (fastest * fastest + reach * pull), 2 * reach * pull};
}

double closedAtWall(const Arena& arena, double radius) {
  return 2 * (arena.radius - radius) * kClosedGap * (horizontal(arena.center) + arena.radius);
}

GapNow gapOfBalls(const BallState& a, double radiusA, const BallState& b, double radiusB,
                  double bound) {
  const Vec3 d = b.position - a.position;
  const double distance = length(d);
  // Coincident centres: as deep as can be, and nowhere to go.
  if (distance == 0) return {-radiusA - radiusB, 0, 1, 1};
  const double speeds = length(a.velocity) + length(b.velocity);
  return {distance - radiusA - radiusB,
          withoutNoise(dot(a.velocity - b.velocity, d) / distance, speeds), bound,
          bound + speeds * speeds / distance};
}

double closedOfBalls(const BallState& a, double radiusA, const BallState& b, double radiusB) {
  return kClosedGap * (length(a.position) + length(b.position) + radiusA + radiusB);
}

/// A bound that holds from a first look on, up to one horizon.
class LastingBound {
 public:
  template <class Compute>
  double until(double horizon, Compute compute) {
    if (horizon != horizon_) {
      bound_ = compute();
      horizon_ = horizon;
    }
    return bound_;
  }

 private:
  double horizon_ = -1;  // s; none yet
  double bound_ = 0;
};

Encounter encounterWithGround(const PathModel& model, const Path& ball, double from, double until) {
  LastingBound bound;
  const auto gapAt = [&](double t, double end) {
    const BallState now = stateAt(model, ball, t);
    return gapToGround(model, now, ball.radius, bound.until(end, [&] {
      return accelerationBound(model, ball, now, t, end - t);
    }));
  };
  const double closed = closedAtGround(*model.arena, ball.state, ball.radius);
  return followFromContact(gapAt, closed, model.field->stretch, from, until);
}

Encounter encounterWithWall(const PathModel& model, const Path& ball, double from, double until) {
  LastingBound bound;
  const auto gapAt = [&](double t, double end) {
    const BallState now = stateAt(model, ball, t);
    const double pull =
        bound.until(end, [&] { return accelerationBound(model, ball, now, t, end - t); });
    return gapToWall(model, now, ball.radius, pull, end - t);
  };
  const double closed = closedAtWall(*model.arena, ball.radius);
  return followFromContact(gapAt, closed, model.field->stretch, from, until);
}

/// What no gap is less than falls ever faster: it is least at one of the ends.
bool staysOpen(const GapNow& now, double closed, double duration) {
  return now.gap > closed && now.gap > (now.closing + now.growth * duration / 2) * duration;
}

/// m, of its coordinates; no less, without a root.
double sizeBound(const BallState& ball, double radius) {
  const Vec3& at = ball.position;
  return std::abs(at.x()) + std::abs(at.y()) + std::abs(at.z()) + radius;
}

/// Where a ball in flight would be at time t if only gravity pulled it.
BallState ballistic(const PathModel& model, const Path& path, double t) {
  const double after = t - path.start;
  BallState ball = path.state;
  ball.position += after * ball.velocity + (after * after / 2) * model.field->gravity;
  ball.velocity += after * model.field->gravity;
  return ball;
}

}  // namespace

Encounter encounterOfBalls(const PathModel& model, const Path& a, const Path& b, double from,
                           double until) {
  LastingBound bound;
  const auto gapAt = [&](double t, double end) {
    const std::pair now = statesAt(model, a, b, t);
    return gapOfBalls(now.first, a.radius, now.second, b.radius, bound.until(end, [&] {
      return approachBound(model, a, now.first, b, now.second, t, end - t);
    }));
  };
  const double closed = closedOfBalls(a.state, a.radius, b.state, b.radius);
  return follow(gapAt, closed, model.field->stretch, from, until);
}

Encounter encounterWithArena(const PathModel& model, const Path& ball, std::uint32_t partner,
                             double from, double until) {
  if (ball.motion != Motion::Flying && (ball.surface == partner || ball.surface == kCorner))
    return {};
  return partner == kGround ? encounterWithGround(model, ball, from, until)
                            : encounterWithWall(model, ball, from, until);
}

// From one parabola to the other it is a straight line; each ball is at most pull t^2 / 2 away from
// its own.
bool stayApart(const PathModel& model, const Flyer& a, const Flyer& b, double from, double until) {
  const BallState nowA = ballistic(model, *a.path, from);
  const BallState nowB = ballistic(model, *b.path, from);
  const Vec3 across = nowB.position - nowA.position;
  const Vec3 passing = nowB.velocity - nowA.velocity;
  const double speed2 = squaredLength(passing);
  const double nearest =
      speed2 > 0 ? std::clamp(-dot(across, passing) / speed2, 0.0, until - from) : 0;
  const double lastA = until - a.path->start;
  const double lastB = until - b.path->start;
  const double bound =
      a.path->radius + b.path->radius + (a.pull * lastA * lastA + b.pull * lastB * lastB) / 2 +
      kClosedGap * (sizeBound(nowA, a.path->radius) + sizeBound(nowB, b.path->radius));
  return squaredLength(across + nearest * passing) > bound * bound;
}

double leastGap(const PathModel& model, const Flyer& ball, double t, const Vec3& position,
                double radius) {
  const Path& path = *ball.path;
  const double after = t - path.start;
  const double distance = length(ballistic(model, path, t).position - position);
  return distance - path.radius - radius - ball.pull * after * after / 2;
}

bool staysOff(const PathModel& model, const Flyer& ball, std::uint32_t partner, double until) {
  const Path& path = *ball.path;
  const double duration = until - path.start;
  // What is held by a surface from the start on touches it within kHeldGap.
  constexpr double kNear = kHeldGap / kClosedGap;
  if (partner == kGround)
    return staysOpen(gapToGround(model, path.state, path.radius, ball.pull),
                     kNear * closedAtGround(*model.arena, path.state, path.radius), duration);
  return staysOpen(gapToWall(model, path.state, path.radius, ball.pull, duration),
                   kNear * closedAtWall(*model.arena, path.radius), duration);
}

}  // namespace wells
