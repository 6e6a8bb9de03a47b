#include "baseline/bullet_scene.h"

#include <algorithm>
#include <cmath>

#include "math/elementary.h"

namespace wells {
namespace {

btScalar single(double x) {
  return static_cast<btScalar>(x);
}

btVector3 toBullet(const Vec3& v) {
  return {single(v.x()), single(v.y()), single(v.z())};
}

Vec3 fromBullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

/// How high (m) the wall stands above the ground. Not simply very high: Bullet finds the normal of
/// ball and box by GJK, whose error grows with the box. At 3 m/s into a box 2 km high a ball comes
/// back with 0.08 m/s sideways, off one of 80 m with 0.002 m/s.
double wallHeight(const World& world) {
  double top = 0;
  for (const Vec3& position : world.balls.position) {
    top = std::max(top, position.y() - world.arena.center.y());
  }
  return world.arena.radius + top;
}

}  // namespace

BulletScene::BulletScene(const World& world, BulletSleeping sleeping)
    : arena_(world.arena), radii_(world.balls.radius), masses_(world.balls.mass) {
  addGround();
  addWall(world.arena.radius, wallHeight(world));
  addBalls(world.balls, sleeping);
  apply(world.settings);
}

bool BulletScene::fits(const World& world) const {
  return arena_.center == world.arena.center && arena_.radius == world.arena.radius &&
         radii_ == world.balls.radius && masses_ == world.balls.mass;
}

void BulletScene::apply(const Settings& settings) {
  world_.setGravity(toBullet(settings.gravity));
  const btScalar restitution = std::sqrt(single(settings.elasticity));
  const btScalar friction = std::sqrt(single(settings.friction));
  // Of two bodies Bullet takes rolling friction x friction of the other, summed. Without friction
  // it has none.
  const btScalar rolling =
      friction > 0 ? single(settings.rollingResistance) / (2 * friction) : btScalar{0};
  for (const auto& body : statics_) {
    body->setRestitution(restitution);
    body->setFriction(friction);
    body->setRollingFriction(rolling);
  }
  for (const auto& body : balls_) {
    body->setRestitution(restitution);
    body->setFriction(friction);
    body->setRollingFriction(rolling);
    body->setDamping(single(1 - settings.drag), 0);
    // The world's setGravity passes over bodies that sleep; whoever changes the rules wakes them.
    body->setGravity(toBullet(settings.gravity));
    body->activate();
  }
}

BallState BulletScene::ball(std::size_t i) const {
  const btRigidBody& body = *balls_[i];
  return {arena_.center + fromBullet(body.getWorldTransform().getOrigin()),
          fromBullet(body.getLinearVelocity()), fromBullet(body.getAngularVelocity())};
}

void BulletScene::setBall(std::size_t i, const BallState& state) {
  btRigidBody& body = *balls_[i];
  btTransform place = body.getWorldTransform();
  place.setOrigin(toBullet(state.position - arena_.center));
  body.setCenterOfMassTransform(place);
  body.setLinearVelocity(toBullet(state.velocity));
  body.setAngularVelocity(toBullet(state.spin));
  body.activate();
}

void BulletScene::addForce(std::size_t i, const Vec3& force) {
  balls_[i]->applyCentralForce(toBullet(force));
}

void BulletScene::step(double dt) {
  world_.stepSimulation(single(dt), 0);
}

StepCounts BulletScene::counts() const {
  StepCounts counts;
  counts.candidatePairs = broadphase_.getOverlappingPairCache()->getNumOverlappingPairs();
  for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
    counts.contacts += dispatcher_.getManifoldByIndexInternal(i)->getNumContacts();
  }
  return counts;
}

void BulletScene::addBalls(const Balls& balls, BulletSleeping sleeping) {
  balls_.reserve(balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    btSphereShape& shape =
        spheres_.try_emplace(balls.radius[i], single(balls.radius[i])).first->second;
    const btScalar mass = single(balls.mass[i]);
    btVector3 inertia;
    shape.calculateLocalInertia(mass, inertia);
    auto& body = balls_.emplace_back(std::make_unique<btRigidBody>(
        btRigidBody::btRigidBodyConstructionInfo{mass, nullptr, &shape, inertia}));
    if (sleeping == BulletSleeping::Off) body->setActivationState(DISABLE_DEACTIVATION);
    setBall(i, balls.state(i));
    world_.addRigidBody(body.get());
  }
}

void BulletScene::addGround() {
  addStatic(ground_, btTransform::getIdentity());
}

void BulletScene::addWall(double radius, double height) {
  // Long enough for neighbours to meet behind the outer corners too.
  const SinCos half = sinCosOfTurns(0.5 / kWallBoxes);
  const double halfLength = (radius + kWallThickness) * half.sin / half.cos;
  // As deep below the ground as it is thick.
  const double halfHeight = (height + kWallThickness) / 2;
  wallBox_ = std::make_unique<btBoxShape>(
      btVector3{single(kWallThickness / 2), single(halfHeight), single(halfLength)});
  const double distance = radius + kWallThickness / 2;
  for (int i = 0; i < kWallBoxes; ++i) {
    const double turns = static_cast<double>(i) / kWallBoxes;
    const SinCos angle = sinCosOfTurns(turns);
    btTransform place;
    // A positive turn about y takes +x towards -z.
    place.setRotation(btQuaternion{btVector3{0, 1, 0}, single(-2 * kPi * turns)});
    place.setOrigin(
        toBullet(Vec3{distance * angle.cos, height - halfHeight, distance * angle.sin}));
    addStatic(*wallBox_, place);
  }
}

void BulletScene::addStatic(btCollisionShape& shape, const btTransform& place) {
  auto& body = statics_.emplace_back(
      std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo{0, nullptr, &shape}));
  body->setWorldTransform(place);
  world_.addRigidBody(body.get());
}

}  // namespace wells
