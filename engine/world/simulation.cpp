#include "world/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "broadphase/broadphase.h"
#include "world/advance.h"
#include "world/book_keeper.h"
#include "world/contact_choice.h"
#include "world/exact_flight.h"
#include "world/islands.h"

namespace wells {
namespace {

bool before(const Contact& x, const Contact& y) {
  return x.a != y.a ? x.a < y.a : x.b < y.b;
}

/// Takes over the impulses of the contacts that were there in the step before, times `scale`; calls
/// appeared(contact) for the others. Both lists are in order.
template <class Appeared>
void warmStartFrom(const std::vector<Contact>& old, double scale, std::vector<Contact>& contacts,
                   Appeared appeared) {
  auto match = old.begin();
  for (Contact& c : contacts) {
    while (match != old.end() && before(*match, c)) ++match;
    if (match == old.end() || match->a != c.a || match->b != c.b) {
      appeared(c);
      continue;
    }
    c.impact = match->impact;
    c.normalImpulse = scale * match->normalImpulse;
    c.tangentImpulse = scale * match->tangentImpulse;
  }
}

void remember(const std::vector<Contact>& contacts, std::vector<StepperMemory::Contact>& memory) {
  memory.clear();
  for (const Contact& c : contacts)
    memory.push_back({c.a, c.b, c.impact, c.normalImpulse, c.tangentImpulse});
}

void recall(const std::vector<StepperMemory::Contact>& memory, std::vector<Contact>& contacts) {
  contacts.clear();
  for (const StepperMemory::Contact& c : memory)
    contacts.push_back({.a = c.a,
                        .b = c.b,
                        .impact = c.impact,
                        .normalImpulse = c.normalImpulse,
                        .tangentImpulse = c.tangentImpulse});
}

class Simulation : public Stepper {
 public:
  std::string name() const override { return "ours"; }
  std::string integrator() const override {
    return integrator_ ? std::string(integrator_->name) : "";
  }
  std::string contactMethod() const override { return std::string(wells::name(method_)); }
  StepCounts counts() const override { return counts_; }
  std::span<const std::uint32_t> quarantined() const override { return quarantined_; }

  bool openBooks() override {
    keeper_.open();
    exact_.openBooks();
    return true;
  }

  const Books* books() const override { return keeper_.books(); }

  void step(World& world) override {
    const Integrator& integrator = findIntegrator(world.settings.integrator);
    updateField(world, world.step, field_);
    keeper_.beginStep(world, field_);
    findReaches(world);
    std::swap(plan_.ballContacts, oldBallContacts_);
    std::swap(plan_.arenaContacts, oldArenaContacts_);
    start_ = world.balls;
    inSubsteps_.resize(world.balls.size(), 0);
    // A ball that is thrown beyond its reach may have missed a pair: the step starts over with a
    // larger one. Reaches at least double each time, so that ends.
    for (int attempts = 1;
         !attempt(world, integrator, methodOf(world.settings, field_, integrator, attempts));
         ++attempts)
      world.balls = start_;
    std::swap(inSubsteps_, nextInSubsteps_);
    ++world.step;
    lastSubstep_ = world.settings.dt / world.settings.substeps;
    keeper_.endStep(world, field_, stepBooks_);
    stepped_ = true;
    integrator_ = &integrator;
    method_ = world.settings.contactMethod;
    findQuarantined(world.balls);
  }

  const StepperMemory* memory() const override {
    remember(plan_.ballContacts, memory_.ballContacts);
    remember(plan_.arenaContacts, memory_.arenaContacts);
    memory_.substep = lastSubstep_;
    memory_.inSubsteps = inSubsteps_;
    return &memory_;
  }

  void restore(const StepperMemory& memory) override {
    recall(memory.ballContacts, plan_.ballContacts);
    recall(memory.arenaContacts, plan_.arenaContacts);
    lastSubstep_ = memory.substep;
    inSubsteps_ = memory.inSubsteps;
    stepped_ = lastSubstep_ > 0;
  }

 private:
  /// One step with the present reaches. False: one was too short and has been enlarged.
  bool attempt(World& world, const Integrator& integrator, ContactMethod method) {
    counts_ = {};
    stepBooks_ = {};
    counts_.flightStretches = field_.stretches;
    planContacts(world);
    isDone_.assign(world.balls.size(), 0);
    nextInSubsteps_.assign(world.balls.size(), 0);
    const StepInput input(world, field_, integrator);
    if (method != ContactMethod::Substep && !moveByEvents(input, method, world)) return false;
    startFromOldImpulses(world);
    planFlights(world);
    counts_.substepBalls = static_cast<std::int64_t>(plan_.touching.size());
    advance(world.settings, input.model, plan_, world.balls,
            keeper_.books() ? &stepBooks_ : nullptr);
    return enlargeReaches(world) == 0;
  }

