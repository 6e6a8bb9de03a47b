// What the wall gave in a step, from the balls' momenta before and after it: what balls give each
// other cancels among neighbours. For horizontal motion without forces; needs nothing that the
// engine says.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "state/balls.h"

namespace wells {

/// The sum (N s) of the sizes of the wall's impulses on the balls in the last `dt` seconds. Balls
/// that were hit are put into groups of those that can have met; the change of a group's momentum
/// is the wall's. (Two hits of the wall in one group add up as vectors: their places are so close
/// that the normals are the same but for a few degrees.)
inline double wallImpulses(const Balls& before, const Balls& after, double dt) {
  std::vector<std::size_t> hit;
  double fastest = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    fastest = std::max({fastest, length(before.velocity[i]), length(after.velocity[i])});
    if (before.velocity[i] != after.velocity[i]) hit.push_back(i);
  }
  std::vector<std::size_t> group(hit.size());  // of each: the number of one of its members
  std::iota(group.begin(), group.end(), 0);
  const auto root = [&](std::size_t k) {
    while (group[k] != k) k = group[k];
    return k;
  };
  for (std::size_t k = 0; k < hit.size(); ++k)
    for (std::size_t l = 0; l < k; ++l) {
      const std::size_t i = hit[k], j = hit[l];
      const double reach = after.radius[i] + after.radius[j] + 2 * fastest * dt;
      if (squaredLength(after.position[i] - after.position[j]) <= reach * reach)
        group[root(k)] = root(l);
    }
  std::vector<Vec3> given(hit.size(), Vec3::Zero());  // by group
  for (std::size_t k = 0; k < hit.size(); ++k)
    given[root(k)] += after.mass[hit[k]] * (after.velocity[hit[k]] - before.velocity[hit[k]]);
  double sum = 0;
  for (const Vec3& impulse : given) sum += length(impulse);
  return sum;
}

}  // namespace wells
