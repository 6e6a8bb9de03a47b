// Gives equal things equal numbers, 1, 2, 3 ... in the order in which they come, and keeps the
// things themselves: nothing is told apart by its hash alone.
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

namespace wells {

/// Random access to gigabytes spends half its time on finding small pages.
inline void adviseHugePages(void* memory, std::size_t bytes) {
  constexpr std::uintptr_t kPage = std::uintptr_t{1} << 21;
  const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + kPage - 1) / kPage * kPage;
  const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / kPage * kPage;
  if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

/// Grows without moving what is in it.
template <class T>
class Chunks {
 public:
  std::size_t size() const { return size_; }
  T& operator[](std::size_t i) { return chunks_[i >> kShift][i & kMask]; }
  const T& operator[](std::size_t i) const { return chunks_[i >> kShift][i & kMask]; }
  void push_back(const T& item) {
    if (size_ >> kShift == chunks_.size()) addChunk();
    (*this)[size_++] = item;
  }
  /// Room for `count` items in one piece.
  T* extend(std::size_t count) {
    const std::size_t left = (chunks_.size() << kShift) - size_;
    if (left < count) {
      size_ = chunks_.size() << kShift;
      addChunk();
    }
    T* const place = &(*this)[size_];
    size_ += count;
    return place;
  }
  std::size_t bytes() const { return (chunks_.size() << kShift) * sizeof(T); }

 private:
  void addChunk() {
    chunks_.push_back(std::make_unique_for_overwrite<T[]>(kMask + 1));
    adviseHugePages(chunks_.back().get(), (kMask + 1) * sizeof(T));
  }
  static constexpr std::size_t kShift = 18;
  static constexpr std::size_t kMask = (std::size_t{1} << kShift) - 1;
  std::vector<std::unique_ptr<T[]>> chunks_;
  std::size_t size_ = 0;
};

/// Where the things with a hash are: open addressing, placed by the hash's upper half, which is
/// kept.
class HashIndex {
 public:
  /// The number of the thing with this hash for which isIt(number) holds; `next` if there is none,
  /// which is then entered.
  template <class IsIt>
  std::uint32_t findOrAdd(std::uint64_t hash, std::uint32_t next, const IsIt& isIt) {
    if (count_ * 10 >= slots_.size() * 7) grow();
    const std::uint64_t tag = hash >> 32;
    for (std::size_t i = place(tag);; i = (i + 1) & (slots_.size() - 1)) {
      const std::uint64_t slot = slots_[i];
      if (slot == 0) {
        slots_[i] = tag << 32 | next;
        ++count_;
        return next;
      }
      const auto number = static_cast<std::uint32_t>(slot);
      if (slot >> 32 == tag && isIt(number)) return number;
    }
  }
  void prefetch(std::uint64_t hash) const { __builtin_prefetch(&slots_[place(hash >> 32)]); }
  /// A number that findOrAdd() will probably compare with; 0: none.
  std::uint32_t guess(std::uint64_t hash) const {
    const std::uint64_t slot = slots_[place(hash >> 32)];
    return slot >> 32 == hash >> 32 ? static_cast<std::uint32_t>(slot) : 0;
  }
  std::size_t bytes() const { return slots_.size() * sizeof(std::uint64_t); }

 private:
  std::size_t place(std::uint64_t tag) const {
    return tag >> (32 - std::countr_zero(slots_.size()));
  }
  void grow() {
    const std::size_t size = slots_.size() * 2;
    if (size > std::size_t{1} << 32) throw std::length_error("search: too many states");
    std::vector<std::uint64_t> old;
    old.reserve(size);
    adviseHugePages(old.data(), size * sizeof(std::uint64_t));
    old.resize(size);
    old.swap(slots_);
    for (const std::uint64_t slot : old) {
      if (slot == 0) continue;
      std::size_t i = place(slot >> 32);
      while (slots_[i] != 0) i = (i + 1) & (slots_.size() - 1);
      slots_[i] = slot;
    }
  }
  std::vector<std::uint64_t> slots_ = std::vector<std::uint64_t>(1024);
  std::size_t count_ = 0;
};

__extension__ using TwoWords = unsigned __int128;

inline std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  const TwoWords product =
      static_cast<TwoWords>(a ^ 0x9e3779b97f4a7c15u) * (b ^ 0xe7037ed1a0b428dbu);
  return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
}

/// Of things without padding.
template <class T>
class Numbering {
  static_assert(std::has_unique_object_representations_v<T> && sizeof(T) % 4 == 0);

 public:
  static std::uint64_t hashOf(const T& item) {
    std::uint64_t hash = sizeof(T);
    std::uint32_t words[sizeof(T) / 4];
    std::memcpy(words, &item, sizeof(T));
    for (const std::uint32_t word : words) hash = mix(hash, word);
    return hash;
  }
  std::uint32_t number(const T& item) { return number(item, hashOf(item)); }
  std::uint32_t number(const T& item, std::uint64_t hash) {
    const auto next = static_cast<std::uint32_t>(items_.size() + 1);
    const std::uint32_t number =
        index_.findOrAdd(hash, next, [&](std::uint32_t n) { return items_[n - 1] == item; });
    if (number == next) items_.push_back(item);
    return number;
  }
  // Hints for a number() that comes later: the second a while after the first, both before it.
  void prefetch(std::uint64_t hash) const { index_.prefetch(hash); }
  void prefetchItem(std::uint64_t hash) const {
    if (const std::uint32_t number = index_.guess(hash)) __builtin_prefetch(&(*this)[number]);
  }
  const T& operator[](std::uint32_t number) const { return items_[number - 1]; }
  std::size_t size() const { return items_.size(); }
  std::size_t bytes() const { return items_.bytes() + index_.bytes(); }

 private:
  Chunks<T> items_;
  HashIndex index_;
};

/// Of rows of words, of any length below 2^16.
class RowNumbering {
 public:
  using Word = std::uint16_t;

  std::uint32_t number(std::span<const Word> row) {
    std::uint64_t hash = row.size();
    for (const Word word : row) hash = mix(hash, word);
    const auto next = static_cast<std::uint32_t>(starts_.size() + 1);
    const std::uint32_t number = index_.findOrAdd(hash, next, [&](std::uint32_t n) {
      const auto other = (*this)[n];
      return other.size() == row.size() && std::equal(row.begin(), row.end(), other.begin());
    });
    if (number == next) {
      Word* const place = words_.extend(row.size() + 1);
      *place = static_cast<Word>(row.size());
      std::copy(row.begin(), row.end(), place + 1);
      starts_.push_back(words_.size() - row.size() - 1);
    }
    return number;
  }
  std::span<const Word> operator[](std::uint32_t number) const {
    const Word* const place = &words_[starts_[number - 1]];
    return {place + 1, *place};
  }
  std::size_t size() const { return starts_.size(); }
  std::size_t bytes() const { return words_.bytes() + starts_.bytes() + index_.bytes(); }

 private:
  Chunks<Word> words_;
  Chunks<std::size_t> starts_;
  HashIndex index_;
};

}  // namespace wells
