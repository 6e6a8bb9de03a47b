// Lanes of contacts: what the kernels of crowds share. Records of balls are loaded whole and
// transposed, so that each lane is a contact.
//
// Included by sources that are compiled once for each instruction set (math/instruction_set.h).
#if defined(WELLS_CONTACTS_CONTACT_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef WELLS_CONTACTS_CONTACT_LANES_INL_H_
#undef WELLS_CONTACTS_CONTACT_LANES_INL_H_
#else
#define WELLS_CONTACTS_CONTACT_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "contacts/contact.h"
#include "contacts/crowd_kernels.h"
#include "contacts/partners.h"
#include "math/wide_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, kContactLanes>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
using V3 = WideVector<D>;
constexpr D kTag;
constexpr std::size_t kLanes = hn::MaxLanes(kTag);  // 1, 4 or 8
// Records of four doubles are transposed four at a time.
constexpr hn::CappedTag<double, 4> kHalf;
using H = hn::Vec<decltype(kHalf)>;

struct V4 {
  V x, y, z, w;
};

struct H4 {
  H x, y, z, w;
};

HWY_INLINE V set(double value) {
  return hn::Set(kTag, value);
}
HWY_INLINE V load(const double* at) {
  return hn::Load(kTag, at);
}
HWY_INLINE V3 choose(M which, const V3& a, const V3& b) {
  return {hn::IfThenElse(which, a.x, b.x), hn::IfThenElse(which, a.y, b.y),
          hn::IfThenElse(which, a.z, b.z)};
}
HWY_INLINE V3 xyz(const V4& a) {
  return {a.x, a.y, a.z};
}

/// Four doubles from each of the records, at(lane), a lane each.
template <class At>
HWY_INLINE V4 loadQuads(At at) {
#if HWY_TARGET == HWY_SCALAR
  const double* const from = at(0);
  return {load(from), load(from + 1), load(from + 2), load(from + 3)};
#else
  const auto four = [&](std::size_t lane) HWY_ATTR {
    const H a = hn::Load(kHalf, at(lane)), b = hn::Load(kHalf, at(lane + 1));
    const H c = hn::Load(kHalf, at(lane + 2)), d = hn::Load(kHalf, at(lane + 3));
    const H ab02 = hn::InterleaveLower(kHalf, a, b), ab13 = hn::InterleaveUpper(kHalf, a, b);
    const H cd02 = hn::InterleaveLower(kHalf, c, d), cd13 = hn::InterleaveUpper(kHalf, c, d);
    return H4{hn::ConcatLowerLower(kHalf, cd02, ab02), hn::ConcatLowerLower(kHalf, cd13, ab13),
              hn::ConcatUpperUpper(kHalf, cd02, ab02), hn::ConcatUpperUpper(kHalf, cd13, ab13)};
  };
#if HWY_TARGET == HWY_AVX3
  const H4 low = four(0), high = four(4);
  return {hn::Combine(kTag, high.x, low.x), hn::Combine(kTag, high.y, low.y),
          hn::Combine(kTag, high.z, low.z), hn::Combine(kTag, high.w, low.w)};
#else
  const H4 all = four(0);
  return {all.x, all.y, all.z, all.w};
#endif
#endif
}

template <class At>
HWY_INLINE void storeQuads(const V4& v, At at) {
#if HWY_TARGET == HWY_SCALAR
  double* const to = at(0);
  hn::Store(v.x, kTag, to);
  hn::Store(v.y, kTag, to + 1);
  hn::Store(v.z, kTag, to + 2);
  hn::Store(v.w, kTag, to + 3);
#else
  const auto four = [&](H x, H y, H z, H w, std::size_t lane) HWY_ATTR {
    const H ab01 = hn::InterleaveLower(kHalf, x, y), cd01 = hn::InterleaveLower(kHalf, z, w);
    const H ab23 = hn::InterleaveUpper(kHalf, x, y), cd23 = hn::InterleaveUpper(kHalf, z, w);
    // Of the interleaved, the lower halves are of lanes 0 and 1, the upper ones of 2 and 3.
    hn::Store(hn::ConcatLowerLower(kHalf, cd01, ab01), kHalf, at(lane));
    hn::Store(hn::ConcatLowerLower(kHalf, cd23, ab23), kHalf, at(lane + 1));
    hn::Store(hn::ConcatUpperUpper(kHalf, cd01, ab01), kHalf, at(lane + 2));
    hn::Store(hn::ConcatUpperUpper(kHalf, cd23, ab23), kHalf, at(lane + 3));
  };
#if HWY_TARGET == HWY_AVX3
  const auto low = [](V x) HWY_ATTR { return hn::LowerHalf(kHalf, x); };
  const auto high = [](V x) HWY_ATTR { return hn::UpperHalf(kHalf, x); };
  four(low(v.x), low(v.y), low(v.z), low(v.w), 0);
  four(high(v.x), high(v.y), high(v.z), high(v.w), 4);
#else
  four(v.x, v.y, v.z, v.w, 0);
#endif
#endif
}

HWY_INLINE V4 loadPlaces(const Place* places, const std::uint32_t* index) {
  return loadQuads([&](std::size_t lane) { return &places[index[lane]].x; });
}
HWY_INLINE void storePlaces(const V4& v, Place* places, const std::uint32_t* index) {
  storeQuads(v, [&](std::size_t lane) { return &places[index[lane]].x; });
}

