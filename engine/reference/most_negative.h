// The first of the smallest among n numbers, of those below zero: a tournament tree, so that
// changing one number costs O(log n) where a scan for the next choice would cost O(n).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace wells {

class MostNegative {
 public:
  /// What first() returns when no number is below zero.
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// Starts over with `values`. A NaN counts as not below zero.
  void assign(std::span<const double> values) {
    leaves_ = std::bit_ceil(values.size());
    key_.assign(leaves_, 0.0);
    winner_.resize(2 * leaves_);
    for (std::size_t i = 0; i < values.size(); ++i) key_[i] = keyOf(values[i]);
    for (std::size_t i = 0; i < leaves_; ++i) winner_[leaves_ + i] = static_cast<std::uint32_t>(i);
    for (std::size_t node = leaves_ - 1; node > 0; --node) play(node);
  }

  /// Replaces value i.
  void set(std::size_t i, double value) {
    const double key = keyOf(value);
    if (key == key_[i]) return;
    key_[i] = key;
    for (std::size_t node = (leaves_ + i) / 2; node > 0; node /= 2) {
      const std::uint32_t before = winner_[node];
      play(node);
      // Neither was nor is it this number that wins here, so nothing changes further up.
      if (winner_[node] == before && before != i) return;
    }
  }

  /// The index of the smallest value below zero, the lowest index of equal ones; or kNone.
  std::uint32_t first() const {
    const std::uint32_t best = winner_[1];
    return key_[best] < 0 ? best : kNone;
  }

 private:
  static double keyOf(double value) { return value < 0 ? value : 0; }

  void play(std::size_t node) {
    const std::uint32_t left = winner_[2 * node];
    const std::uint32_t right = winner_[2 * node + 1];
    winner_[node] = key_[right] < key_[left] ? right : left;
  }

  std::size_t leaves_ = 1;
  std::vector<double> key_ = {0};
  std::vector<std::uint32_t> winner_ = {0, 0};  // by node; node 1 is the root, leaves follow
};

}  // namespace wells
