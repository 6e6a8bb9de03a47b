#include "broadphase/overlap_search.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "broadphase/overlap_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Rows hold few boxes: wider vectors would be empty for the most part.
using Floats = hn::CappedTag<float, SortedBoxes::kRoom>;
using Slots = hn::RebindToUnsigned<Floats>;
using Vector = hn::Vec<Floats>;

HWY_INLINE Vector load(const std::vector<float>& numbers, std::uint32_t slot) {
  return hn::LoadU(Floats(), numbers.data() + slot);
}

HWY_INLINE Vector broadcast(float number) {
  return hn::Set(Floats(), number);
}

class Spheres {
 public:
  HWY_INLINE Spheres(const SortedBoxes& boxes, std::uint32_t slot)
      : boxes_(boxes),
        x_(broadcast(boxes.x[slot])),
        y_(broadcast(boxes.y[slot])),
        z_(broadcast(boxes.z[slot])),
        radius_(broadcast(boxes.halfX[slot])) {}

  HWY_INLINE hn::Mask<Floats> overlap(std::uint32_t slot) const {
    const Vector x = hn::Sub(load(boxes_.x, slot), x_);
    const Vector y = hn::Sub(load(boxes_.y, slot), y_);
    const Vector z = hn::Sub(load(boxes_.z, slot), z_);
    const Vector bound = hn::Add(load(boxes_.halfX, slot), radius_);
    const Vector squared = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
    return hn::Le(squared, hn::Mul(bound, bound));
  }

 private:
  const SortedBoxes& boxes_;
  const Vector x_, y_, z_, radius_;
};

class Boxes {
 public:
  HWY_INLINE Boxes(const SortedBoxes& boxes, std::uint32_t slot)
      : boxes_(boxes),
        x_(broadcast(boxes.x[slot])),
        y_(broadcast(boxes.y[slot])),
        z_(broadcast(boxes.z[slot])),
        halfX_(broadcast(boxes.halfX[slot])),
        halfY_(broadcast(boxes.halfY[slot])),
        halfZ_(broadcast(boxes.halfZ[slot])) {}

  HWY_INLINE hn::Mask<Floats> overlap(std::uint32_t slot) const {
    const auto along = [slot](Vector center, Vector half, const std::vector<float>& centers,
                              const std::vector<float>& halves) HWY_ATTR {
      return hn::Le(hn::Abs(hn::Sub(load(centers, slot), center)),
                    hn::Add(load(halves, slot), half));
    };
    return hn::And(hn::And(along(x_, halfX_, boxes_.x, boxes_.halfX),
                           along(y_, halfY_, boxes_.y, boxes_.halfY)),
                   along(z_, halfZ_, boxes_.z, boxes_.halfZ));
  }

 private:
  const SortedBoxes& boxes_;
  const Vector x_, y_, z_, halfX_, halfY_, halfZ_;
};

/// A box given by its faces, which may be too far away for a centre.
class Faces {
 public:
  HWY_INLINE Faces(const SortedBoxes& boxes, const std::array<float, 3>& low,
                   const std::array<float, 3>& high)
      : boxes_(boxes), low_(low), high_(high) {}

  HWY_INLINE hn::Mask<Floats> overlap(std::uint32_t slot) const {
    const bool areCubes = boxes_.content == BoxContent::Spheres;
    const auto along = [&](int axis, const std::vector<float>& centers,
                           const std::vector<float>& halves) HWY_ATTR {
      const Vector center = load(centers, slot);
      const Vector half = load(areCubes ? boxes_.halfX : halves, slot);
      return hn::And(hn::Le(hn::Sub(center, half), broadcast(high_[axis])),
                     hn::Ge(hn::Add(center, half), broadcast(low_[axis])));
    };
    return hn::And(hn::And(along(0, boxes_.x, boxes_.halfX), along(1, boxes_.y, boxes_.halfY)),
                   along(2, boxes_.z, boxes_.halfZ));
  }

 private:
  const SortedBoxes& boxes_;
  const std::array<float, 3>& low_;
  const std::array<float, 3>& high_;
};

/// Appends those of the range that overlap; returns the end of the list. Without a branch for each:
/// whether a neighbour overlaps cannot be foretold.
template <class Test>
HWY_INLINE std::uint32_t* append(const Test& test, SlotRange range, std::uint32_t* end) {
  const Slots slots;
  const auto lanes = static_cast<std::uint32_t>(hn::Lanes(slots));
  for (std::uint32_t slot = range.begin; slot < range.end; slot += lanes) {
    const auto isIn = hn::FirstN(slots, range.end - slot);
    const auto overlaps = hn::And(isIn, hn::RebindMask(slots, test.overlap(slot)));
    // In a register: storing a part of a vector takes some processors a hundred cycles.
    hn::StoreU(hn::Compress(hn::Iota(slots, slot), overlaps), slots, end);
    end += hn::CountTrue(slots, overlaps);
  }
  return end;
}

template <class Test>
HWY_INLINE void findEach(const SortedBoxes& boxes, const CellSearch& search, std::uint32_t from,
                         std::uint32_t* ends, std::uint32_t* partners) {
  std::uint32_t* end = partners + from;
  for (std::uint32_t slot = search.slots.begin; slot < search.slots.end; ++slot) {
    const Test test(boxes, slot);
    end = append(test, {slot + 1, search.end}, end);
    for (std::size_t n = 0; n < search.otherCount; ++n) end = append(test, search.others[n], end);
    *ends++ = static_cast<std::uint32_t>(end - partners);
  }
}

}  // namespace

void findPartnersHere(const SortedBoxes& boxes, const CellSearch& search, std::uint32_t from,
                      std::uint32_t* ends, std::uint32_t* partners) {
  if (boxes.content == BoxContent::Spheres)
    findEach<Spheres>(boxes, search, from, ends, partners);
  else
    findEach<Boxes>(boxes, search, from, ends, partners);
}

std::uint32_t findWithinHere(const SortedBoxes& boxes, const std::array<float, 3>& low,
                             const std::array<float, 3>& high, SlotRange range,
                             std::uint32_t* found) {
  return static_cast<std::uint32_t>(append(Faces(boxes, low, high), range, found) - found);
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {

HWY_EXPORT(findPartnersHere);
HWY_EXPORT(findWithinHere);

void findPartners(const SortedBoxes& boxes, const CellSearch& search, std::uint32_t from,
                  std::uint32_t* ends, std::uint32_t* partners) {
  HWY_DYNAMIC_DISPATCH(findPartnersHere)(boxes, search, from, ends, partners);
}

std::uint32_t findWithin(const SortedBoxes& boxes, const std::array<float, 3>& low,
                         const std::array<float, 3>& high, SlotRange range, std::uint32_t* found) {
  return HWY_DYNAMIC_DISPATCH(findWithinHere)(boxes, low, high, range, found);
}

}  // namespace wells
#endif
