#include "broadphase/cell_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "math/room.h"

namespace wells {
namespace {

// With at most so many boxes, all are compared with all.
constexpr std::size_t kFewBoxes = 48;
// From so many, evenly spread over the list, the size of a cell and its place are found.
constexpr std::size_t kSizeSample = 256;
constexpr std::size_t kPlaceSample = 64;
// Boxes up to so much larger than the largest of the sample still go into cells.
constexpr double kSizeMargin = 1.05;
// Of the width over which boxes are spread, what is left without the outer tenths.
constexpr double kWidthOfSample = 0.8;
constexpr int kSortsWithOnePlace = 16;
// The number of a cell is exact to 2^-22 of a cell up to so many cells from the anchor; cells are
// larger than boxes by more than that.
constexpr double kMostCellsAway = 1e9;
constexpr double kCellOffset = 1 << 30;
constexpr double kCellMargin = 1e-5;
constexpr double kLargestLength = 1e15;  // m, whose square is a float
// More than is lost by rounding: of a coordinate from the anchor and of a size, in the tests'
// single precision; of a coordinate from the origin, in a box's faces.
constexpr double kCoordinateLoss = 1.0 / (1 << 22);
constexpr double kSizeLoss = 1.0 / (1 << 20);
constexpr double kFaceLoss = 1e-15;

// Where more lie around a box, blocks of boxes are looked at instead.
constexpr std::int64_t kMostCellsToLookAt = 1000;
constexpr std::size_t kLeastRange = 4096;  // boxes, that a thread looks at
// Partners that are made room for at a time, in slots.
constexpr std::size_t kMostRoom = 1 << 12;

Vec3 centerOf(const btBroadphaseProxy& box) {
  Vec3 center;
  for (int k = 0; k < 3; ++k) center[k] = 0.5 * (box.m_aabbMin[k] + box.m_aabbMax[k]);
  return center;
}

/// m, along an axis.
double halfSizeOf(const btBroadphaseProxy& box, int axis) {
  return 0.5 * (box.m_aabbMax[axis] - box.m_aabbMin[axis]);
}

std::size_t strideOf(std::size_t size, std::size_t sample) {
  return std::max<std::size_t>(1, size / sample);
}

double greatestHalfSizeOf(const btBroadphaseProxy& box) {
  double half = 0;
  for (int k = 0; k < 3; ++k) half = std::max(half, halfSizeOf(box, k));
  return half;
}

}  // namespace

void CellGrid::sort(std::span<btBroadphaseProxy* const> boxes, ThreadPool& threads) {
  layOut(boxes);
  cellOfBox_.resize(boxes.size());
  threads.forRanges(boxes.size(), kLeastRange,
                    [&](std::size_t begin, std::size_t end, std::size_t) {
                      for (std::size_t i = begin; i < end; ++i) cellOfBox_[i] = cellFor(*boxes[i]);
                    });
  large_.clear();
  start_.assign((std::size_t{1} << (bits_[0] + bits_[1] + bits_[2])) + 1, 0);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (cellOfBox_[i] == kNoCell)
      large_.push_back(static_cast<std::uint32_t>(i));
    else
      ++start_[cellOfBox_[i]];
  }
  assignSlots();
  const bool areSpheres = content_ == BoxContent::Spheres;
  const std::size_t room = slots() + SortedBoxes::kRoom;
  sorted_.content = content_;
  for (auto* numbers : {&sorted_.x, &sorted_.y, &sorted_.z, &sorted_.halfX})
    resizeAfresh(*numbers, room);
  for (auto* numbers : {&sorted_.halfY, &sorted_.halfZ})
    resizeAfresh(*numbers, areSpheres ? 0 : room);
  resizeAfresh(sorted_.certain, areSpheres ? room : 0);
  threads.forRanges(slots(), kLeastRange, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t slot = begin; slot < end; ++slot) fillSlot(*boxes[boxOf_[slot]], slot);
  });
  blocks_.clear();
}

