#include "world/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "math/hash.h"

namespace wells {
namespace {

void addArenaOverlaps(const World& world, std::uint32_t i, Measures& sum) {
  const Vec3 d = world.balls.position[i] - world.arena.center;
  const double radius = world.balls.radius[i];
  const double fromAxis = std::sqrt(d.x() * d.x() + d.z() * d.z());
  const double belowGround = radius - d.y();
  const double beyondWall = fromAxis + radius - world.arena.radius;
  if (belowGround > 0) {
    ++sum.groundContacts;
    sum.squaredOverlaps += belowGround * belowGround;
  }
  if (beyondWall > 0) {
    ++sum.wallContacts;
    sum.squaredOverlaps += beyondWall * beyondWall;
  }
  if (d.y() < 0 || fromAxis > world.arena.radius) ++sum.escaped;
  sum.groundOverlap = std::max(sum.groundOverlap, belowGround);
  sum.wallOverlap = std::max(sum.wallOverlap, beyondWall);
}

/// Sort and sweep along x. On purpose not the broadphase that the step uses: a pair that it missed
/// shows here.
void addBallOverlaps(const Balls& balls, std::vector<std::uint32_t> sorted, Measures& sum) {
  std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t a, std::uint32_t b) {
    return balls.position[a].x() - balls.radius[a] < balls.position[b].x() - balls.radius[b];
  });
  for (std::size_t n = 0; n < sorted.size(); ++n) {
    const std::uint32_t a = sorted[n];
    const double end = balls.position[a].x() + balls.radius[a];
    for (std::size_t m = n + 1; m < sorted.size(); ++m) {
      const std::uint32_t b = sorted[m];
      if (balls.position[b].x() - balls.radius[b] > end) break;
      const double touching = balls.radius[a] + balls.radius[b];
      const double squared = squaredLength(balls.position[a] - balls.position[b]);
      if (squared >= touching * touching) continue;
      const double overlap = touching - std::sqrt(squared);
      ++sum.ballContacts;
      sum.ballOverlap = std::max(sum.ballOverlap, overlap);
      sum.squaredOverlaps += overlap * overlap;
    }
  }
}

}  // namespace

double kineticEnergy(const Balls& balls, std::size_t i) {
  const double inertia = kInertiaFactor * balls.mass[i] * balls.radius[i] * balls.radius[i];
  return 0.5 * (balls.mass[i] * squaredLength(balls.velocity[i]) +
                inertia * squaredLength(balls.spin[i]));
}

double kineticEnergy(const Balls& balls) {
  double sum = 0;
  for (std::size_t i = 0; i < balls.size(); ++i)
    if (isFinite(balls.state(i))) sum += kineticEnergy(balls, i);
  return sum;
}

void addMechanics(const World& world, const Field& field, double t, std::size_t i, Mechanics& sum) {
  const Balls& balls = world.balls;
  const double mass = balls.mass[i];
  const Vec3& v = balls.velocity[i];
  const Vec3 p = mass * v;
  const double inertia = kInertiaFactor * mass * balls.radius[i] * balls.radius[i];
  sum.kineticEnergy += kineticEnergy(balls, i);
  sum.potentialEnergy += mass * potentialAt(field, balls.position[i], world.arena.center, t);
  sum.momentum += p;
  sum.angularMomentum += cross(balls.position[i] - world.arena.center, p) + inertia * balls.spin[i];
}

double Measures::worstOverlap() const {
  return std::max({ballOverlap, groundOverlap, wallOverlap});
}

Measures measure(const World& world, std::span<const std::uint32_t> balls) {
  Measures sum;
  const Field field = fieldOf(world);
  std::vector<std::uint32_t> finite;
  finite.reserve(balls.size());
  for (const std::uint32_t i : balls) {
    if (!isFinite(world.balls.state(i))) {
      ++sum.escaped;
      continue;
    }
    finite.push_back(i);
    addMechanics(world, field, 0, i, sum);
    addArenaOverlaps(world, i, sum);
  }
  addBallOverlaps(world.balls, std::move(finite), sum);
  return sum;
}

Measures measure(const World& world) {
  std::vector<std::uint32_t> all(world.balls.size());
  std::iota(all.begin(), all.end(), 0u);
  return measure(world, all);
}

std::uint64_t stateHash(const World& world) {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(world.step));
  for (std::size_t i = 0; i < world.balls.size(); ++i) {
    hash.add(world.balls.position[i]);
    hash.add(world.balls.velocity[i]);
    hash.add(world.balls.spin[i]);
  }
  return hash.value();
}

std::string hashText(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

}  // namespace wells
