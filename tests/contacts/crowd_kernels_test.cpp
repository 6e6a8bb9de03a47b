#include "contacts/crowd_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "contacts/substep_rules.h"
#include "math/instruction_set.h"
#include "math/random.h"
#include "state/balls.h"

namespace wells {
namespace {

constexpr double kSubstep = 1.0 / 240;
constexpr std::uint32_t kNever = 0xfffffff0;
// Not a multiple of the lanes, so that some of them idle.
constexpr std::uint32_t kPairs = 2 * kContactLanes + 3;

/// Contacts of one kind that share no ball: between balls 2n and 2n + 1, or of ball n and the
/// arena.
struct Crowd {
  Crowd(PartnerKind kind, const CrowdRules& given) : partner(kind), rules(given) {
    rules.substep = 1;
  }

  void add(const BallState& state, double radius, double mass, const Vec3& gain = Vec3::Zero()) {
    const Vec3& x = state.position;
    const Vec3& v = state.velocity;
    const Vec3 s = radius * state.spin;
    ids.push_back(static_cast<std::uint32_t>(place.size()));
    place.push_back({x.x(), x.y(), x.z(), radius});
    momentum.push_back({v.x(), v.y(), v.z(), 1 / mass, s.x(), s.y(), s.z(), 0});
    gained.push_back({gain.x(), gain.y(), gain.z(), 0});
  }

  /// One substep, without the flight.
  void resolve(int passes) {
    const auto balls = static_cast<std::uint32_t>(place.size());
    const std::uint32_t count = partner == PartnerKind::Ball ? balls / 2 : balls;
    for (std::uint32_t n = 0; n < count; ++n)
      pairs.push_back(partner == PartnerKind::Ball ? IndexPair{2 * n, 2 * n + 1}
                                                   : IndexPair{n, balls});
    for (const double x : {0.0, 1e6}) add({.position = {x, 0, 0}}, 1, 1);
    lasting.resize(count + 1);
    touchedIn.resize(count + 1, kNever);
    const CrowdArrays arrays{place.data(),     momentum.data(), gained.data(),
                             ids.data(),       pairs.data(),    lasting.data(),
                             touchedIn.data(), balls,           count};
    std::vector<std::uint32_t> list(count + 1);
    list.resize(findTouching(partner, rules, arrays, 0, count, list.data()));
    touching = list;
    blocks.resize((list.size() + kContactLanes - 1) / kContactLanes);
    flights.resize(blocks.size());
    prepareContacts(partner, rules, arrays, list, blocks.data(), flights.data(), substep);
    startFromLasting(partner, rules, arrays, blocks);
    for (int pass = 0; pass < passes; ++pass)
      changed = solveContacts(partner, Watch::Changes, rules, arrays, blocks);
    shiftByForces(partner, rules, arrays, blocks, flights.data());
    pushOverlapsOut(partner, rules, arrays, blocks);
  }

  BallState state(std::size_t k) const {
    const Place& x = place[k];
    const Momentum& m = momentum[k];
    return {{x.x, x.y, x.z}, {m.vx, m.vy, m.vz}, Vec3(m.sx, m.sy, m.sz) / x.radius};
  }