void CellGrid::layOut(std::span<btBroadphaseProxy* const> boxes) {
  const std::size_t stride = strideOf(boxes.size(), kSizeSample);
  double half = 0;
  for (std::size_t i = 0; i < boxes.size(); i += stride)
    if (const double size = greatestHalfSizeOf(*boxes[i]); size <= kLargestLength / 4)
      half = std::max(half, size);
  size_ = half > 0 ? 2 * half * (stride > 1 ? kSizeMargin : 1 + 2 * kCellMargin) : 1;
  inverseSize_ = 1 / size_;
  farthest_ = std::min(kMostCellsAway * size_, kLargestLength);
  if (--sortsLeft_ >= 0 && placedFor_ == boxes.size()) return;
  choosePlace(boxes);
  placedFor_ = boxes.size();
  sortsLeft_ = kSortsWithOnePlace;
}

/// The grid covers most boxes once, and has about as many cells as there are boxes.
void CellGrid::choosePlace(std::span<btBroadphaseProxy* const> boxes) {
  std::array<std::array<double, kPlaceSample>, 3> sample{};
  std::size_t size = 0;
  const std::size_t stride = strideOf(boxes.size(), kPlaceSample);
  for (std::size_t i = 0; i < boxes.size() && size < kPlaceSample; i += stride) {
    if (!(2 * greatestHalfSizeOf(*boxes[i]) <= size_)) continue;
    const Vec3 center = centerOf(*boxes[i]);
    if (!isFinite(center)) continue;
    for (int k = 0; k < 3; ++k) sample[k][size] = center[k];
    ++size;
  }
  bits_ = {};
  anchor_ = {};
  if (size == 0) return;
  std::uint32_t sum = 0;
  for (int k = 0; k < 3; ++k) {
    const std::span values(sample[k].data(), size);
    std::ranges::sort(values);
    const double low = values[size / 10];
    const double high = values[size - 1 - size / 10];
    anchor_[k] = low + 0.5 * (high - low);
    const double cells = std::clamp((high - low) / (kWidthOfSample * size_), 1.0, 1e6);
    bits_[k] =
        std::max(2u, static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint32_t>(cells))));
    sum += bits_[k];
  }
  if (stride == 1 && size <= kFewBoxes) bits_ = {};
  if (bits_[0] == 0) return;
  const auto most = std::max(6u, static_cast<std::uint32_t>(std::bit_width(boxes.size())));
  for (; sum > most; --sum) --*std::ranges::max_element(bits_);
}

/// Along an axis, of a place so far (m) from the anchor.
std::int64_t CellGrid::numberOfCell(double x) const {
  return static_cast<std::int64_t>(x * inverseSize_ + kCellOffset);
}

/// kNoCell for one that is to be kept apart.
std::uint32_t CellGrid::cellFor(const btBroadphaseProxy& box) const {
  const Vec3 center = centerOf(box);
  std::uint32_t cell = 0;
  for (int k = 2; k >= 0; --k) {
    const double x = center[k] - anchor_[k];
    if (!(std::abs(x) <= farthest_) || !(2 * halfSizeOf(box, k) * (1 + kCellMargin) <= size_))
      return kNoCell;
    cell =
        cell << bits_[k] | (static_cast<std::uint32_t>(numberOfCell(x)) & ((1u << bits_[k]) - 1));
  }
  return cell;
}

void CellGrid::assignSlots() {
  std::uint32_t sum = 0;
  for (std::uint32_t& start : start_) sum += std::exchange(start, sum);
  resizeAfresh(cellOf_, sum);
  resizeAfresh(boxOf_, sum);
  // start_[cell] runs to the end of its cell, where the next one's was; then all go back.
  for (std::size_t i = 0; i < cellOfBox_.size(); ++i) {
    const std::uint32_t cell = cellOfBox_[i];
    if (cell == kNoCell) continue;
    const std::uint32_t slot = start_[cell]++;
    cellOf_[slot] = cell;
    boxOf_[slot] = static_cast<std::uint32_t>(i);
  }
  std::copy_backward(start_.begin(), start_.end() - 1, start_.end());
  start_[0] = 0;
}

