// The balls that somebody other than the engine has changed since the last step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace wells {

/// Each ball is listed once, in the order of the first change.
class ChangedBalls {
 public:
  void add(std::size_t ball) {
    if (ball >= isListed_.size()) isListed_.resize(ball + 1, 0);
    if (isListed_[ball] != 0) return;
    isListed_[ball] = 1;
    list_.push_back(static_cast<std::uint32_t>(ball));
  }

  void clear() {
    for (const std::uint32_t ball : list_) isListed_[ball] = 0;
    list_.clear();
  }

  const std::vector<std::uint32_t>& list() const { return list_; }

 private:
  std::vector<std::uint32_t> list_;
  std::vector<std::uint8_t> isListed_;  // by ball; those beyond the end are not
};

}  // namespace wells
