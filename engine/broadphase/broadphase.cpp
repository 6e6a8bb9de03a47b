#include "broadphase/broadphase.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <algorithm>
#include <cmath>

#include "broadphase/grid_broadphase.h"

// Bullet's two builds share their headers; a forgotten BT_USE_DOUBLE_PRECISION would link and then
// read floats as doubles.
static_assert(sizeof(btScalar) == sizeof(double), "the broadphase needs Bullet's double build");

namespace wells {
namespace {

// What is added to a swept box, in radii. Larger: fewer proxies move, more pairs are listed.
// T1 with 10,000 balls, 300 steps: see README.md, "Benchmark".
constexpr double kFattening = 0.5;
// Steps: by how many of its motion a box that is set anew reaches ahead. T2 with 10,000 balls: 7.1
// ms a step with 0, 4.1 with 4, 4.5 with 8; T1 does not mind.
constexpr double kAhead = 4;
// The same for the grid, where one ball that leaves its sphere means that all are set anew. A list
// that serves few steps is not worth the pairs that the skin adds: after one that did not, none has
// a skin for a while. 10,000 balls, ms a step without and with skin: T1 after 200 steps 1.3 and
// 0.6, T2 1.0 and 0.4; T1 after 60 steps, where all fly and are hit, 1.1 and 1.7.
constexpr double kSkin = 0.4;
constexpr double kSkinSteps = 4;
constexpr int kFewSteps = 3;
constexpr int kListsWithoutSkin = 30;
// Nor is it worth more pairs than so many a ball: T1 with 100,000 balls, all of which fly after 30
// steps, had 32 in the step that tried a skin, and 5 without.
constexpr double kMostPairsWithSkin = 16;
// Cells are as large as the largest balls, so that one may hold as many as the cube of this times
// more small ones. 10,000 balls, half filling their space, all of which move: up to a ratio of 8
// the grid took 2.0 to 2.8 ms a step and the tree more than 100, but a tenth were large; a few
// large ones among many small cost the grid most.
constexpr double kMostUnequalRadii = 3;
// Each ball that is removed costs a look at all pairs; of more at once, those that stay are built
// afresh.
constexpr std::size_t kMostRemoved = 16;

btVector3 toBullet(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

// Which ball a proxy stands for is kept in Bullet's user pointer.
void* asClient(std::uint32_t ball) {
  return reinterpret_cast<void*>(std::uintptr_t{ball});
}

std::uint32_t ballOf(const btBroadphaseProxy* proxy) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(proxy->m_clientObject));
}

double cubeOf(double x) {
  return x * x * x;
}

/// The sphere around which a ball's pairs are known.
struct KnownSphere {
  Vec3 center = Vec3::Zero();  // m
  double radius = 0;           // m
};

}  // namespace

BroadphaseKind broadphaseFor(std::span<const double> radii) {
  if (radii.empty()) return BroadphaseKind::Grid;
  const auto [least, most] = std::ranges::minmax(radii);
  return most <= kMostUnequalRadii * least ? BroadphaseKind::Grid : BroadphaseKind::Tree;
}

struct Broadphase::Proxies {
  std::unique_ptr<btDbvtBroadphase> tree;  // either this
  std::unique_ptr<GridBroadphase> grid;    // or that
  btBroadphaseInterface* broadphase = nullptr;
  std::vector<btBroadphaseProxy*> ofBall;  // null: not finite, in no pair
  std::vector<KnownSphere> spheres;        // by ball, of the grid
  int stepsServed = kFewSteps;             // by the present list
  int listsWithoutSkin = 0;                // that are to follow
  double volume = 0;  // m^3, of the spheres of the present list, all but a factor
  BroadphaseKind chosen;

  explicit Proxies(const World& world)
      : ofBall(world.balls.size(), nullptr), chosen(world.settings.broadphase) {
    const BroadphaseKind kind =
        chosen == BroadphaseKind::Auto ? broadphaseFor(world.balls.radius) : chosen;
    if (kind == BroadphaseKind::Tree) {
      tree = std::make_unique<btDbvtBroadphase>();
      tree->m_deferedcollide = true;  // one pass over the trees instead of one per proxy
      broadphase = tree.get();
    } else {
      grid = std::make_unique<GridBroadphase>(nullptr, BoxContent::Spheres);
      broadphase = grid.get();
      spheres.resize(world.balls.size());
    }
  }
  Proxies(const Proxies&) = delete;
  Proxies& operator=(const Proxies&) = delete;