  /// A ball whose state is not finite gets no reach: it is in no pair and is not moved.
  void findReaches(const World& world) {
    const Balls& balls = world.balls;
    reach_.resize(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i)
      reach_[i] = isFinite(balls.state(i))
                      ? reachOf(field_, balls.state(i), balls.radius[i], world.settings.dt)
                      : std::numeric_limits<double>::quiet_NaN();
  }

  void findQuarantined(const Balls& balls) {
    quarantined_.clear();
    for (std::uint32_t i = 0; i < balls.size(); ++i)
      if (!isFinite(balls.state(i))) quarantined_.push_back(i);
  }

  /// All islands that go by exact impacts. False: a reach was too short and has been enlarged.
  bool moveByEvents(const StepInput& input, ContactMethod method, World& world) {
    Balls& balls = world.balls;
    islands_.find(plan_.ballContacts, plan_.arenaContacts, balls.size());
    for (std::size_t n = 0; n < islands_.count(); ++n) {
      const auto island = islands_.balls(n);
      if (std::any_of(island.begin(), island.end(), [&](auto i) { return isLeaning_[i] != 0; }))
        continue;
      if (method == ContactMethod::Auto && isCrowd(world.settings, island, balls, inSubsteps_)) {
        for (const std::uint32_t i : island) nextInSubsteps_[i] = 1;
        continue;
      }
      const IslandFate fate = exact_.run(input, island, islands_.pairs(n), reach_, balls);
      if (fate == IslandFate::TooFar) return false;
      if (fate == IslandFate::TooMany && method == ContactMethod::Exact) giveUp(world, island);
      if (fate != IslandFate::Done) {
        ++counts_.handedOver;
        continue;
      }
      for (const std::uint32_t i : island) isDone_[i] = 1;
      stepBooks_ += exact_.books();
      counts_.impacts += exact_.counts().impacts;
      counts_.clusters += exact_.counts().clusters;
      counts_.exactBalls += static_cast<std::int64_t>(island.size());
    }
    const auto isDone = [&](const Contact& c) { return isDone_[c.a] != 0; };
    std::erase_if(plan_.ballContacts, isDone);
    std::erase_if(plan_.arenaContacts, isDone);
    return true;
  }

  [[noreturn]] void giveUp(World& world, std::span<const std::uint32_t> island) {
    world.balls = start_;
    throw std::runtime_error(fmt::format(
        "step {}: ball {} and {} others that may meet it have more than {} elastic impacts in one "
        "step; allow more (MostImpacts), make Dt shorter, or let ContactMethod auto choose",
        world.step, island[0], island.size() - 1, world.settings.mostImpacts));
  }

  /// How many balls went further than their reach; theirs are enlarged.
  std::size_t enlargeReaches(const World& world) {
    const Balls& balls = world.balls;
    std::size_t enlarged = 0;
    for (std::size_t i = 0; i < balls.size(); ++i)
      if (isBeyondReach(start_.position[i], balls.state(i), world.settings.dt, reach_[i]))
        ++enlarged;
    return enlarged;
  }

  void planContacts(const World& world) {
    broadphase_.update(world, reach_);
    collectBallContacts(world);
    collectArenaContacts(world);
    counts_.contacts =
        static_cast<std::int64_t>(plan_.ballContacts.size() + plan_.arenaContacts.size());
  }

  void startFromOldImpulses(const World& world) {
    // What rests needs the same force, and so an impulse in proportion to the substep.
    const double substep = world.settings.dt / world.settings.substeps;
    const double scale = lastSubstep_ > 0 ? substep / lastSubstep_ : 1;
    warmStartFrom(oldBallContacts_, scale, plan_.ballContacts, [&](const Contact& c) {
      // Already deep in overlap and never announced: the broadphase, or our bound on how far a
      // ball moves, has missed it. Other peers' balls jump when their states arrive.
      Contact now = c;
      touchBalls(world.balls, now);
      const double tolerated = kLateOverlap * (world.balls.radius[c.a] + world.balls.radius[c.b]);
      if (stepped_ && now.gap < -tolerated && world.owns(c.a) && world.owns(c.b))
        ++counts_.latePairs;
    });
    warmStartFrom(oldArenaContacts_, scale, plan_.arenaContacts, [](const Contact&) {});
  }

