// A run that is saved and goes on in a fresh engine has the bits of one that was never interrupted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contacts/contact.h"
#include "math/random.h"
#include "reference/reference.h"
#include "scenes/catalogue.h"
#include "state/snapshot.h"
#include "world/measures.h"
#include "world/simulation.h"

namespace wells {
namespace {

using Engine = std::function<std::unique_ptr<Stepper>()>;

struct Case {
  std::string name;
  World world;
  std::int64_t steps;
  std::vector<std::int64_t> saves;  // at these steps
};

World movingWells() {
  World world = makeScene(findScene("template"), 60);
  world.tracks = {{.keyframes = {{0, {10, 1, 0}, 150}, {40, {-10, 1, 5}, -90}, {95, {0, 2, 9}, 0}}},
                  {.keyframes = {{-20, {0, 1, 0}, 60}, {200, {20, 1, 20}, 60}}, .softening = 1}};
  return world;
}

World withLostBall() {
  World world = makeScene(findScene("T1"), 40);
  world.balls.add({.position = {std::nan(""), 1, -0.0}}, 0.5, 1);
  return world;
}

World withRollingResistance() {
  World world = makeScene(findScene("T1"), 100);
  world.settings.rollingResistance = 0.02;
  return world;
}

World withGhosts() {
  World world = makeScene(findScene("T1"), 60);
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    world.roles.push_back(i % 3 == 0 ? Role::Ghost : Role::Owned);
  return world;
}

// The ball beneath it rests and sleeps until then.
World wellThatLeaves() {
  World world;
  world.balls.add({.position = {0, 0.5, 0}}, 0.5, 1);
  world.tracks = {{.keyframes = {{0, {0, 6, 0}, 20}, {100, {0, 6, 0}, 20}, {160, {6, 6, 0}, 20}}}};
  return world;
}

std::vector<Case> cases() {
  return {{"T1", makeScene(findScene("T1"), 200), 150, {0, 1, 60, 61, 110}},
          {"T2", makeScene(findScene("T2"), 100), 120, {1, 50}},
          {"slide-to-roll", makeScene(findScene("slide-to-roll")), 180, {30, 100}},
          {"bounce", makeScene(findScene("bounce")), 180, {17, 90}},
          {"zeno", makeScene(findScene("zeno")), 360, {100, 300}},
          {"moving wells", movingWells(), 220, {39, 40, 96, 180}},
          {"a ball that is not finite", withLostBall(), 60, {1, 40}},
          {"rolling resistance", withRollingResistance(), 120, {60, 90}},
          {"ghosts", withGhosts(), 90, {70}},
          {"T3", makeScene(findScene("T3"), 100), 60, {10, 29, 30, 45}},
          {"a well that wakes", wellThatLeaves(), 140, {20, 60, 99, 100, 101}}};
}

// The hash after each step.
std::vector<std::uint64_t> goOn(Stepper& stepper, World& world, std::int64_t end) {
  std::vector<std::uint64_t> hashes;
  while (world.step < end) {
    stepper.step(world);
    hashes.push_back(stateHash(world));
  }
  return hashes;
}

// Through bytes into a fresh engine, as another process would.
Snapshot saved(const World& world, const Stepper& stepper) {
  return decode(encode({world, *stepper.memory(), stepper.name()}));
}

void expectSameBits(const Case& c, const Engine& make) {
  World whole = c.world;
  const auto hashes = goOn(*make(), whole, c.steps);
  for (const std::int64_t save : c.saves) {
    World first = c.world;
    const auto before = make();
    goOn(*before, first, save);
    Snapshot snapshot = saved(first, *before);
    const auto after = make();
    after->restore(snapshot.memory);
    const auto rest = goOn(*after, snapshot.world, c.steps);
    ASSERT_EQ(snapshot.world.step, c.steps);
    for (std::size_t i = 0; i < rest.size(); ++i) {
      ASSERT_EQ(rest[i], hashes[static_cast<std::size_t>(save) + i])
          << c.name << ", saved at step " << save << ", step " << save + static_cast<int>(i) + 1;
    }
  }
}

TEST(Restart, HasTheBitsOfAnUninterruptedRun) {
  for (const ContactMethod method :
       {ContactMethod::Substep, ContactMethod::Exact, ContactMethod::Auto}) {
    for (Case c : cases()) {
      SCOPED_TRACE(name(method));
      c.world.settings.contactMethod = method;
      expectSameBits(c, [] { return makeSimulation(); });
    }
  }
}

TEST(Restart, OfTheReferenceEnginesToo) {
  for (const std::string_view engine : referenceNames()) {
    SCOPED_TRACE(engine);
    for (const Case& c : cases())
      expectSameBits(c, [&] { return makeReference(*referenceVariant(engine)); });
  }
}

// A run may be saved and restored as often as one likes.
void expectSameBitsAfterEveryStep(const World& start, std::int64_t steps) {
  World whole = start;
  const auto hashes = goOn(*makeSimulation(), whole, steps);
  Snapshot snapshot{start, {}};
  for (std::size_t i = 0; i < hashes.size(); ++i) {
    const auto stepper = makeSimulation();
    stepper->restore(snapshot.memory);
    stepper->step(snapshot.world);
    ASSERT_EQ(stateHash(snapshot.world), hashes[i]) << "step " << i + 1;
    snapshot = saved(snapshot.world, *stepper);
  }
}

TEST(Restart, AfterEveryStepOfAHeap) {
  expectSameBitsAfterEveryStep(makeScene(findScene("T1"), 100), 120);
}

// Two balls that overlap at first make a crowd of these 100, which parts into two halves: too small
// to become crowds, but large enough to remain some, and only the memory tells for how long.
TEST(Restart, AfterEveryStepOfACrowdThatParts) {
  World world;
  world.settings.gravity.setZero();
  Random random(3);
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 5; ++y) {
      for (int z = 0; z < 5; ++z) {
        const Vec3 apart{x < 2 ? -1.0 : 1.0, 0, 0};
        world.balls.add(
            {.position = 1.05 * Vec3(x, y + 5, z), .velocity = apart + 0.5 * random.direction()},
            0.5, 1);
      }
    }
  }
  world.balls.position.back().y() -= 0.1;
  expectSameBitsAfterEveryStep(world, 60);
}