  // Bullet leaves proxies to whoever created them. The pairs go first, because each proxy would
  // search all of them for its own.
  ~Proxies() {
    broadphase->getOverlappingPairCache()->getOverlappingPairArray().clear();
    for (auto* const proxy : ofBall)
      if (proxy) broadphase->destroyProxy(proxy, nullptr);
  }

  btBroadphaseProxy* add(const Vec3& low, const Vec3& high, std::uint32_t ball) {
    return broadphase->createProxy(toBullet(low), toBullet(high), 0, asClient(ball), 1, 1, nullptr);
  }

  /// Whether the list that is made next is to serve several steps.
  bool nextHasSkin() {
    if (listsWithoutSkin > 0)
      --listsWithoutSkin;
    else if (stepsServed < kFewSteps)
      listsWithoutSkin = kListsWithoutSkin;
    stepsServed = 1;
    return listsWithoutSkin == 0;
  }

  /// Whether nothing that a ball meets within `radius` of its place can be missing.
  bool isKnown(std::uint32_t ball, const Vec3& position, double radius) const {
    const KnownSphere& sphere = spheres[ball];
    const double margin = sphere.radius - radius;
    return margin >= 0 && squaredLength(position - sphere.center) <= margin * margin;
  }
};

Broadphase::Broadphase() = default;
Broadphase::~Broadphase() = default;

void Broadphase::build(const World& world) {
  proxies_ = std::make_unique<Proxies>(world);
  list();
}

bool Broadphase::isBuiltFor(const World& world) const {
  return proxies_ && proxies_->ofBall.size() == world.balls.size() &&
         proxies_->chosen == world.settings.broadphase &&
         (removed_ <= kMostRemoved || proxies_->grid);
}

void Broadphase::remove(std::span<const std::uint32_t> balls) {
  if (!proxies_ || balls.empty()) return;
  arePairsOld_ = true;
  removed_ += balls.size();
  if (removed_ > kMostRemoved && proxies_->tree) return;
  for (const std::uint32_t i : balls) removeProxy(i);
}

void Broadphase::removeProxy(std::uint32_t ball) {
  btBroadphaseProxy*& proxy = proxies_->ofBall[ball];
  if (!proxy) return;
  proxies_->broadphase->destroyProxy(proxy, nullptr);
  proxy = nullptr;
  ++moved_;
}

void Broadphase::update(const World& world, std::span<const double> reach,
                        std::span<const std::uint32_t> among, ThreadPool* threads) {
  if (!isBuiltFor(world)) build(world);
  if (proxies_->grid) proxies_->grid->setThreads(threads);
  removed_ = 0;
  moved_ = 0;
  if (proxies_->grid)
    updateSpheres(world, reach, among);
  else
    updateBoxes(world, reach, among);
  // Boxes that stand where they stood have the pairs that they had.
  if (moved_ == 0 && !arePairsOld_) return;
  proxies_->broadphase->calculateOverlappingPairs(nullptr);
  list();
  arePairsOld_ = false;
}

void Broadphase::updateBoxes(const World& world, std::span<const double> reach,
                             std::span<const std::uint32_t> among) {
  const Balls& balls = world.balls;
  for (const std::uint32_t i : among) {
    btBroadphaseProxy*& proxy = proxies_->ofBall[i];
    if (!isFinite(balls.position[i]) || !std::isfinite(reach[i])) {
      removeProxy(i);
      continue;
    }
    const double half = balls.radius[i] + reach[i];
    const Vec3 swept = Vec3::Constant(half);
    const Vec3 fat = Vec3::Constant(half + kFattening * balls.radius[i]);
    const Vec3& x = balls.position[i];
    const Vec3 ahead = balls.velocity[i] * (kAhead * world.settings.dt);
    const Vec3 fatLow = x - fat + ahead.cwiseMin(0);
    const Vec3 fatHigh = x + fat + ahead.cwiseMax(0);
    if (!proxy) {
      proxy = proxies_->add(fatLow, fatHigh, i);
      ++moved_;
      continue;
    }
    const btVector3 low = toBullet(x - swept);
    const btVector3 high = toBullet(x + swept);
    const bool inside = low.x() >= proxy->m_aabbMin.x() && high.x() <= proxy->m_aabbMax.x() &&
                        low.y() >= proxy->m_aabbMin.y() && high.y() <= proxy->m_aabbMax.y() &&
                        low.z() >= proxy->m_aabbMin.z() && high.z() <= proxy->m_aabbMax.z();
    if (inside) continue;
    proxies_->broadphase->setAabb(proxy, toBullet(fatLow), toBullet(fatHigh), nullptr);
    ++moved_;
  }
}