  PartnerKind partner;
  CrowdRules rules;
  std::vector<std::uint32_t> ids, touching, touchedIn;
  std::vector<Place> place;
  std::vector<Momentum> momentum;
  std::vector<Gained> gained;
  std::vector<IndexPair> pairs;
  std::vector<LastingImpulse> lasting;
  std::vector<ContactBlock> blocks;
  std::vector<ContactFlight> flights;
  CrowdSubstep substep;
  double changed = 0;
};

struct Body {
  BallState state;
  double radius;
  double mass;
};

/// The impact of a solid ball on another, or on what does not give way (b null), with Coulomb
/// friction: J_n = (1 + e) m v_n; what would end the slip, 2/7 m v_t, or mu J_n where that is less
/// (Walton, "Numerical simulation of inelastic, frictional particle-particle interactions", 1993).
void impact(double e, double mu, const Vec3& normal, Body& a, Body* b) {
  const auto surface = [&](const Body& body, double side) {
    const Vec3 arm = side * body.radius * normal;
    return Vec3(body.state.velocity + cross(body.state.spin, arm));
  };
  const Vec3 relative = surface(a, 1) - (b ? surface(*b, -1) : Vec3(Vec3::Zero()));
  const double mass = 1 / (1 / a.mass + (b ? 1 / b->mass : 0));
  const double closing = dot(relative, normal);
  if (closing <= 0) return;
  const Vec3 slip = relative - closing * normal;
  const double pressed = (1 + e) * mass * closing;
  const double sticking = 2.0 / 7 * mass * length(slip);
  const double rub = std::min(sticking, mu * pressed);
  Vec3 impulse = -pressed * normal;
  if (length(slip) > 0) impulse -= slip * (rub / length(slip));
  const auto give = [&](Body& body, double side) {
    body.state.velocity += side * impulse / body.mass;
    const Vec3 arm = side * body.radius * normal;
    const double inertia = kInertiaFactor * body.mass * body.radius * body.radius;
    body.state.spin += cross(arm, side * impulse) / inertia;
  };
  give(a, 1);
  if (b) give(*b, -1);
}

void expectMoves(const BallState& state, const BallState& expected) {
  EXPECT_LE(length(state.velocity - expected.velocity), 1e-13);
  EXPECT_LE(length(state.spin - expected.spin), 1e-12);
}

Body randomBody(Random& random) {
  return {{.velocity = random.uniform(0, 5) * random.direction(),
           .spin = random.uniform(0, 5) * random.direction()},
          random.uniform(0.2, 2),
          random.uniform(0.1, 9)};
}

struct Material {
  double e;
  double mu;
};
constexpr Material kMaterials[] = {{0, 0}, {1, 0}, {0.6, 0.1}, {0.6, 100}, {0, 0.5}};

class CrowdKernels : public testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override { useInstructionSet(GetParam()); }
  void TearDown() override { useInstructionSet(instructionSets().back()); }

