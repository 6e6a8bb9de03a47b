// Union-find over numbers: which hang together (Tarjan, "Efficiency of a Good But Not Linear Set
// Union Algorithm", J. ACM 22 (1975) 215).
#pragma once

#include <cstdint>
#include <vector>

namespace wells {

/// The representative of the set of i; parent[i] = i for one alone. Halves the path on the way.
inline std::uint32_t rootOf(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

}  // namespace wells
