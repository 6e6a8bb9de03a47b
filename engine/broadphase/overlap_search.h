// The inner loops of CellGrid's search, in the processor's vector instructions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace wells {

/// What boxes hold. Spheres are as wide as their boxes, which are cubes; only the spheres count.
enum class BoxContent : std::uint8_t { Anything, Spheres };

/// Half-open. A slot is the place of a box among the sorted ones.
struct SlotRange {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// By slot; all have kRoom more elements than there are slots, so that whole vectors can be read.
struct SortedBoxes {
  static constexpr std::size_t kRoom = 8;
  BoxContent content = BoxContent::Anything;
  std::vector<float> x, y, z;              // m, of the centre, from the grid's anchor
  std::vector<float> halfX, halfY, halfZ;  // m; of spheres, halfX is the radius, others are empty
  // m, of spheres: a radius that is too small by as much as rounding may hide, where halfX is too
  // large by that. Those that overlap with these do so for certain. May be negative.
  std::vector<float> certain;
};

/// With whom the boxes of a cell are to be compared.
struct CellSearch {
  SlotRange slots;                    // each
  std::uint32_t end = 0;              // with those after it up to here
  std::array<SlotRange, 9> others{};  // and with all of these
  std::size_t otherCount = 0;
};

/// Lists those that overlap: of slot search.slots.begin + n up to partners[ends[n]], from where
/// those of the one before end, or from `from`. `partners` has room for all and kRoom more.
/// Sets areCertain[n] to 0 if one of them may not overlap, else to 1.
void findPartners(const SortedBoxes& boxes, const CellSearch& search, std::uint32_t from,
                  std::uint32_t* ends, std::uint8_t* areCertain, std::uint32_t* partners);

/// Lists those of a range that overlap the box from low to high (m, from the anchor). Returns how
/// many; `found` has room for all and kRoom more.
std::uint32_t findWithin(const SortedBoxes& boxes, const std::array<float, 3>& low,
                         const std::array<float, 3>& high, SlotRange range, std::uint32_t* found);

}  // namespace wells