  static CrowdRules rulesOf(Material material) {
    return {kSubstep, material.e, material.mu, {.center = {1, 2, 3}, .radius = 40}, 1};
  }
};

TEST_P(CrowdKernels, ImpactsOfTwoBallsHaveTheClosedForm) {
  Random random(1);
  for (const Material material : kMaterials) {
    Crowd crowd(PartnerKind::Ball, rulesOf(material));
    std::vector<Body> bodies;
    for (std::uint32_t n = 0; n < kPairs; ++n) {
      Body a = randomBody(random), b = randomBody(random);
      const Vec3 normal = random.direction();
      a.state.position = {10.0 * n, 20, 0};
      b.state.position = a.state.position + (a.radius + b.radius) * (1 - 1e-12) * normal;
      crowd.add(a.state, a.radius, a.mass);
      crowd.add(b.state, b.radius, b.mass);
      impact(material.e, material.mu, normal, a, &b);
      bodies.insert(bodies.end(), {a, b});
    }
    crowd.resolve(1);
    for (std::size_t k = 0; k < bodies.size(); ++k) expectMoves(crowd.state(k), bodies[k].state);
    EXPECT_EQ(crowd.touching.size(), kPairs);
    EXPECT_TRUE(crowd.substep.anyImpact);
  }
}

TEST_P(CrowdKernels, ImpactsOnGroundAndWallHaveTheClosedForm) {
  Random random(2);
  for (const PartnerKind partner : {PartnerKind::Ground, PartnerKind::Wall})
    for (const Material material : kMaterials) {
      const CrowdRules rules = rulesOf(material);
      Crowd crowd(partner, rules);
      std::vector<Body> bodies;
      for (std::uint32_t n = 0; n < kPairs; ++n) {
        Body a = randomBody(random);
        Vec3 normal(0, -1, 0);
        a.state.position = rules.arena.center + Vec3(n, a.radius * (1 - 1e-12), 0);
        if (partner == PartnerKind::Wall) {
          normal = random.direction();
          normal.y() = 0;
          normal /= length(normal);
          a.state.position = rules.arena.center + Vec3(0, 9, 0) + (40 + 1e-12 - a.radius) * normal;
        }
        crowd.add(a.state, a.radius, a.mass);
        impact(material.e, material.mu, normal, a, nullptr);
        bodies.push_back(a);
      }
      crowd.resolve(1);
      for (std::size_t k = 0; k < bodies.size(); ++k) expectMoves(crowd.state(k), bodies[k].state);
    }
}

TEST_P(CrowdKernels, ASecondPassFindsNothingToDo) {
  Random random(3);
  Crowd crowd(PartnerKind::Ball, rulesOf({0.5, 0.2}));
  for (std::uint32_t n = 0; n < kPairs; ++n) {
    Body a = randomBody(random), b = randomBody(random);
    a.state.position = {10.0 * n, 20, 0};
    b.state.position = a.state.position + (a.radius + b.radius) * (1 - 1e-12) * random.direction();
    crowd.add(a.state, a.radius, a.mass);
    crowd.add(b.state, b.radius, b.mass);
  }
  crowd.resolve(2);
  EXPECT_LE(crowd.changed, 1e-13);  // of the second pass: contacts share no ball
}

TEST_P(CrowdKernels, FindsThoseThatTouch) {
  Random random(4);
  Crowd crowd(PartnerKind::Ball, rulesOf({0, 0}));
  std::vector<std::uint32_t> expected;
  for (std::uint32_t n = 0; n < 100; ++n) {
    const Vec3 at(10.0 * n, 20, 0);
    const double apart = random.uniform(0.8, 1.2);
    crowd.add({.position = at}, 0.3, 1);
    crowd.add({.position = at + apart * random.direction()}, 0.7, 1);
    if (apart <= 1) expected.push_back(n);
  }
  crowd.resolve(0);
  EXPECT_EQ(crowd.touching, expected);
  for (std::uint32_t n = 0; n < 100; ++n)
    EXPECT_EQ(crowd.touchedIn[n] == 1, std::ranges::binary_search(expected, n));
}

// A ball that lay on the ground and fell by g h^2/2 in the substep: its weight is what the ground
// bears, and it ends where it began.
TEST_P(CrowdKernels, TheGroundBearsABallAtRest) {
  const CrowdRules rules = rulesOf({0.8, 0.3});
  Crowd crowd(PartnerKind::Ground, rules);
  const double gain = -9.81 * kSubstep;
  for (std::uint32_t n = 0; n < kPairs; ++n) {
    const double radius = 0.5 + 0.1 * n;
    crowd.add({.position = rules.arena.center + Vec3(n, radius + gain * kSubstep / 2, 0),
               .velocity = {0, gain, 0}},
              radius, 1 + n, {0, gain, 0});
  }
  crowd.resolve(1);
  EXPECT_FALSE(crowd.substep.anyImpact);
  EXPECT_NEAR(crowd.substep.closing, -gain, 1e-15);
  for (std::uint32_t n = 0; n < kPairs; ++n) {
    const BallState state = crowd.state(n);
    EXPECT_LE(length(state.velocity), 1e-15);
    EXPECT_NEAR(state.position.y(), rules.arena.center.y() + 0.5 + 0.1 * n, 1e-14);
    EXPECT_NEAR(crowd.lasting[n].normal, (1 + n) * -gain, 1e-13);
  }
}

// A force along the ground, within friction, rolls a solid ball at 5/7 of what it does to one that
// slides: speed, place and, at the contact, no slip.
TEST_P(CrowdKernels, AForceAlongTheGroundRollsABall) {
  const CrowdRules rules = rulesOf({0, 0.9});
  Crowd crowd(PartnerKind::Ground, rules);
  const Vec3 gain = kSubstep * Vec3(1, -9.81, 2);
  for (std::uint32_t n = 0; n < kPairs; ++n)
    crowd.add(
        {.position = rules.arena.center + Vec3(n, 0.5, 0) + gain * kSubstep / 2, .velocity = gain},
        0.5, 1 + n, gain);
  crowd.resolve(1);
  for (std::uint32_t n = 0; n < kPairs; ++n) {
    const BallState state = crowd.state(n);
    const Vec3 rolls = kSubstep * 5 / 7 * Vec3(1, 0, 2);
    EXPECT_LE(length(state.velocity - rolls), 1e-15);
    EXPECT_LE(length(state.velocity + cross(state.spin, {0, -0.5, 0})), 1e-15);
    EXPECT_LE(length(state.position - rules.arena.center - Vec3(n, 0.5, 0) - rolls * kSubstep / 2),
              1e-14);
  }
}

// What is left of an overlap is kLeftOverlap of the smaller radius and, between balls, the share
// that one substep does not push out; the centre of mass stays, and so do velocities.
TEST_P(CrowdKernels, PushesOverlapsOut) {
  Random random(5);
  Crowd crowd(PartnerKind::Ball, rulesOf({0, 0}));
  std::vector<Body> bodies;
  for (std::uint32_t n = 0; n < kPairs; ++n) {
    Body a = randomBody(random), b = randomBody(random);
    a.state = {.position = {10.0 * n, 20, 0}};
    b.state = {.position = a.state.position + 0.8 * (a.radius + b.radius) * random.direction()};
    bodies.insert(bodies.end(), {a, b});
    crowd.add(a.state, a.radius, a.mass);
    crowd.add(b.state, b.radius, b.mass);
  }
  crowd.resolve(1);
  for (std::uint32_t n = 0; n < kPairs; ++n) {
    const Body& a = bodies[2 * n];
    const Body& b = bodies[2 * n + 1];
    const Vec3 xa = crowd.state(2 * n).position, xb = crowd.state(2 * n + 1).position;
    const double touching = a.radius + b.radius;
    const double left = kLeftOverlap * std::min(a.radius, b.radius);
    EXPECT_NEAR(touching - length(xb - xa), left + (1 - kPushOut) * (0.2 * touching - left), 1e-13);
    const Vec3 shift = a.mass * (xa - a.state.position) + b.mass * (xb - b.state.position);
    EXPECT_LE(length(shift), 1e-12);
    EXPECT_EQ(length(crowd.state(2 * n).velocity), 0);
  }
}

// An overlap of 0.01 m that balls leave at 0, 1/4, 1/2 .. of what it takes to end it in a substep:
// the push does the rest.
TEST_P(CrowdKernels, LeavesToBallsThatPartWhatTheyDoThemselves) {
  constexpr double kOverlap = 0.01;
  Crowd crowd(PartnerKind::Ball, rulesOf({0.5, 0.3}));
  const auto partOf = [](std::uint32_t n) { return 0.25 * n; };
  for (std::uint32_t n = 0; n < kPairs; ++n) {
    const Vec3 at(10.0 * n, 20, 0);
    const double speed = partOf(n) * kOverlap / kSubstep;
    crowd.add({.position = at}, 0.5, 1);
    crowd.add({.position = at + Vec3(0, 0, 1 - kOverlap), .velocity = {0, 0, speed}}, 0.5, 3);
  }
  crowd.resolve(2);
  for (std::uint32_t n = 0; n < kPairs; ++n) {
    const double rest = std::max(0.0, (1 - partOf(n)) * kOverlap - kLeftOverlap * 0.5);
    const Vec3 across = crowd.state(2 * n + 1).position - crowd.state(2 * n).position;
    EXPECT_NEAR(length(across), 1 - kOverlap + kPushOut * rest, 1e-14) << n;
    EXPECT_EQ(length(crowd.state(2 * n).velocity), 0);
  }
}

TEST_P(CrowdKernels, PartsBallsInOnePlace) {
  Crowd crowd(PartnerKind::Ball, rulesOf({0.5, 0.3}));
  for (std::uint32_t n = 0; n < kPairs; ++n)
    for (int twice = 0; twice < 2; ++twice) crowd.add({.position = {10.0 * n, 20, 0}}, 0.5, 1);
  crowd.resolve(4);
  const double left = kLeftOverlap * 0.5;
  for (std::uint32_t n = 0; n < kPairs; ++n)
    EXPECT_NEAR(length(crowd.state(2 * n + 1).position - crowd.state(2 * n).position),
                kPushOut * (1 - left), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Sets, CrowdKernels, testing::ValuesIn(instructionSets()),
                         [](const auto& tested) { return std::string(name(tested.param)); });

}  // namespace
}  // namespace wells
