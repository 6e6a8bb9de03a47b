#include "broadphase/overlap_search.h"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "broadphase/overlap_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef WELLS_BROADPHASE_SET_BITS
#define WELLS_BROADPHASE_SET_BITS
namespace wells {
namespace {

/// By number: the places of its bits that are set.
constexpr auto kSetBits = [] {
  std::array<std::array<std::uint8_t, 8>, 256> table{};
  for (std::size_t number = 0; number < table.size(); ++number) {
    std::size_t count = 0;
    for (std::uint8_t place = 0; place < 8; ++place)
      if ((number >> place & 1) != 0) table[number][count++] = place;
  }
  return table;
}();

}  // namespace
}  // namespace wells
#endif

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Rows hold few boxes: wider vectors would be empty for the most part.
using Floats = hn::CappedTag<float, SortedBoxes::kRoom>;
using Slots = hn::RebindToUnsigned<Floats>;
using Vector = hn::Vec<Floats>;
using Mask = hn::Mask<Floats>;

HWY_INLINE Vector load(const float* numbers, std::uint32_t slot) {
  return hn::LoadU(Floats(), numbers + slot);
}

HWY_INLINE Vector broadcast(float number) {
  return hn::Set(Floats(), number);
}

/// What SortedBoxes holds, without a look at where its vectors are for each box.
struct Numbers {
  explicit Numbers(const SortedBoxes& boxes)
      : x(boxes.x.data()),
        y(boxes.y.data()),
        z(boxes.z.data()),
        halfX(boxes.halfX.data()),
        certain(boxes.certain.data()),
        halfY(boxes.content == BoxContent::Spheres ? halfX : boxes.halfY.data()),
        halfZ(boxes.content == BoxContent::Spheres ? halfX : boxes.halfZ.data()) {}

  const float *x, *y, *z, *halfX, *certain, *halfY, *halfZ;
};

class SphereTest {
 public:
  HWY_INLINE SphereTest(const Numbers& all, std::uint32_t slot)
      : all_(all),
        x_(broadcast(all.x[slot])),
        y_(broadcast(all.y[slot])),
        z_(broadcast(all.z[slot])),
        radius_(broadcast(all.halfX[slot])),
        certain_(broadcast(all.certain[slot])),
        unsure_(hn::Zero(Floats())) {}

  HWY_INLINE Mask overlap(std::uint32_t slot) {
    const Vector x = hn::Sub(load(all_.x, slot), x_);
    const Vector y = hn::Sub(load(all_.y, slot), y_);
    const Vector z = hn::Sub(load(all_.z, slot), z_);
    const Vector bound = hn::Add(load(all_.halfX, slot), radius_);
    const Vector squared = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
    const Mask overlaps = hn::Le(squared, hn::Mul(bound, bound));
    // What is not a number is not certain.
    const Vector certain = hn::Max(hn::Add(load(all_.certain, slot), certain_), hn::Zero(Floats()));
    const Mask areCertain = hn::Lt(squared, hn::Mul(certain, certain));
    unsure_ = hn::Or(unsure_, hn::VecFromMask(Floats(), hn::AndNot(areCertain, overlaps)));
    return overlaps;
  }

  /// All that were found to overlap; those in what was read behind the ranges count too.
  HWY_INLINE bool areCertain() const { return hn::AllFalse(Floats(), hn::MaskFromVec(unsure_)); }

 private:
  const Numbers all_;
  const Vector x_, y_, z_, radius_, certain_;
  Vector unsure_;
};

class BoxTest {
 public:
  HWY_INLINE BoxTest(const Numbers& all, std::uint32_t slot)
      : all_(all),
        x_(broadcast(all.x[slot])),
        y_(broadcast(all.y[slot])),
        z_(broadcast(all.z[slot])),
        halfX_(broadcast(all.halfX[slot])),
        halfY_(broadcast(all.halfY[slot])),
        halfZ_(broadcast(all.halfZ[slot])) {}

  HWY_INLINE Mask overlap(std::uint32_t slot) const {
    return hn::And(hn::And(along(all_.x, all_.halfX, x_, halfX_, slot),
                           along(all_.y, all_.halfY, y_, halfY_, slot)),
                   along(all_.z, all_.halfZ, z_, halfZ_, slot));
  }

  HWY_INLINE bool areCertain() const { return false; }

 private:
  static HWY_INLINE Mask along(const float* centers, const float* halves, Vector center,
                               Vector half, std::uint32_t slot) {
    return hn::Le(hn::Abs(hn::Sub(load(centers, slot), center)), hn::Add(load(halves, slot), half));
  }

