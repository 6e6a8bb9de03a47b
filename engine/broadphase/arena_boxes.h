// Ground and wall as proxies of a broadphase. The wall is a ring of boxes, so that only balls near
// it pair with it.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>

#include <vector>

#include "state/arena.h"

namespace wells {

// Ground and wall pair with balls only.
inline constexpr int kBallGroup = 1;
inline constexpr int kArenaGroup = 2;
inline constexpr int kBallMask = kBallGroup | kArenaGroup;
inline constexpr int kArenaMask = kBallGroup;

/// Adds them, with kGround and kWall as clients. A ball whose box is beyond the ground or the wall
/// overlaps with them too.
std::vector<btBroadphaseProxy*> addArena(const Arena& arena, btBroadphaseInterface& broadphase);

}  // namespace wells
