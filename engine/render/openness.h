// How much light reaches each ball past the others: what gives a heap its shape in the picture.
// Coarse on purpose: one number a ball for the sky and one for the key light.
#pragma once

#include <cstdint>
#include <vector>

#include "render/view.h"

namespace wells {

struct Openness {
  std::uint8_t sky = 255;  // share of the sky that is not hidden, 255: all
  std::uint8_t key = 255;  // share of the key light that arrives
};

/// One for each ball of `view`. Looks at the horizon in eight directions on a height map of the
/// balls, about 1 ms for 10,000 balls. `light` points towards the key light.
void findOpenness(const View& view, const Vec3& light, std::vector<Openness>& out);

}  // namespace wells
