// Three components of as many independent vectors as a processor's register has lanes: Vec3 for
// vector code, with the same operators, so that a formula reads, and rounds, as its scalar twin.
// No sum goes across lanes and nothing is fused, so each lane has the bits that Vec3 has.
//
// Included by sources that are compiled once for each instruction set (see instruction_set.h).
#if defined(WELLS_MATH_WIDE_VECTOR_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WELLS_MATH_WIDE_VECTOR_INL_H_
#undef WELLS_MATH_WIDE_VECTOR_INL_H_
#else
#define WELLS_MATH_WIDE_VECTOR_INL_H_
#endif

#include <hwy/highway.h>

#include "math/vector.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// D: Highway's tag of how many doubles a vector has.
template <class D>
struct WideVector {
  hn::Vec<D> x;
  hn::Vec<D> y;
  hn::Vec<D> z;
};

template <class D>
HWY_INLINE WideVector<D> operator+(const WideVector<D>& a, const WideVector<D>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class D>
HWY_INLINE WideVector<D> operator-(const WideVector<D>& a, const WideVector<D>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// By a number of each lane's own.
template <class D>
HWY_INLINE WideVector<D> scaled(const WideVector<D>& a, hn::Vec<D> s) {
  return {a.x * s, a.y * s, a.z * s};
}

template <class D>
HWY_INLINE WideVector<D> operator*(const WideVector<D>& a, double s) {
  return scaled(a, hn::Set(D(), s));
}

template <class D>
HWY_INLINE WideVector<D> operator*(double s, const WideVector<D>& a) {
  return scaled(a, hn::Set(D(), s));
}

template <class D>
HWY_INLINE void operator+=(WideVector<D>& a, const WideVector<D>& b) {
  a = a + b;
}

/// The same vector in all lanes.
template <class D>
HWY_INLINE WideVector<D> wide(D d, double x, double y, double z) {
  return {hn::Set(d, x), hn::Set(d, y), hn::Set(d, z)};
}

/// Summed as (x + y) + z.
template <class D>
HWY_INLINE hn::Vec<D> dot(const WideVector<D>& a, const WideVector<D>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class D>
HWY_INLINE WideVector<D> cross(const WideVector<D>& a, const WideVector<D>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class D>
HWY_INLINE hn::Vec<D> squaredLength(const WideVector<D>& a) {
  return dot(a, a);
}

template <class D>
HWY_INLINE hn::Vec<D> length(const WideVector<D>& a) {
  return hn::Sqrt(squaredLength(a));
}

/// From and to arrays of components, of any alignment.
template <class D>
HWY_INLINE WideVector<D> load(D d, const double* x, const double* y, const double* z) {
  return {hn::LoadU(d, x), hn::LoadU(d, y), hn::LoadU(d, z)};
}

template <class D>
HWY_INLINE void store(const WideVector<D>& a, double* x, double* y, double* z) {
  const D d;
  hn::StoreU(a.x, d, x);
  hn::StoreU(a.y, d, y);
  hn::StoreU(a.z, d, z);
}

/// Calls work(d, i) for the lanes i, i + 1, ... of each vector until all of `count` are done: whole
/// vectors, then halves, then halves of those, so that nothing beyond is touched.
template <class D, class Work>
HWY_INLINE void forEachVector(D d, std::size_t begin, std::size_t count, const Work& work) {
  constexpr std::size_t kLanes = hn::MaxLanes(D());
  for (; begin + kLanes <= count; begin += kLanes) work(d, begin);
  if constexpr (kLanes > 1) {
    if (begin < count) forEachVector(hn::Half<D>(), begin, count, work);
  }
}

template <class Work>
HWY_INLINE void forEachVector(std::size_t count, const Work& work) {
  forEachVector(hn::ScalableTag<double>(), 0, count, work);
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