  const Numbers all_;
  const Vector x_, y_, z_, halfX_, halfY_, halfZ_;
};

/// Of a box given by its faces, which may be too far away for a centre.
class FaceTest {
 public:
  HWY_INLINE FaceTest(const Numbers& all, const std::array<float, 3>& low,
                      const std::array<float, 3>& high)
      : all_(all), low_(low), high_(high) {}

  HWY_INLINE Mask overlap(std::uint32_t slot) const {
    return hn::And(hn::And(along(all_.x, all_.halfX, 0, slot), along(all_.y, all_.halfY, 1, slot)),
                   along(all_.z, all_.halfZ, 2, slot));
  }

 private:
  HWY_INLINE Mask along(const float* centers, const float* halves, std::size_t axis,
                        std::uint32_t slot) const {
    const Vector center = load(centers, slot);
    const Vector half = load(halves, slot);
    return hn::And(hn::Le(hn::Sub(center, half), broadcast(high_[axis])),
                   hn::Ge(hn::Add(center, half), broadcast(low_[axis])));
  }

  const Numbers all_;
  const std::array<float, 3> low_, high_;
};

/// Appends those of the range that overlap; returns the end of the list. Without a branch for each,
/// because whether a neighbour overlaps cannot be foretold.
template <class Test>
HWY_INLINE std::uint32_t* append(Test& test, SlotRange range, std::uint32_t* end) {
  const Slots slots;
  const hn::Rebind<std::uint8_t, Slots> places;
  const auto lanes = static_cast<std::uint32_t>(hn::Lanes(slots));
  for (std::uint32_t slot = range.begin; slot < range.end; slot += lanes) {
    std::uint8_t overlaps = 0;
    hn::StoreMaskBits(Floats(), test.overlap(slot), &overlaps);
    const std::uint32_t left = std::min(range.end - slot, lanes);
    const std::uint32_t bits = overlaps & ((1u << left) - 1);
    // Highway's Compress copies its table to the stack at every call with AVX2 (1.0.3).
    const auto places8 = hn::LoadU(places, kSetBits[bits].data());
    hn::StoreU(hn::Add(hn::PromoteTo(slots, places8), hn::Set(slots, slot)), slots, end);
    end += std::popcount(bits);
  }
  return end;
}

template <class Test>
HWY_INLINE void findEach(const SortedBoxes& boxes, const CellSearch& search, std::uint32_t from,
                         std::uint32_t* ends, std::uint8_t* areCertain, std::uint32_t* partners) {
  const Numbers all(boxes);
  std::uint32_t* end = partners + from;
  for (std::uint32_t slot = search.slots.begin; slot < search.slots.end; ++slot) {
    Test test(all, slot);
    end = append(test, {slot + 1, search.end}, end);
    for (std::size_t n = 0; n < search.otherCount; ++n) end = append(test, search.others[n], end);
    *ends++ = static_cast<std::uint32_t>(end - partners);
    *areCertain++ = test.areCertain() ? 1 : 0;
  }
}

}  // namespace

void findPartnersHere(const SortedBoxes& boxes, const CellSearch& search, std::uint32_t from,
                      std::uint32_t* ends, std::uint8_t* areCertain, std::uint32_t* partners) {
  if (boxes.content == BoxContent::Spheres)
    findEach<SphereTest>(boxes, search, from, ends, areCertain, partners);
  else
    findEach<BoxTest>(boxes, search, from, ends, areCertain, partners);
}

std::uint32_t findWithinHere(const SortedBoxes& boxes, const std::array<float, 3>& low,
                             const std::array<float, 3>& high, SlotRange range,
                             std::uint32_t* found) {
  FaceTest test(Numbers(boxes), low, high);
  return static_cast<std::uint32_t>(append(test, range, found) - found);
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {

HWY_EXPORT(findPartnersHere);
HWY_EXPORT(findWithinHere);

void findPartners(const SortedBoxes& boxes, const CellSearch& search, std::uint32_t from,
                  std::uint32_t* ends, std::uint8_t* areCertain, std::uint32_t* partners) {
  HWY_DYNAMIC_DISPATCH(findPartnersHere)(boxes, search, from, ends, areCertain, partners);
}

std::uint32_t findWithin(const SortedBoxes& boxes, const std::array<float, 3>& low,
                         const std::array<float, 3>& high, SlotRange range, std::uint32_t* found) {
  return HWY_DYNAMIC_DISPATCH(findWithinHere)(boxes, low, high, range, found);
}

}  // namespace wells
#endif
