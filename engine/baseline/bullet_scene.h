// A World's arena and balls as Bullet's objects, and the world that Bullet steps them in. Owns all
// of them. Bullet's coordinates are the World's less the arena's centre.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "baseline/bullet.h"
#include "state/world.h"

namespace wells {

static_assert(sizeof(btScalar) == 4, "the baseline is Bullet in single precision");

inline constexpr int kWallBoxes = 64;
inline constexpr double kWallThickness = 2;  // m; 1 m is what a ball at 60 m/s covers in 1/60 s

class BulletScene {
 public:
  BulletScene(const World& world, BulletSleeping sleeping);

  /// Whether this is still the scene of `world`: same arena, radii and masses.
  bool fits(const World& world) const;

  /// Puts gravity, elasticity, friction, rolling resistance and drag where Bullet keeps them.
  void apply(const Settings& settings);

  BallState ball(std::size_t i) const;
  void setBall(std::size_t i, const BallState& state);
  void addForce(std::size_t i, const Vec3& force);  // N, for the next step
  bool sleeps(std::size_t i) const { return !balls_[i]->isActive(); }

  void step(double dt);

  StepCounts counts() const;

 private:
  void addBalls(const Balls& balls, BulletSleeping sleeping);
  void addGround();
  void addWall(double radius, double height);
  void addStatic(btCollisionShape& shape, const btTransform& place);

  Arena arena_;
  std::vector<double> radii_;
  std::vector<double> masses_;

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  std::map<double, btSphereShape> spheres_;  // by radius
  btStaticPlaneShape ground_{btVector3{0, 1, 0}, 0};
  std::unique_ptr<btBoxShape> wallBox_;
  std::vector<std::unique_ptr<btRigidBody>> balls_;
  std::vector<std::unique_ptr<btRigidBody>> statics_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
};

}  // namespace wells
