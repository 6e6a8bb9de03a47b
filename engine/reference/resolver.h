// The manifold resolver of the custom integrator: one contact at a time, worst first. Impulses
// along the normal only; no friction, no rotation. (After Millington, Game Physics Engine
// Development, chapter 7, which the report follows.)
#pragma once

#include <cstdint>
#include <vector>

#include "reference/manifold.h"
#include "reference/most_negative.h"
#include "state/balls.h"

namespace wells {

struct ResolverInput {
  double elasticity = 0.8;           // e, 0 .. 1
  Vec3 acceleration = Vec3::Zero();  // m/s^2, the constant a of every ball
  double h = 1.0 / 60;               // s
  std::int64_t maxIterations = 0;    // at most so many contacts are taken
};

class Resolver {
 public:
  /// Changes velocities and positions of `balls`, and penetrations of `manifold` with them. Returns
  /// how many contacts it took; when that is maxIterations, some may be left for the next step.
  /// O((iterations x contacts of a ball + contacts) x log contacts).
  std::int64_t resolve(Manifold& manifold, Balls& balls, const ResolverInput& input);

 private:
  void resolvePenetration(Manifold& manifold, const ManifoldContact& contact, Balls& balls) const;
  void index(const Manifold& manifold, std::size_t ballCount);
  void moved(Manifold& manifold, std::uint32_t ball, const Vec3& by) const;
  void refresh(const Manifold& manifold, const Balls& balls, std::uint32_t ball);

  // The contacts of ball b are contactsOf_[start_[b]] .. contactsOf_[start_[b + 1]].
  std::vector<std::uint32_t> start_;
  std::vector<std::uint32_t> contactsOf_;
  std::vector<double> urgencies_;
  MostNegative order_;
};

}  // namespace wells
