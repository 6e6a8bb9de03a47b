// What Bullet's proxies stand for here: a ball, kGround or kWall, kept in the user pointer.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>

#include <cstdint>

#include "math/vector.h"

namespace wells {

// Bullet's two builds share their headers; a forgotten BT_USE_DOUBLE_PRECISION would link and then
// read floats as doubles.
static_assert(sizeof(btScalar) == sizeof(double), "the broadphase needs Bullet's double build");

inline btVector3 toBullet(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

inline void* asClient(std::uint32_t number) {
  return reinterpret_cast<void*>(std::uintptr_t{number});
}

inline std::uint32_t numberOf(const btBroadphaseProxy& proxy) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(proxy.m_clientObject));
}

}  // namespace wells
