#include "scenes/scatter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "math/random.h"

namespace wells {
namespace {

// Random sequential addition of discs jams at a covered fraction of 0.547; up to this one a place
// is found within a few tries.
constexpr double kCoveredFraction = 0.35;
constexpr double kGapAboveGround = 0.1;  // of the radius
constexpr double kLayerSpacing = 2.1;    // of the radius

/// Finds out whether a disc is free by looking at the cells around it only.
class DiscGrid {
 public:
  // Cells are at least as wide as a disc, and no more than kMostCells a side.
  DiscGrid(double halfWidth, double diameter)
      : halfWidth_(halfWidth),
        diameter_(diameter),
        cellWidth_(std::max(diameter, 2 * halfWidth / kMostCells)),
        side_(static_cast<std::size_t>(2 * halfWidth / cellWidth_) + 1),
        cells_(side_ * side_) {}

  bool placeIfFree(double x, double z) {
    const std::size_t column = cell(x);
    const std::size_t row = cell(z);
    for (std::size_t i = row - std::min<std::size_t>(row, 1); i <= std::min(row + 1, side_ - 1);
         ++i)
      for (std::size_t j = column - std::min<std::size_t>(column, 1);
           j <= std::min(column + 1, side_ - 1); ++j)
        for (const auto& [px, pz] : cells_[i * side_ + j])
          if ((px - x) * (px - x) + (pz - z) * (pz - z) < diameter_ * diameter_) return false;
    cells_[row * side_ + column].push_back({x, z});
    return true;
  }

 private:
  static constexpr double kMostCells = 1000;
  std::size_t cell(double coordinate) const {
    return std::min(side_ - 1, static_cast<std::size_t>((coordinate + halfWidth_) / cellWidth_));
  }
  struct Disc {
    double x, z;
  };
  double halfWidth_;
  double diameter_;
  double cellWidth_;
  std::size_t side_;
  std::vector<std::vector<Disc>> cells_;
};

}  // namespace

void scatterBalls(World& world, std::size_t count, double radius, double mass, std::uint64_t seed) {
  const double reach = world.arena.radius - 1.05 * radius;  // of a centre from the axis
  if (reach <= 0)
    throw std::invalid_argument(
        fmt::format("a ball of radius {} m does not fit into an arena of radius {} m", radius,
                    world.arena.radius));
  const double discs = kCoveredFraction * (reach / radius) * (reach / radius);
  const auto perLayer =
      static_cast<std::size_t>(std::clamp(discs, 1.0, std::max(1.0, static_cast<double>(count))));
  Random random(seed);
  world.balls.reserve(world.balls.size() + count);
  for (std::size_t layer = 0, placed = 0; placed < count; ++layer) {
    DiscGrid grid(reach, 2.02 * radius);
    const double height =
        radius * (1 + kGapAboveGround + kLayerSpacing * static_cast<double>(layer));
    const std::size_t end = std::min(count, placed + perLayer);
    while (placed < end) {
      const double x = random.uniform(-reach, reach);
      const double z = random.uniform(-reach, reach);
      if (x * x + z * z > reach * reach || !grid.placeIfFree(x, z)) continue;
      world.balls.add({.position = world.arena.center + Vec3{x, height, z}}, radius, mass);
      ++placed;
    }
  }
}

}  // namespace wells
