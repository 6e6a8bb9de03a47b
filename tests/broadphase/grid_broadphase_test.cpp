#include "broadphase/grid_broadphase.h"

#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "math/random.h"
#include "math/vector.h"

namespace wells {
namespace {

using IdPairs = std::set<std::pair<int, int>>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::pair<int, int> idsOf(const btBroadphaseProxy& x, const btBroadphaseProxy& y) {
  return std::minmax(x.getUid(), y.getUid());
}

bool overlap(const btBroadphaseProxy& x, const btBroadphaseProxy& y) {
  bool all = true;
  for (int k = 0; k < 3; ++k)
    all &= x.m_aabbMin[k] <= y.m_aabbMax[k] && y.m_aabbMin[k] <= x.m_aabbMax[k];
  return all;
}

bool mayCollide(const btBroadphaseProxy& x, const btBroadphaseProxy& y) {
  return (x.m_collisionFilterGroup & y.m_collisionFilterMask) != 0 &&
         (y.m_collisionFilterGroup & x.m_collisionFilterMask) != 0;
}

IdPairs bruteForce(const std::vector<btBroadphaseProxy*>& proxies) {
  IdPairs pairs;
  for (std::size_t i = 0; i < proxies.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (mayCollide(*proxies[i], *proxies[j]) && overlap(*proxies[i], *proxies[j]))
        pairs.insert(idsOf(*proxies[i], *proxies[j]));
  return pairs;
}

IdPairs cached(btOverlappingPairCache& cache) {
  IdPairs pairs;
  const btBroadphasePairArray& array = cache.getOverlappingPairArray();
  for (int n = 0; n < array.size(); ++n)
    EXPECT_TRUE(pairs.insert(idsOf(*array[n].m_pProxy0, *array[n].m_pProxy1)).second);
  return pairs;
}

/// Boxes that come, move and go.
class Boxes {
 public:
  explicit Boxes(std::uint64_t seed) : random_(seed) {}
  ~Boxes() {
    for (auto* const proxy : proxies_) grid_.destroyProxy(proxy, nullptr);
  }
  Boxes(const Boxes&) = delete;
  Boxes& operator=(const Boxes&) = delete;

  void add(const Vec3& low, const Vec3& high, int group = 1, int mask = -1) {
    proxies_.push_back(
        grid_.createProxy(toBullet(low), toBullet(high), 0, nullptr, group, mask, nullptr));
  }
  void addNear(const Vec3& center, double width, double smallest, double largest, int group = 1,
               int mask = -1) {
    const Vec3 at = center + width * Vec3{random_.uniform(-1, 1), random_.uniform(-0.1, 0.1),
                                          random_.uniform(-1, 1)};
    const Vec3 half{random_.uniform(smallest, largest), random_.uniform(smallest, largest),
                    random_.uniform(smallest, largest)};
    add(at - half, at + half, group, mask);
  }
  void move(double farthest) {
    for (auto* const proxy : proxies_) {
      if (random_.below(3) == 0) continue;
      const btVector3 way = toBullet(random_.uniform(0, farthest) * random_.direction());
      grid_.setAabb(proxy, proxy->m_aabbMin + way, proxy->m_aabbMax + way, nullptr);
    }
  }
  void removeOne() {
    const auto at = proxies_.begin() + static_cast<std::ptrdiff_t>(random_.below(proxies_.size()));
    grid_.destroyProxy(*at, nullptr);
    proxies_.erase(at);
  }
  void expectAll() {
    grid_.calculateOverlappingPairs(nullptr);
    const IdPairs expected = bruteForce(proxies_);
    ASSERT_EQ(cached(cache_), expected);
    most_ = std::max(most_, expected.size());
  }

  GridBroadphase& grid() { return grid_; }
  const std::vector<btBroadphaseProxy*>& proxies() const { return proxies_; }
  std::size_t mostPairs() const { return most_; }
  Random& random() { return random_; }

 private:
  btHashedOverlappingPairCache cache_;
  GridBroadphase grid_{&cache_};
  std::vector<btBroadphaseProxy*> proxies_;
  Random random_;
  std::size_t most_ = 0;
};

TEST(GridBroadphase, HasThePairsOfBruteForceWhileBoxesComeMoveAndGo) {
  Boxes boxes(1);
  for (int i = 0; i < 400; ++i) boxes.addNear(Vec3::Zero(), 12, 0.3, 0.6);
  for (int step = 0; step < 40; ++step) {
    boxes.expectAll();
    boxes.move(0.3);
    boxes.removeOne();
    boxes.addNear(Vec3::Zero(), 12, 0.3, 0.6);
    boxes.removeOne();
  }
  EXPECT_GT(boxes.mostPairs(), 200u);
}

TEST(GridBroadphase, HasThemWhereSizesAreOneToAHundred) {
  Boxes boxes(2);
  for (int i = 0; i < 300; ++i) boxes.addNear(Vec3::Zero(), 12, 0.02, i % 10 == 0 ? 2 : 0.1);
  for (int step = 0; step < 20; ++step, boxes.move(0.5)) boxes.expectAll();
}

TEST(GridBroadphase, HasThemInSeveralPlacesFarFromEachOther) {
  Boxes boxes(3);
  for (const double far : {0.0, 1e3, 1e6, 1e9, 1e12, 1e18})
    for (int i = 0; i < 60; ++i) boxes.addNear(Vec3::Constant(far), 4, 0.5, 0.7);
  for (int step = 0; step < 20; ++step, boxes.move(0.3)) boxes.expectAll();
}

TEST(GridBroadphase, HasThemWhereAllAreInOnePlace) {
  Boxes boxes(4);
  for (int i = 0; i < 200; ++i) boxes.addNear(Vec3::Constant(-7), 0, 0.5, 0.5);
  boxes.expectAll();
  EXPECT_EQ(boxes.mostPairs(), 200u * 199 / 2);
  for (int step = 0; step < 5; ++step, boxes.move(0.5)) boxes.expectAll();
}

TEST(GridBroadphase, HasThoseOfBoxesWithoutEndAndOfPoints) {
  Boxes boxes(5);
  for (int i = 0; i < 200; ++i) boxes.addNear(Vec3::Zero(), 8, 0.0, 0.6);
  boxes.add(Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity));
  boxes.add({-kInfinity, -kInfinity, -kInfinity}, {kInfinity, 0, kInfinity}, 2, 1);
  boxes.add({-1e15, -1e15, 2}, {1e15, 1e15, 1e15}, 2, 1);
  boxes.add(Vec3::Constant(-1e300), Vec3::Constant(1e300));
  boxes.add(Vec3::Constant(1), Vec3::Constant(1));
  for (int step = 0; step < 10; ++step, boxes.move(0.3)) boxes.expectAll();
}

// What is not a number overlaps nothing, and does not disturb the others.
TEST(GridBroadphase, SurvivesABoxThatIsNotANumber) {
  Boxes boxes(6);
  for (int i = 0; i < 100; ++i) boxes.addNear(Vec3::Zero(), 5, 0.3, 0.6);
  boxes.add(Vec3::Constant(kNan), Vec3::Constant(kNan));
  boxes.expectAll();
}

TEST(GridBroadphase, PairsAsGroupsAndMasksSay) {
  Boxes boxes(7);
  for (int i = 0; i < 300; ++i) {
    const int group = 1 << (i % 3);
    boxes.addNear(Vec3::Zero(), 8, 0.3, i == 0 ? 9 : 0.6, group, group == 4 ? 3 : -1);
  }
  for (int step = 0; step < 10; ++step, boxes.move(0.3)) boxes.expectAll();
}

// Without a cache, there are no filters: as if all groups collided. Those that are narrowed are
// gone.
TEST(GridBroadphase, ListsPairsWithoutACache) {
  GridBroadphase flat(nullptr);
  Boxes boxes(5);
  for (int i = 0; i < 500; ++i) boxes.addNear(Vec3::Zero(), 8, 0.3, i == 0 ? 9 : 0.6);
  std::vector<btBroadphaseProxy*> proxies;
  for (const btBroadphaseProxy* const box : boxes.proxies())
    proxies.push_back(flat.createProxy(box->m_aabbMin, box->m_aabbMax, 0,
                                       asClient(static_cast<std::uint32_t>(proxies.size() + 1)), 1,
                                       1, nullptr));
  ThreadPool pool(2);
  flat.setThreads(&pool);
  flat.calculateOverlappingPairs(nullptr);
  const auto listed = [&] {
    IdPairs found;
    for (std::size_t range = 0; range < flat.ranges(); ++range)
      flat.forEachPairIn(range, [&](std::uint32_t x, std::uint32_t y) {
        EXPECT_TRUE(found.insert(std::minmax(static_cast<int>(x), static_cast<int>(y))).second);
      });
    return found;
  };
  const IdPairs all = listed();
  for (const auto& pair : bruteForce(proxies)) EXPECT_TRUE(all.contains(pair));
  const auto isKept = [](std::uint32_t x, std::uint32_t y) { return (x + y) % 3 != 0; };
  flat.narrow(isKept);
  IdPairs kept;
  for (const auto& [x, y] : all)
    if (isKept(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))) kept.insert({x, y});
  EXPECT_EQ(listed(), kept);
}

// Cells cost memory in proportion to the boxes, wherever these are.
TEST(GridBroadphase, StaysSmallWhereverBoxesAre) {
  CellGrid grid(BoxContent::Anything);
  std::vector<btBroadphaseProxy> boxes(1000);
  std::vector<btBroadphaseProxy*> pointers;
  Random random(8);
  for (auto& box : boxes) {
    const btVector3 at = toBullet(random.uniform(0, 1e9) * random.direction());
    box.m_aabbMin = at - btVector3(0.5, 0.5, 0.5);
    box.m_aabbMax = at + btVector3(0.5, 0.5, 0.5);
    pointers.push_back(&box);
  }
  ThreadPool alone;
  grid.sort(pointers, alone);
  EXPECT_LE(grid.cells(), 2048u);
}

struct Rays : btBroadphaseRayCallback {
  IdPairs hit;
  Rays(const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    for (int k = 0; k < 3; ++k) {
      m_rayDirectionInverse[k] = way[k] == 0 ? 1e18 : 1 / way[k];
      m_signs[k] = m_rayDirectionInverse[k] < 0 ? 1 : 0;
    }
    m_lambda_max = 1;
  }
  bool process(const btBroadphaseProxy* proxy) override {
    hit.emplace(proxy->getUid(), 0);
    return true;
  }
};

struct Inside : btBroadphaseAabbCallback {
  IdPairs hit;
  bool process(const btBroadphaseProxy* proxy) override {
    hit.emplace(proxy->getUid(), 0);
    return true;
  }
};

/// Whether a box is on the way from `from` to `to`: a slab for each axis.
bool isOnRay(const btBroadphaseProxy& box, const Vec3& from, const Vec3& to) {
  double enters = 0;
  double leaves = 1;
  for (int k = 0; k < 3; ++k) {
    double near = (box.m_aabbMin[k] - from[k]) / (to[k] - from[k]);
    double far = (box.m_aabbMax[k] - from[k]) / (to[k] - from[k]);
    if (near > far) std::swap(near, far);
    enters = std::max(enters, near);
    leaves = std::min(leaves, far);
  }
  return enters <= leaves;
}

TEST(GridBroadphase, AnswersRaysAndBoxes) {
  Boxes boxes(9);
  for (int i = 0; i < 200; ++i) boxes.addNear(Vec3::Zero(), 10, 0.2, 0.8);
  for (int round = 0; round < 50; ++round) {
    const Vec3 from = 12 * boxes.random().direction();
    const Vec3 to = 12 * boxes.random().direction();
    Rays rays(from, to);
    boxes.grid().rayTest(toBullet(from), toBullet(to), rays, {0, 0, 0}, {0, 0, 0});
    Inside inside;
    const Vec3 low = from.cwiseMin(to);
    const Vec3 high = from.cwiseMax(to);
    boxes.grid().aabbTest(toBullet(low), toBullet(high), inside);
    for (const btBroadphaseProxy* const box : boxes.proxies()) {
      const std::pair id{box->getUid(), 0};
      EXPECT_EQ(rays.hit.contains(id), isOnRay(*box, from, to));
      bool isIn = true;
      for (int k = 0; k < 3; ++k)
        isIn &= box->m_aabbMin[k] <= high[k] && box->m_aabbMax[k] >= low[k];
      EXPECT_EQ(inside.hit.contains(id), isIn);
    }
  }
  btVector3 low;
  btVector3 high;
  boxes.grid().getBroadphaseAabb(low, high);
  for (const btBroadphaseProxy* const box : boxes.proxies())
    for (int k = 0; k < 3; ++k)
      EXPECT_TRUE(low[k] <= box->m_aabbMin[k] && box->m_aabbMax[k] <= high[k]);
}

/// Bullet as it comes, with a broadphase of one's choice: balls fall into a box without a lid.
class BulletWorld {
 public:
  explicit BulletWorld(btBroadphaseInterface& broadphase)
      : world_(&dispatcher_, &broadphase, &solver_, &configuration_) {
    world_.setGravity({0, -9.81, 0});
    addWall({1, 0, 0}, -6);
    addWall({-1, 0, 0}, -6);
    addWall({0, 0, 1}, -6);
    addWall({0, 0, -1}, -6);
    addBody(ground_, 0, {0, -5, 0});
    for (int i = 0; i < 200; ++i)
      addBody(ball_, 1, {-4.0 + i % 7 * 1.3, 1.0 + i / 49 * 1.3, -4.0 + i / 7 % 7 * 1.3});
  }
  ~BulletWorld() {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;

  void step() { world_.stepSimulation(1.0 / 60, 0); }

  std::vector<btBroadphaseProxy*> proxies() const {
    std::vector<btBroadphaseProxy*> all;
    for (const auto& body : bodies_) all.push_back(body->getBroadphaseHandle());
    return all;
  }
  std::size_t inTheBox() const {
    std::size_t count = 0;
    for (const auto& body : bodies_) {
      const btVector3& x = body->getWorldTransform().getOrigin();
      count += body->getMass() > 0 && std::abs(x.x()) <= 6 && std::abs(x.z()) <= 6 &&
               x.y() >= 0.4 && x.y() <= 8;
    }
    return count;
  }
  double fastest() const {
    double speed = 0;
    for (const auto& body : bodies_) speed = std::max(speed, body->getLinearVelocity().length());
    return speed;
  }

 private:
  void addBody(btCollisionShape& shape, double mass, const btVector3& at) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape.calculateLocalInertia(mass, inertia);
    bodies_.push_back(std::make_unique<btRigidBody>(mass, nullptr, &shape, inertia));
    bodies_.back()->setWorldTransform(btTransform(btQuaternion::getIdentity(), at));
    bodies_.back()->setFriction(0.5);
    bodies_.back()->setRollingFriction(0.05);
    world_.addRigidBody(bodies_.back().get());
  }
  void addWall(const btVector3& normal, double constant) {
    walls_.push_back(std::make_unique<btStaticPlaneShape>(normal, constant));
    addBody(*walls_.back(), 0, {0, 0, 0});
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btSequentialImpulseConstraintSolver solver_;
  btBoxShape ground_{btVector3(50, 5, 50)};
  btSphereShape ball_{0.5};
  std::vector<std::unique_ptr<btStaticPlaneShape>> walls_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  btDiscreteDynamicsWorld world_;
};

// Stock Bullet has at every step the pairs that brute force finds. btDbvtBroadphase has them, too,
// and for some steps more those whose boxes have parted, which it looks for little by little.
TEST(GridBroadphase, ServesStockBullet) {
  btHashedOverlappingPairCache cache;
  GridBroadphase grid(&cache);
  btDbvtBroadphase tree;
  {
    BulletWorld onGrid(grid);
    BulletWorld onTree(tree);
    for (int step = 0; step < 600; ++step) {
      onGrid.step();
      onTree.step();
      // A step moves the balls after it has found their pairs.
      if (step % 10 != 0) continue;
      grid.calculateOverlappingPairs(nullptr);
      ASSERT_EQ(cached(cache), bruteForce(onGrid.proxies())) << "step " << step;
      const IdPairs ofTree = cached(*tree.getOverlappingPairCache());
      for (const auto& pair : bruteForce(onTree.proxies()))
        ASSERT_TRUE(ofTree.contains(pair)) << "step " << step;
    }
    for (const BulletWorld* const world : {&onGrid, &onTree}) {
      EXPECT_EQ(world->inTheBox(), 200u);
      EXPECT_LT(world->fastest(), 0.1) << "m/s: at rest but for the solver's noise";
    }
  }
  EXPECT_EQ(cache.getNumOverlappingPairs(), 0) << "the bodies took their pairs with them";
}

}  // namespace
}  // namespace wells