/// Velocity and inverse mass; surface speed.
struct Moving {
  V4 v;
  V4 s;
};

template <bool kSpins>
HWY_INLINE Moving loadMoving(const Momentum* momenta, const std::uint32_t* index) {
  Moving moving;
  moving.v = loadQuads([&](std::size_t lane) { return &momenta[index[lane]].vx; });
  if constexpr (kSpins)
    moving.s = loadQuads([&](std::size_t lane) { return &momenta[index[lane]].sx; });
  else
    moving.s = moving.v;
  return moving;
}
template <bool kSpins>
HWY_INLINE void storeMoving(const Moving& moving, Momentum* momenta, const std::uint32_t* index) {
  storeQuads(moving.v, [&](std::size_t lane) { return &momenta[index[lane]].vx; });
  if constexpr (kSpins)
    storeQuads(moving.s, [&](std::size_t lane) { return &momenta[index[lane]].sx; });
}

HWY_INLINE V3 normalOf(const ContactBlock& block, std::size_t lane) {
  return {load(block.nx + lane), load(block.ny + lane), load(block.nz + lane)};
}
HWY_INLINE V3 tangentOf(const ContactBlock& block, std::size_t lane) {
  return {load(block.tx + lane), load(block.ty + lane), load(block.tz + lane)};
}

/// Gives a the impulse, and b the opposite.
template <PartnerKind kPartner>
HWY_INLINE void push(const V3& impulse, Moving& a, Moving& b) {
  const V3 va = xyz(a.v) + scaled(impulse, a.v.w);
  a.v = {va.x, va.y, va.z, a.v.w};
  if constexpr (kPartner != PartnerKind::Ball) return;
  const V3 vb = xyz(b.v) - scaled(impulse, b.v.w);
  b.v = {vb.x, vb.y, vb.z, b.v.w};
}

/// What a tangent impulse, given by push(), does to the spins: the same to both.
template <PartnerKind kPartner>
HWY_INLINE void twist(const V3& normal, const V3& tangent, Moving& a, Moving& b) {
  const V3 torque = scaled(cross(normal, tangent), set(kSpinFactor));
  const V3 sa = xyz(a.s) + scaled(torque, a.v.w);
  a.s = {sa.x, sa.y, sa.z, a.s.w};
  if constexpr (kPartner != PartnerKind::Ball) return;
  const V3 sb = xyz(b.s) + scaled(torque, b.v.w);
  b.s = {sb.x, sb.y, sb.z, b.s.w};
}

struct Geometry {
  V3 across;  // m; in whose direction the normal lies
  V distance;
  V gap;
  V touching;  // m, the distance at which the gap is 0
};

/// Of a ball and the partner.
template <PartnerKind kPartner>
HWY_INLINE Geometry geometryOf(const Arena& arena, const V4& a, const V4& b) {
  if constexpr (kPartner == PartnerKind::Ball) {
    const V3 d = xyz(b) - xyz(a);
    const V touching = hn::Add(a.w, b.w);
    const V distance = hn::Sqrt(dot(d, d));
    return {d, distance, hn::Sub(distance, touching), touching};
  } else if constexpr (kPartner == PartnerKind::Ground) {
    const V height = hn::Sub(a.y, set(arena.center.y()));
    return {{set(0), set(-1), set(0)}, set(1), hn::Sub(height, a.w), a.w};
  } else {
    const V x = hn::Sub(a.x, set(arena.center.x()));
    const V z = hn::Sub(a.z, set(arena.center.z()));
    const V distance = hn::Sqrt(hn::Add(hn::Mul(x, x), hn::Mul(z, z)));
    const V touching = hn::Sub(set(arena.radius), a.w);
    return {{x, set(0), z}, distance, hn::Sub(touching, distance), touching};
  }
}

/// Across divided by its length; +x where that is 0, which the caller mends for balls.
HWY_INLINE V3 directionOf(const V3& across, V size) {
  const M isNull = hn::Eq(size, set(0));
  const V3 direction = scaled(across, hn::Div(set(1), hn::IfThenElse(isNull, set(1), size)));
  return choose(isNull, {set(1), set(0), set(0)}, direction);
}

/// The normals of balls whose centres coincide.
HWY_INLINE V3 normalsOfIds(const CrowdArrays& in, const V3& normal, V distance,
                           const std::uint32_t* a, const std::uint32_t* b) {
  HWY_ALIGN double part[4][kLanes];
  hn::Store(normal.x, kTag, part[0]);
  hn::Store(normal.y, kTag, part[1]);
  hn::Store(normal.z, kTag, part[2]);
  hn::Store(distance, kTag, part[3]);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (part[3][lane] > 0) continue;
    const Vec3 direction = directionOfIds(in.ids[a[lane]], in.ids[b[lane]]);
    for (int k = 0; k < 3; ++k) part[k][lane] = direction[k];
  }
  return {load(part[0]), load(part[1]), load(part[2])};
}

/// Calls action.template operator()<kPartner>().
template <class Action>
auto withKind(PartnerKind partner, Action action) {
  switch (partner) {
    case PartnerKind::Ground:
      return action.template operator()<PartnerKind::Ground>();
    case PartnerKind::Wall:
      return action.template operator()<PartnerKind::Wall>();
    case PartnerKind::Ball:
      break;
  }
  return action.template operator()<PartnerKind::Ball>();
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
