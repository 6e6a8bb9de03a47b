// The wells of a field, in order: one by one for formulas, and in blocks with a row for each number
// for vector code that has wells, not balls, in its lanes. What depends on a well alone is computed
// once.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

#include "state/wells.h"

namespace wells {

/// m/s^2, the strongest pull of a well: at softening / sqrt(2) from it.
inline double strongestPull(const Well& well) {
  return 2 / (3 * std::sqrt(3.0)) * std::abs(well.strength) / (well.softening * well.softening);
}

/// Up to kSize wells; the rest of each row is of wells without strength.
struct WellBlock {
  static constexpr std::size_t kSize = 4;
  using Row = std::array<double, kSize>;

  std::size_t count = 0;
  Row x{}, y{}, z{};                 // m, at the start of the step
  Row vx{}, vy{}, vz{};              // m/s
  Row speed{};                       // m/s
  Row strength{};                    // m^3/s^2
  Row softeningSquared{1, 1, 1, 1};  // m^2
  Row strongest{};                   // m/s^2, strongestPull()
};

class FieldWells {
 public:
  FieldWells() = default;
  FieldWells(std::initializer_list<Well> wells) {
    for (const Well& well : wells) push_back(well);
  }

  auto begin() const { return wells_.begin(); }
  auto end() const { return wells_.end(); }
  std::size_t size() const { return wells_.size(); }
  bool empty() const { return wells_.empty(); }
  const Well& operator[](std::size_t i) const { return wells_[i]; }

  std::span<const WellBlock> blocks() const { return blocks_; }

  void clear() {
    wells_.clear();
    blocks_.clear();
  }

  void push_back(const Well& well) {
    wells_.push_back(well);
    if (blocks_.empty() || blocks_.back().count == WellBlock::kSize) blocks_.emplace_back();
    ++blocks_.back().count;
    set(wells_.size() - 1, well);
  }

  /// In the place of well i.
  void set(std::size_t i, const Well& well) {
    wells_[i] = well;
    WellBlock& block = blocks_[i / WellBlock::kSize];
    const std::size_t k = i % WellBlock::kSize;
    block.x[k] = well.position.x();
    block.y[k] = well.position.y();
    block.z[k] = well.position.z();
    block.vx[k] = well.velocity.x();
    block.vy[k] = well.velocity.y();
    block.vz[k] = well.velocity.z();
    block.speed[k] = length(well.velocity);
    block.strength[k] = well.strength;
    block.softeningSquared[k] = well.softening * well.softening;
    block.strongest[k] = strongestPull(well);
  }

 private:
  std::vector<Well> wells_;
  std::vector<WellBlock> blocks_;
};

}  // namespace wells
