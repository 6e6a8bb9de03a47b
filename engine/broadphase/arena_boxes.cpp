#include "broadphase/arena_boxes.h"

#include <algorithm>

#include "broadphase/bullet_proxy.h"
#include "math/elementary.h"

namespace wells {
namespace {

constexpr int kWallPieces = 64;
constexpr double kFarAway = 1e15;  // m; beyond any arena, and still exact enough to sort

}  // namespace

std::vector<btBroadphaseProxy*> addArena(const Arena& arena, btBroadphaseInterface& broadphase) {
  std::vector<btBroadphaseProxy*> proxies;
  const Vec3& c = arena.center;
  const auto add = [&](const Vec3& low, const Vec3& high, std::uint32_t partner) {
    proxies.push_back(broadphase.createProxy(toBullet(c + low), toBullet(c + high), 0,
                                             asClient(partner), kArenaGroup, kArenaMask, nullptr));
  };
  add({-kFarAway, -kFarAway, -kFarAway}, {kFarAway, 0, kFarAway}, kGround);
  // Each piece covers everything beyond the wall in its sector as well, so that a ball cannot pass
  // it by in one step.
  for (int piece = 0; piece < kWallPieces; ++piece) {
    const SinCos from = sinCosOfTurns(static_cast<double>(piece) / kWallPieces);
    const SinCos to = sinCosOfTurns(static_cast<double>(piece + 1) / kWallPieces);
    Vec3 low{kFarAway, -kFarAway, kFarAway};
    Vec3 high{-kFarAway, kFarAway, -kFarAway};
    for (const SinCos& edge : {from, to})
      for (const double r : {arena.radius, kFarAway}) {
        low.x() = std::min(low.x(), r * edge.cos);
        low.z() = std::min(low.z(), r * edge.sin);
        high.x() = std::max(high.x(), r * edge.cos);
        high.z() = std::max(high.z(), r * edge.sin);
      }
    // Multiples of a quarter turn are edges of pieces, so the corners bound the arc itself.
    add(low, high, kWall);
  }
  return proxies;
}

}  // namespace wells
