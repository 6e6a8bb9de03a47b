// Which sequence numbers of one sender were seen, so that a message counts once however often it
// arrives. Numbers may come out of order; one that is too old to tell counts as seen.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>

namespace wells {

class SequenceWindow {
 public:
  /// How far behind the highest number a late one may be. A second of a busy peer's messages.
  static constexpr std::int64_t kSize = 2048;

  /// Marks `sequence` (>= 1) as seen. False when it was before, or may have been.
  bool accept(std::int64_t sequence) {
    if (sequence <= highest_ - kSize) return false;
    if (sequence > highest_) {
      const std::int64_t skipped = sequence - highest_;
      if (skipped >= kSize) seen_.reset();
      for (std::int64_t s = highest_ + 1; skipped < kSize && s < sequence; ++s)
        seen_.reset(slot(s));
      highest_ = sequence;
      seen_.set(slot(sequence));
      return true;
    }
    if (seen_.test(slot(sequence))) return false;
    seen_.set(slot(sequence));
    return true;
  }

  /// The highest number that was accepted; 0: none.
  std::int64_t highest() const { return highest_; }

 private:
  static std::size_t slot(std::int64_t sequence) {
    return static_cast<std::size_t>(sequence % kSize);
  }
  std::int64_t highest_ = 0;
  std::bitset<kSize> seen_;
};

}  // namespace wells