  void collectBallContacts(const World& world) {
    const Balls& balls = world.balls;
    plan_.ballContacts.clear();
    sortedPairs_.clear();
    isLeaning_.assign(balls.size(), 0);
    for (const BallPair& pair : broadphase_.ballPairs()) {
      const double touching = balls.radius[pair.a] + balls.radius[pair.b];
      const double squared = squaredLength(balls.position[pair.b] - balls.position[pair.a]);
      // A contact between other peers' balls is theirs to compute. Here such balls only stop
      // falling: what holds them is not known.
      if (!world.owns(pair.a) && !world.owns(pair.b)) {
        const double leaning = touching * (1 + kLeaningGap);
        if (squared < leaning * leaning) isLeaning_[pair.a] = isLeaning_[pair.b] = 1;
        continue;
      }
      const double bound = touching + reach_[pair.a] + reach_[pair.b];
      if (squared > bound * bound) continue;
      sortedPairs_.push_back(std::uint64_t{pair.a} << 32 | pair.b);
    }
    // The broadphase's order depends on its history; ours must not.
    std::sort(sortedPairs_.begin(), sortedPairs_.end());
    for (const std::uint64_t pair : sortedPairs_)
      plan_.ballContacts.push_back(
          {.a = static_cast<std::uint32_t>(pair >> 32), .b = static_cast<std::uint32_t>(pair)});
    counts_.candidatePairs =
        static_cast<std::int64_t>(broadphase_.ballPairs().size() + broadphase_.nearGround().size() +
                                  broadphase_.nearWall().size());
  }

  void collectArenaContacts(const World& world) {
    plan_.arenaContacts.clear();
    const auto collect = [&](const std::vector<std::uint32_t>& candidates, std::uint32_t partner) {
      for (const std::uint32_t i : candidates)
        if (mayTouchArena(world.arena, world.balls.position[i], world.balls.radius[i], reach_[i],
                          partner))
          plan_.arenaContacts.push_back({.a = i, .b = partner});
    };
    collect(broadphase_.nearWall(), kWall);
    collect(broadphase_.nearGround(), kGround);
    auto& contacts = plan_.arenaContacts;
    std::sort(contacts.begin(), contacts.end(), before);
    // A ball near two pieces of the wall stands twice.
    contacts.erase(
        std::unique(contacts.begin(), contacts.end(),
                    [](const Contact& x, const Contact& y) { return x.a == y.a && x.b == y.b; }),
        contacts.end());
  }

  void planFlights(const World& world) {
    isTouching_.assign(world.balls.size(), 0);
    for (const Contact& c : plan_.ballContacts) isTouching_[c.a] = isTouching_[c.b] = 1;
    for (const Contact& c : plan_.arenaContacts) isTouching_[c.a] = 1;
    plan_.free.clear();
    plan_.touching.clear();
    plan_.drifting.clear();
    for (std::uint32_t i = 0; i < isTouching_.size(); ++i) {
      if (isDone_[i] || std::isnan(reach_[i])) continue;
      auto& list = isLeaning_[i] ? plan_.drifting : isTouching_[i] ? plan_.touching : plan_.free;
      list.push_back(i);
    }
  }

  static constexpr double kLateOverlap = 1e-6;  // of the sum of radii
  static constexpr double kLeaningGap = 0.05;   // of the sum of radii

  Field field_;
  Broadphase broadphase_;
  Islands islands_;
  ExactFlight exact_;
  Balls start_;  // at the start of the step
  StepPlan plan_;
  StepCounts counts_;
  BookKeeper keeper_;
  Books stepBooks_;                         // of the attempt at hand
  const Integrator* integrator_ = nullptr;  // of the last step
  ContactMethod method_ = ContactMethod::Substep;
  bool stepped_ = false;
  double lastSubstep_ = 0;     // s
  std::vector<double> reach_;  // m, by ball
  std::vector<std::uint64_t> sortedPairs_;
  std::vector<std::uint8_t> isDone_;  // flown through their impacts
  std::vector<std::uint8_t> isTouching_;
  std::vector<std::uint8_t> isLeaning_;  // ghosts that touch ghosts
  std::vector<Contact> oldBallContacts_;
  std::vector<Contact> oldArenaContacts_;
  std::vector<std::uint8_t> inSubsteps_;      // by ball, see StepperMemory
  std::vector<std::uint8_t> nextInSubsteps_;  // of the step at hand
  std::vector<std::uint32_t> quarantined_;
  mutable StepperMemory memory_;  // made when asked for
};

}  // namespace

std::unique_ptr<Stepper> makeSimulation() {
  return std::make_unique<Simulation>();
}

}  // namespace wells
