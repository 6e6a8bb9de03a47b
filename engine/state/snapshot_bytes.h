// Values to bytes and back, little-endian, for snapshot.cpp. Writer and reader have the same calls,
// so that one list of fields serves both and none can be forgotten on one side.
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "math/vector.h"
#include "state/snapshot.h"

namespace wells {

inline void requireChoice(std::string_view name, std::int64_t number, std::size_t count) {
  if (number >= 0 && number < static_cast<std::int64_t>(count)) return;
  throw SnapshotError(fmt::format("{} = {}; allowed: 0 to {}", name, number, count - 1));
}

class SnapshotWriter {
 public:
  std::string bytes;

  template <class Unsigned>
  void word(Unsigned value) {
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
      bytes += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
  }

  void field(std::uint32_t value) { word(value); }
  void field(std::int32_t value) { word(static_cast<std::uint32_t>(value)); }
  void field(std::int64_t value) { word(static_cast<std::uint64_t>(value)); }
  void field(std::uint64_t value) { word(value); }
  void field(double value) { word(std::bit_cast<std::uint64_t>(value)); }
  void field(const Vec3& v) {
    for (const double x : {v.x(), v.y(), v.z()}) field(x);
  }
  void field(const std::string& text) {
    word<std::uint64_t>(text.size());
    bytes += text;
  }

  /// An enumeration, bool or id with values 0 .. count - 1, count <= 256.
  template <class Choice>
  void choice(std::string_view name, Choice value, std::size_t count) {
    requireChoice(name, static_cast<std::int64_t>(value), count);
    word(static_cast<std::uint8_t>(value));
  }

  /// Items of at least `itemSize` bytes each.
  template <class Item, class Transfer>
  void list(std::string_view, const std::vector<Item>& items, std::size_t, Transfer transfer) {
    word<std::uint64_t>(items.size());
    for (const Item& item : items) transfer(item);
  }
};

class SnapshotReader {
 public:
  explicit SnapshotReader(std::string_view bytes) : left_(bytes) {}

  std::size_t left() const { return left_.size(); }

  template <class Unsigned>
  Unsigned word() {
    std::uint64_t value = 0;
    const std::string_view from = take(sizeof(Unsigned));
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(from[i])) << (8 * i);
    return static_cast<Unsigned>(value);
  }

  void field(std::uint32_t& value) { value = word<std::uint32_t>(); }
  void field(std::int32_t& value) { value = static_cast<std::int32_t>(word<std::uint32_t>()); }
  void field(std::int64_t& value) { value = static_cast<std::int64_t>(word<std::uint64_t>()); }
  void field(std::uint64_t& value) { value = word<std::uint64_t>(); }
  void field(double& value) { value = std::bit_cast<double>(word<std::uint64_t>()); }
  void field(Vec3& v) {
    for (int k = 0; k < 3; ++k) field(v[k]);
  }
  void field(std::string& text) { text = take(count("a text", 1)); }

  template <class Choice>
  void choice(std::string_view name, Choice& value, std::size_t count) {
    const auto number = word<std::uint8_t>();
    requireChoice(name, number, count);
    value = static_cast<Choice>(number);
  }

  template <class Item, class Transfer>
  void list(std::string_view name, std::vector<Item>& items, std::size_t itemSize,
            Transfer transfer) {
    items.resize(count(name, itemSize));
    for (Item& item : items) transfer(item);
  }

 private:
  std::string_view take(std::size_t size) {
    if (size > left_.size()) throw SnapshotError("a field lies beyond the end");
    const std::string_view taken = left_.substr(0, size);
    left_.remove_prefix(size);
    return taken;
  }

  // Checked before anything is allocated for the items.
  std::size_t count(std::string_view name, std::size_t itemSize) {
    const auto items = word<std::uint64_t>();
    const std::size_t most = left_.size() / itemSize;
    if (items > most) {
      throw SnapshotError(fmt::format(
          "length of {} = {}; allowed: at most {}, for which there are bytes", name, items, most));
    }
    return static_cast<std::size_t>(items);
  }

  std::string_view left_;
};

}  // namespace wells
