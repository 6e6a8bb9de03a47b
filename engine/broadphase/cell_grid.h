// Which boxes overlap, of many that are about as large as each other: they are sorted into cells
// that are as large as a box, so that those which overlap lie in cells that touch. Knows no
// filters, and keeps nothing from one sort to the next but the layout of the cells.
//
// The grid has no end: a cell stands for all that lie a whole number of grids away from it, so that
// memory depends on the number of boxes alone, wherever they are. Rows of cells along x are
// contiguous, and so are the boxes in them. Boxes that are much larger than most, or too far away
// for the number of a cell to be exact, are kept apart and compared with blocks of the others.
//
// Tests are made in single precision with sizes rounded up: what is found is a superset.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "broadphase/overlap_search.h"
#include "math/vector.h"
#include "threads/thread_pool.h"

namespace wells {

/// What was found for a range of slots.
struct FoundPartners {
  SlotRange slots{};
  std::vector<std::uint32_t> ends;       // by slot of the range: where its partners end
  std::vector<std::uint8_t> areCertain;  // by slot of the range: all overlap, whatever was rounded
  std::vector<std::uint32_t> partners;   // slots; holds more than are valid

  /// Calls visit(slot, partner) for each pair.
  template <class Visit>
  void forEachPair(Visit visit) const {
    const std::uint32_t* at = partners.data();
    for (std::uint32_t slot = slots.begin; slot < slots.end; ++slot)
      for (const auto* const end = partners.data() + ends[slot - slots.begin]; at < end; ++at)
        visit(slot, *at);
  }

  /// Drops pairs for which !keep(slot, partner). That is asked only of slots with a partner that
  /// may not overlap.
  template <class Keep>
  void narrow(Keep keep) {
    std::uint32_t from = 0;
    std::uint32_t count = 0;
    for (std::uint32_t slot = slots.begin; slot < slots.end; ++slot) {
      const std::uint32_t end = ends[slot - slots.begin];
      const bool areAllKept = areCertain[slot - slots.begin] != 0;
      for (; from < end; ++from) {
        partners[count] = partners[from];
        count += areAllKept || keep(slot, partners[from]) ? 1 : 0;
      }
      ends[slot - slots.begin] = count;
    }
  }
};

class CellGrid {
 public:
  explicit CellGrid(BoxContent content) : content_(content) {}

  /// Takes boxes as they are now. O(n).
  void sort(std::span<btBroadphaseProxy* const> boxes, ThreadPool& threads);

  std::uint32_t slots() const { return static_cast<std::uint32_t>(boxOf_.size()); }
  /// By slot: the number of its box in the last sort().
  std::span<const std::uint32_t> boxOf() const { return boxOf_; }
  /// Numbers of those kept apart; all others have a slot.
  std::span<const std::uint32_t> large() const { return large_; }

  /// Lists the partners of a range of slots: over all ranges, each pair whose boxes may overlap
  /// stands once. Ranges are independent of each other.
  void find(SlotRange range, FoundPartners& found) const;

  /// Lists the slots that may overlap the box from low to high (m), which may be NaN or infinite.
  void findIn(const Vec3& low, const Vec3& high, std::vector<std::uint32_t>& found);

  std::size_t cells() const { return start_.empty() ? 0 : start_.size() - 1; }

 private:
  static constexpr std::uint32_t kNoCell = 0xffffffff;
  struct Block {
    std::array<float, 3> low, high;
  };
  static constexpr std::uint32_t kBlock = 64;  // slots
  /// Along each axis; not yet modulo the size of the grid.
  struct CellBox {
    std::array<std::int64_t, 3> first{}, count{};
  };

  void layOut(std::span<btBroadphaseProxy* const> boxes);
  void choosePlace(std::span<btBroadphaseProxy* const> boxes);
  std::uint32_t cellFor(const btBroadphaseProxy& box) const;
  void assignSlots();
  void fillSlot(const btBroadphaseProxy& box, std::size_t slot);
  void boundBlocks();
  void addRow(std::uint32_t x, std::uint32_t y, std::uint32_t z, CellSearch& search) const;
  CellSearch around(std::uint32_t cell) const;
  std::int64_t numberOfCell(double x) const;
  std::optional<CellBox> cellsAround(const Vec3& low, const Vec3& high) const;
  template <class Look>
  void forEachRow(const CellBox& box, Look look) const;
  template <class Look>
  void forEachBlock(const std::array<float, 3>& low, const std::array<float, 3>& high, Look look);

  BoxContent content_;
  // The layout.
  std::array<double, 3> anchor_{};       // m
  double size_ = 1;                      // m, of a cell
  double inverseSize_ = 1;               // 1/m
  double farthest_ = 0;                  // m, from the anchor, that has a cell
  std::array<std::uint32_t, 3> bits_{};  // 2^bits cells along each axis; all 0: a single cell
  std::size_t placedFor_ = 0;            // boxes
  int sortsLeft_ = 0;                    // with this anchor and these bits
  // Of the last sort.
  std::vector<std::uint32_t> cellOfBox_;       // in the order of the boxes
  std::vector<std::uint32_t> start_;           // by cell, of its slots
  std::vector<std::uint32_t> cellOf_, boxOf_;  // by slot
  std::vector<std::uint32_t> large_;
  SortedBoxes sorted_;
  std::vector<Block> blocks_;  // made when asked for
};

}  // namespace wells
