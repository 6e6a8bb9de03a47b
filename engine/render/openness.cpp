#include "render/openness.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wells {
namespace {

/// The height of the heap in each square cell: the top of its highest ball, but no higher than its
/// balls would reach on top of each other, so that a lone flying ball is no tower.
class HeightMap {
 public:
  HeightMap(const View& view, double cell)
      : cell_(cell),
        size_(static_cast<int>(2 * view.arena.radius / cell) + 1),
        heights_(std::size_t(size_) * std::size_t(size_)) {
    std::vector<float> stacked(heights_.size());
    const bool shared = view.radius.size() == 1;
    for (std::size_t i = 0; i < view.position.size(); ++i) {
      const Vec3 at = view.position[i] - view.arena.center;
      const double radius = view.radius[shared ? 0 : i];
      const int column = cellOf(at.x()), row = cellOf(at.z());
      if (!inside(column, row)) continue;
      const std::size_t cellIndex = std::size_t(row * size_ + column);
      heights_[cellIndex] = std::max(heights_[cellIndex], static_cast<float>(at.y() + radius));
      stacked[cellIndex] += static_cast<float>(2 * radius);
    }
    for (std::size_t i = 0; i < heights_.size(); ++i)
      heights_[i] = std::min(heights_[i], stacked[i]);
  }

  int cellOf(double coordinate) const {
    const double cell = std::floor(coordinate / cell_ + 0.5 * size_);
    return static_cast<int>(std::clamp(cell, -1.0, static_cast<double>(size_)));
  }

  /// m; 0 outside the map.
  double at(int column, int row) const {
    return inside(column, row) ? heights_[std::size_t(row * size_ + column)] : 0.0;
  }

 private:
  bool inside(int column, int row) const {
    return column >= 0 && row >= 0 && column < size_ && row < size_;
  }

  double cell_;
  int size_;
  std::vector<float> heights_;
};

struct Direction {
  int x, z;
};
constexpr std::array<Direction, 8> kDirections{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
constexpr std::array<int, 4> kReach{1, 2, 4, 7};  // cells

/// Never all dark: an owner's colour must show at the bottom of a heap, too.
std::uint8_t toByte(double share) {
  return static_cast<std::uint8_t>(std::lround(255 * std::max(0.35, share)));
}

}  // namespace

void findOpenness(const View& view, const Vec3& light, std::vector<Openness>& out) {
  out.assign(view.position.size(), {});
  if (view.position.empty()) return;
  const double largest = *std::max_element(view.radius.begin(), view.radius.end());
  constexpr int kMaxCells = 1024;  // a side
  const double cell = std::max(2 * largest, 2 * view.arena.radius / kMaxCells);
  const HeightMap map(view, cell);
  const double lightAcross = std::hypot(light.x(), light.z());
  const double lightSlope = light.y() / lightAcross;

  for (std::size_t i = 0; i < out.size(); ++i) {
    const Vec3 at = view.position[i] - view.arena.center;
    const int column = map.cellOf(at.x()), row = map.cellOf(at.z());
    double sky = 0, key = 0, keyWeight = 0;
    for (const Direction direction : kDirections) {
      const double step = cell * std::hypot(direction.x, direction.z);
      double slope = 0;  // of the horizon in this direction
      for (const int reach : kReach) {
        const double height = map.at(column + reach * direction.x, row + reach * direction.z);
        slope = std::max(slope, (height - at.y()) / (reach * step));
      }
      sky += 1 - slope / std::sqrt(1 + slope * slope);  // 1 - sine of the horizon's elevation

      const double towards = (direction.x * light.x() + direction.z * light.z()) /
                             (lightAcross * std::hypot(direction.x, direction.z));
      if (towards < 0.5) continue;
      key += towards * std::clamp(0.6 + 1.2 * (lightSlope - slope), 0.0, 1.0);
      keyWeight += towards;
    }
    // Under others: how deep below the top of its own cell.
    const double depth = std::max(0.0, map.at(column, row) - at.y() - largest) / (2 * largest);
    const double below = 1 / (1 + 0.7 * depth);
    out[i] = {toByte(below * sky / kDirections.size()), toByte(below * key / keyWeight)};
  }
}

}  // namespace wells