// Changed from outside, saved before anybody has noticed: whole islands wake, and sleep again.
TEST(Restart, AfterEveryStepOfSleepersThatWake) {
  for (const ContactMethod method :
       {ContactMethod::Substep, ContactMethod::Exact, ContactMethod::Auto}) {
    SCOPED_TRACE(name(method));
    World world = makeScene(findScene("T3"), 100);
    for (int k = 1; k < 4; ++k)  // a column on the ball in the middle
      world.balls.add({.position = {0, 0.5 + k, 0}}, 0.5, 1);
    world.roles.assign(world.balls.size(), Role::Owned);
    world.roles[102] = Role::Ghost;
    world.settings.contactMethod = method;
    const auto stepper = makeSimulation();
    goOn(*stepper, world, 60);
    ASSERT_EQ(stepper->counts().asleep, 103);
    BallState noisy = world.balls.state(102);
    noisy.position.x() += 0.3 * world.settings.sleepSpeed;
    world.setState(102, noisy);
    world.setState(20, {.position = {1.5, 3, 0.3}, .velocity = {-4, -5, 0}});
    Snapshot snapshot = saved(world, *stepper);
    std::int64_t most = 0;
    while (world.step < 240) {
      stepper->step(world);
      const auto after = makeSimulation();
      after->restore(snapshot.memory);
      after->step(snapshot.world);
      ASSERT_EQ(stateHash(snapshot.world), stateHash(world)) << world.step;
      ASSERT_EQ(after->counts().asleep, stepper->counts().asleep) << world.step;
      most = std::max(most, 103 - stepper->counts().asleep);
      snapshot = saved(snapshot.world, *after);
    }
    EXPECT_GE(most, 6) << "the column and some more";
    EXPECT_GE(stepper->counts().asleep, 50);
  }
}

// The cases above are worth something only where the memory matters.
TEST(Restart, WithoutMemoryHasOtherBits) {
  for (const ContactMethod method : {ContactMethod::Substep, ContactMethod::Auto}) {
    World world = makeScene(findScene("T1"), 200);
    world.settings.contactMethod = method;
    const auto stepper = makeSimulation();
    goOn(*stepper, world, 110);
    EXPECT_FALSE(stepper->memory()->ballContacts.empty());
    EXPECT_FALSE(stepper->memory()->arenaContacts.empty());
    World forgetful = world;
    EXPECT_NE(goOn(*makeSimulation(), forgetful, 112), goOn(*stepper, world, 112));
  }
  World world = movingWells();
  const auto stepper = makeReference(ReferenceVariant::ImprovedEuler);
  goOn(*stepper, world, 60);
  World forgetful = world;
  EXPECT_NE(goOn(*makeReference(ReferenceVariant::ImprovedEuler), forgetful, 62),
            goOn(*stepper, world, 62));
}

// A ball that was changed from outside just before the save starts afresh, saved or not.
TEST(Restart, KeepsWhatWasChangedFromOutside) {
  World world = movingWells();
  const auto stepper = makeReference(ReferenceVariant::ImprovedEuler);
  goOn(*stepper, world, 20);
  world.balls.velocity[7] = {3, 1, -2};
  Snapshot snapshot = saved(world, *stepper);
  const auto after = makeReference(ReferenceVariant::ImprovedEuler);
  after->restore(snapshot.memory);
  EXPECT_EQ(goOn(*after, snapshot.world, 40), goOn(*stepper, world, 40));
}

// snapshot_check.cpp, floors below, knows the partners by number.
TEST(Restart, KnowsGroundAndWall) {
  StepperMemory memory;
  memory.arenaContacts = {{.a = 0, .b = kWall}, {.a = 0, .b = kGround}};
  const Snapshot snapshot{makeScene(findScene("bounce")), memory};
  EXPECT_EQ(decode(encode(snapshot)).memory.arenaContacts[1].b, kGround);
}

}  // namespace
}  // namespace wells