void CellGrid::fillSlot(const btBroadphaseProxy& box, std::size_t slot) {
  const Vec3 center = centerOf(box);
  const std::array places{&sorted_.x, &sorted_.y, &sorted_.z};
  double away = 0;
  double fromOrigin = 0;
  for (int k = 0; k < 3; ++k) {
    const double x = center[k] - anchor_[k];
    away = std::max(away, std::abs(x));
    fromOrigin = std::max(fromOrigin, std::abs(center[k]));
    (*places[k])[slot] = static_cast<float>(x);
  }
  const double loss = kCoordinateLoss * away + kFaceLoss * fromOrigin;
  const std::array halves{&sorted_.halfX, &sorted_.halfY, &sorted_.halfZ};
  for (int k = 0; k < (content_ == BoxContent::Spheres ? 1 : 3); ++k)
    (*halves[k])[slot] = static_cast<float>((halfSizeOf(box, k) + loss) * (1 + kSizeLoss));
  if (content_ == BoxContent::Spheres)
    sorted_.certain[slot] = static_cast<float>((halfSizeOf(box, 0) - loss) * (1 - kSizeLoss));
}

/// Adds what lies in the cells x - 1, x and x + 1 of a row, all modulo the size of the grid.
void CellGrid::addRow(std::uint32_t x, std::uint32_t y, std::uint32_t z, CellSearch& search) const {
  const std::uint32_t last = (1u << bits_[0]) - 1;
  y &= (1u << bits_[1]) - 1;
  z &= (1u << bits_[2]) - 1;
  const std::uint32_t row = (z << bits_[1] | y) << bits_[0];
  const auto add = [&](std::uint32_t from, std::uint32_t to) {
    const SlotRange range{start_[row + from], start_[row + to + 1]};
    if (range.begin < range.end) search.others[search.otherCount++] = range;
  };
  if (x == 0) {
    add(0, 1);
    add(last, last);
  } else if (x == last) {
    add(last - 1, last);
    add(0, 0);
  } else {
    add(x - 1, x + 1);
  }
}

/// The cell itself and half of those around it; the other half has the cell among theirs.
CellSearch CellGrid::around(std::uint32_t cell) const {
  CellSearch search;
  search.slots = {start_[cell], start_[cell + 1]};
  search.end = start_[cell + 1];
  if (cells() == 1) return search;
  const std::uint32_t last = (1u << bits_[0]) - 1;
  const std::uint32_t x = cell & last;
  const std::uint32_t y = cell >> bits_[0] & ((1u << bits_[1]) - 1);
  const std::uint32_t z = cell >> (bits_[0] + bits_[1]);
  if (x < last)
    search.end = start_[cell + 2];
  else if (const SlotRange first{start_[cell - last], start_[cell - last + 1]};
           first.begin < first.end)
    search.others[search.otherCount++] = first;
  addRow(x, y + 1, z, search);
  for (const std::uint32_t above : {y - 1, y, y + 1}) addRow(x, above, z + 1, search);
  return search;
}

void CellGrid::find(SlotRange range, FoundPartners& found) const {
  found.slots = range;
  found.ends.resize(range.end - range.begin);
  found.areCertain.resize(range.end - range.begin);
  std::uint32_t end = 0;
  for (std::uint32_t slot = range.begin; slot < range.end;) {
    CellSearch search = around(cellOf_[slot]);
    std::size_t most = search.end - search.slots.begin + SortedBoxes::kRoom;
    for (std::size_t n = 0; n < search.otherCount; ++n)
      most += search.others[n].end - search.others[n].begin;
    const auto atOnce = static_cast<std::uint32_t>(std::max<std::size_t>(1, kMostRoom / most));
    search.slots.begin = slot;
    search.slots.end = std::min({search.slots.end, range.end, slot + atOnce});
    const std::size_t count = search.slots.end - slot;
    if (found.partners.size() < end + count * most)
      found.partners.resize(end + end / 4 + count * most);
    std::uint32_t* const ends = found.ends.data() + (slot - range.begin);
    std::uint8_t* const areCertain = found.areCertain.data() + (slot - range.begin);
    findPartners(sorted_, search, end, ends, areCertain, found.partners.data());
    end = ends[count - 1];
    slot = search.slots.end;
  }
}

