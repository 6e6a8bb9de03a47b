// Lists the balls among what a broadphase hands over.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>

#include <cstdint>
#include <vector>

#include "broadphase/ball_pair.h"
#include "broadphase/bullet_proxy.h"
#include "state/arena.h"

namespace wells {

class BallCollector final : public btBroadphaseAabbCallback {
 public:
  explicit BallCollector(std::vector<std::uint32_t>& found) : found_(found) {}

  bool process(const btBroadphaseProxy* proxy) override {
    if (isBall(numberOf(*proxy))) found_.push_back(numberOf(*proxy));
    return true;
  }

 private:
  std::vector<std::uint32_t>& found_;
};

}  // namespace wells
