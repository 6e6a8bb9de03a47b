// A 64-bit hash of plain data, for state hashes and the comparison of worlds. Not cryptographic.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

#include "math/vector.h"

namespace wells {

/// FNV-1a over 64-bit words, finished with the splitmix64 mixer. Order matters; bits matter (0.0
/// and -0.0 differ).
class Hash {
 public:
  void add(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001b3u; }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(const Vec3& v) {
    add(v.x());
    add(v.y());
    add(v.z());
  }
  void add(std::string_view text) {
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    add(static_cast<std::uint64_t>(text.size()));
  }
  std::uint64_t value() const {
    std::uint64_t z = value_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace wells