void Broadphase::updateSpheres(const World& world, std::span<const double> reach,
                               std::span<const std::uint32_t> among) {
  const Balls& balls = world.balls;
  const auto isIn = [&](std::uint32_t i) {
    return isFinite(balls.position[i]) && std::isfinite(reach[i]);
  };
  const bool areKnown = std::ranges::all_of(among, [&](std::uint32_t i) {
    return isIn(i) == (proxies_->ofBall[i] != nullptr) &&
           (!isIn(i) || proxies_->isKnown(i, balls.position[i], balls.radius[i] + reach[i]));
  });
  if (areKnown) {
    ++proxies_->stepsServed;
    return;
  }
  const auto radiusOf = [&](std::uint32_t i, bool hasSkin) {
    const double skin =
        kSkin * balls.radius[i] + kSkinSteps * world.settings.dt * length(balls.velocity[i]);
    return balls.radius[i] + reach[i] + (hasSkin ? skin : 0);
  };
  // As many pairs a volume as there were, about.
  const auto pairsOf = [&](double volume) {
    return static_cast<double>(ballPairs_.size()) * volume / proxies_->volume;
  };
  bool hasSkin = proxies_->nextHasSkin();
  if (hasSkin && proxies_->volume > 0) {
    double volume = 0;
    for (const std::uint32_t i : among)
      if (isIn(i)) volume += cubeOf(radiusOf(i, true));
    hasSkin = pairsOf(volume) <= kMostPairsWithSkin * static_cast<double>(among.size());
  }
  proxies_->volume = 0;
  for (const std::uint32_t i : among) {
    if (!isIn(i)) {
      removeProxy(i);
      continue;
    }
    const Vec3& x = balls.position[i];
    const double radius = radiusOf(i, hasSkin);
    proxies_->volume += cubeOf(radius);
    proxies_->spheres[i] = {x, radius};
    const Vec3 low = x - Vec3::Constant(radius);
    const Vec3 high = x + Vec3::Constant(radius);
    ++moved_;
    if (btBroadphaseProxy*& proxy = proxies_->ofBall[i]; !proxy)
      proxy = proxies_->add(low, high, i);
    else
      proxies_->broadphase->setAabb(proxy, toBullet(low), toBullet(high), nullptr);
  }
}

void Broadphase::findIn(const Vec3& low, const Vec3& high,
                        std::vector<std::uint32_t>& found) const {
  struct Collector : btBroadphaseAabbCallback {
    std::vector<std::uint32_t>* found = nullptr;
    bool process(const btBroadphaseProxy* proxy) override {
      found->push_back(ballOf(proxy));
      return true;
    }
  } collector;
  collector.found = &found;
  proxies_->broadphase->aabbTest(toBullet(low), toBullet(high), collector);
}

void Broadphase::list() {
  const auto add = [&](std::uint32_t x, std::uint32_t y) { sorter_.add(x, y); };
  if (const GridBroadphase* const grid = proxies_->grid.get()) {
    sorter_.begin(proxies_->ofBall.size(), grid->pairs());
    grid->forEachPair(add, add);
  } else {
    const btBroadphasePairArray& pairs =
        proxies_->broadphase->getOverlappingPairCache()->getOverlappingPairArray();
    sorter_.begin(proxies_->ofBall.size(), static_cast<std::size_t>(pairs.size()));
    for (int n = 0; n < pairs.size(); ++n)
      sorter_.add(ballOf(pairs[n].m_pProxy0), ballOf(pairs[n].m_pProxy1));
  }
  sorter_.finish(ballPairs_);
}

}  // namespace wells
