#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "math/components.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>

#include "math/components.h"
#include "math/wide_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

// Whole vectors only; both return how many they did.
std::size_t split(const double* vectors, std::size_t count, double* x, double* y, double* z) {
  const hn::ScalableTag<double> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    hn::Vec<decltype(d)> a, b, c;
    hn::LoadInterleaved3(d, vectors + 3 * i, a, b, c);
    hn::StoreU(a, d, x + i);
    hn::StoreU(b, d, y + i);
    hn::StoreU(c, d, z + i);
  }
  return i;
}

std::size_t join(const double* x, const double* y, const double* z, std::size_t count,
                 double* vectors) {
  const hn::ScalableTag<double> d;
  const std::size_t lanes = hn::Lanes(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
    hn::StoreInterleaved3(hn::LoadU(d, x + i), hn::LoadU(d, y + i), hn::LoadU(d, z + i), d,
                          vectors + 3 * i);
  return i;
}

// 0 times what is not finite is NaN, and a sum stays NaN.
bool finite(const double* numbers, std::size_t count) {
  const hn::ScalableTag<double> d;
  const std::size_t lanes = hn::Lanes(d);
  auto sum = hn::Zero(d);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) sum = sum + hn::LoadU(d, numbers + i) * hn::Zero(d);
  double rest = 0;
  for (; i < count; ++i) rest += numbers[i] * 0;
  return rest == 0 && hn::AllTrue(d, sum == hn::Zero(d));
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {
namespace {

HWY_EXPORT(split);
HWY_EXPORT(join);
HWY_EXPORT(finite);

bool isRun(std::span<const std::uint32_t> ids) {
  std::uint32_t differing = 0;  // bits; no branch, so that the compiler uses vectors
  for (std::size_t k = 0; k < ids.size(); ++k)
    differing |= ids[k] ^ (ids[0] + static_cast<std::uint32_t>(k));
  return differing == 0;
}

}  // namespace

void toComponents(std::span<const std::uint32_t> ids, const Vec3* vectors, double* x, double* y,
                  double* z) {
  std::size_t k = 0;
  if (!ids.empty() && isRun(ids))
    k = HWY_DYNAMIC_DISPATCH(split)(vectors[ids[0]].data(), ids.size(), x, y, z);
  for (; k < ids.size(); ++k) {
    const Vec3& v = vectors[ids[k]];
    x[k] = v.x();
    y[k] = v.y();
    z[k] = v.z();
  }
}

void fromComponents(std::span<const std::uint32_t> ids, const double* x, const double* y,
                    const double* z, Vec3* vectors) {
  std::size_t k = 0;
  if (!ids.empty() && isRun(ids))
    k = HWY_DYNAMIC_DISPATCH(join)(x, y, z, ids.size(), vectors[ids[0]].data());
  for (; k < ids.size(); ++k) vectors[ids[k]] = {x[k], y[k], z[k]};
}

bool areFinite(std::span<const double> numbers) {
  return HWY_DYNAMIC_DISPATCH(finite)(numbers.data(), numbers.size());
}

}  // namespace wells
#endif