void CellGrid::boundBlocks() {
  const bool areSpheres = content_ == BoxContent::Spheres;
  const std::array centers{&sorted_.x, &sorted_.y, &sorted_.z};
  const std::array halves{&sorted_.halfX, areSpheres ? &sorted_.halfX : &sorted_.halfY,
                          areSpheres ? &sorted_.halfX : &sorted_.halfZ};
  for (std::uint32_t begin = 0; begin < slots(); begin += kBlock) {
    const std::uint32_t end = std::min(begin + kBlock, slots());
    Block block{};
    for (int k = 0; k < 3; ++k) {
      float low = std::numeric_limits<float>::max();
      float high = -low;
      for (std::uint32_t slot = begin; slot < end; ++slot) {
        const float center = (*centers[k])[slot];
        const float half = (*halves[k])[slot];
        low = std::min(low, center - half);
        high = std::max(high, center + half);
      }
      block.low[k] = low;
      block.high[k] = high;
    }
    blocks_.push_back(block);
  }
}

/// The cells of all boxes that may overlap one; none if they are too many to look at each, or would
/// go round the grid.
std::optional<CellGrid::CellBox> CellGrid::cellsAround(const Vec3& low, const Vec3& high) const {
  CellBox box;
  std::int64_t count = 1;
  for (int k = 0; k < 3; ++k) {
    const double from = low[k] - anchor_[k] - 0.5 * size_;
    const double to = high[k] - anchor_[k] + 0.5 * size_;
    if (!(from >= -farthest_ && to <= farthest_)) return std::nullopt;
    box.first[k] = numberOfCell(from);
    box.count[k] = numberOfCell(to) - box.first[k] + 1;
    count *= box.count[k];
    if (box.count[k] > std::int64_t{1} << bits_[k] || count > kMostCellsToLookAt)
      return std::nullopt;
  }
  return box;
}

template <class Look>
void CellGrid::forEachRow(const CellBox& box, Look look) const {
  const auto masked = [&](std::int64_t number, int axis) {
    return static_cast<std::uint32_t>(number) & ((1u << bits_[axis]) - 1);
  };
  for (std::int64_t z = 0; z < box.count[2]; ++z)
    for (std::int64_t y = 0; y < box.count[1]; ++y) {
      const std::uint32_t row =
          (masked(box.first[2] + z, 2) << bits_[1] | masked(box.first[1] + y, 1)) << bits_[0];
      const std::uint32_t x = masked(box.first[0], 0);
      const auto count = static_cast<std::uint32_t>(box.count[0]);
      const std::uint32_t beforeEdge = std::min(count, (1u << bits_[0]) - x);
      look({start_[row + x], start_[row + x + beforeEdge]});
      if (beforeEdge < count) look({start_[row], start_[row + count - beforeEdge]});
    }
}

template <class Look>
void CellGrid::forEachBlock(const std::array<float, 3>& low, const std::array<float, 3>& high,
                            Look look) {
  if (blocks_.empty()) boundBlocks();
  for (std::uint32_t n = 0; n < blocks_.size(); ++n) {
    const Block& block = blocks_[n];
    bool isNear = true;
    for (int k = 0; k < 3; ++k) isNear &= block.low[k] <= high[k] && block.high[k] >= low[k];
    if (isNear) look({n * kBlock, std::min((n + 1) * kBlock, slots())});
  }
}

void CellGrid::findIn(const Vec3& lowest, const Vec3& highest, std::vector<std::uint32_t>& found) {
  // Written so that a face that is not a number is as far away as can be.
  constexpr double kMost = std::numeric_limits<float>::max();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::array<float, 3> low{};
  std::array<float, 3> high{};
  for (int k = 0; k < 3; ++k) {
    const double from = lowest[k] - anchor_[k];
    const double to = highest[k] - anchor_[k];
    low[k] = from > -kMost ? std::nextafter(static_cast<float>(std::min(from, kMost)), -kInfinity)
                           : -kInfinity;
    high[k] = to < kMost ? std::nextafter(static_cast<float>(std::max(to, -kMost)), kInfinity)
                         : kInfinity;
  }
  std::size_t end = 0;
  const auto look = [&](SlotRange range) {
    const std::size_t most = end + (range.end - range.begin) + SortedBoxes::kRoom;
    if (found.size() < most) found.resize(2 * most);
    end += findWithin(sorted_, low, high, range, found.data() + end);
  };
  if (const auto cells = cellsAround(lowest, highest))
    forEachRow(*cells, look);
  else
    forEachBlock(low, high, look);
  found.resize(end);
}

}  // namespace wells
