#include "world/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "math/components.h"
#include "threads/thread_pool.h"
#include "world/advance.h"
#include "world/book_keeper.h"
#include "world/candidates.h"
#include "world/contact_choice.h"
#include "world/contact_memory.h"
#include "world/crowd.h"
#include "world/exact_flight.h"
#include "world/islands.h"
#include "world/late_pairs.h"
#include "world/reaches.h"
#include "world/sleep.h"

namespace wells {
namespace {

class Simulation : public Stepper {
 public:
  explicit Simulation(const SimulationOptions& options) : options_(options) {}

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

  bool openStageClock() override {
    clock_ = std::make_unique<StageClock>();
    plan_.workspace.clock = clock_.get();
    crowd_.setClock(clock_.get());
    return true;
  }

  const StageTimes* stageTimes() const override { return clock_ ? &clock_->times() : nullptr; }

  void step(World& world) override {
    if (clock_) clock_->begin();
    const Integrator& integrator = findIntegrator(world.settings.integrator);
    updateField(world, world.step, field_);
    StageScope stage(clock_.get(), Stage::Sleep);
    sleep_.begin(world, field_, contactMemory_);
    stage.next(Stage::Books);
    keeper_.beginStep(world, field_);
    stage.next(Stage::Sleep);
    sleep_.wakeAhead(world, field_, contactMemory_);
    stage.next(Stage::Other);
    makeRoom(world.balls.size());
    chooseThreads();
    prepare(world, sleep_.awake());
    method_ = methodOf(world.settings, field_, integrator);
    try {
      tryUntilComplete(world, integrator);
    } catch (...) {
      startOver(world.balls);
      throw;
    }
    commit(world, integrator);
  }

  const StepperMemory* memory() const override {
    ContactMemory contacts = contactMemory_;
    sleep_.save(memory_.rest, contacts);
    contacts.save(memory_);
    memory_.stepsInSubsteps = stepsInSubsteps_;
    return &memory_;
  }

  void restore(const StepperMemory& memory) override {
    contactMemory_.restore(memory);
    sleep_.restore(memory.rest, contactMemory_);
    stepsInSubsteps_ = memory.stepsInSubsteps;
  }

 private:
  /// A ball that is thrown beyond its reach may have missed a pair: the step then starts over with
  /// a larger one. Reaches at least double each time, so that ends. So it does where a ball may
  /// have touched one that sleeps, who then takes part.
  void tryUntilComplete(World& world, const Integrator& integrator) {
    for (int attempts = 1;;) {
      const bool isComplete = attempt(world, integrator, attempts);
      if (!isComplete) ++attempts;
      if (!sleep_.wakeAround(world, start_, field_, contactMemory_) && isComplete) return;
      prepare(world, sleep_.woken());
      startOver(world.balls);
    }
  }

  void makeRoom(std::size_t balls) {
    start_.resize(balls);
    reach_.resize(balls);
    stepsInSubsteps_.resize(balls, 0);
    nextStepsInSubsteps_.resize(balls, 0);
    isDone_.resize(balls);
    isTouching_.resize(balls);
  }

  /// Those of several are started by the first step that has enough balls awake.
  void chooseThreads() {
    const bool areMany = sleep_.awake().size() >= options_.leastBallsForThreads;
    if (areMany && options_.threads > 1 && !many_) many_.emplace(options_.threads);
    pool_ = areMany && many_ ? &*many_ : &one_;
  }

  void prepare(const World& world, std::span<const std::uint32_t> balls) {
    pool_->forRanges(balls.size(), kLeastRange,
                     [&](std::size_t begin, std::size_t end, std::size_t) {
                       const auto part = balls.subspan(begin, end - begin);
                       for (const std::uint32_t i : part) start_[i] = world.balls.state(i);
                       reachesOf(field_, world.balls, part, world.settings.dt, reach_);
                     });
  }

  void startOver(Balls& balls) const {
    for (const std::uint32_t i : sleep_.awake()) balls.setState(i, start_[i]);
  }

  /// One step with the present reaches. False: one was too short and has been enlarged.
  bool attempt(World& world, const Integrator& integrator, int attempts) {
    counts_ = {};
    stepBooks_ = {};
    counts_.flightStretches = field_.stretches;
    counts_.threads = pool_->threads();
    findPairs(world);
    const StepInput input(world, field_, integrator);
    const bool mayHandOver = attempts > kMostExactAttempts && !isLossless(world.settings);
    const auto lastResort = mayHandOver ? WhenTooFar::HandOver : WhenTooFar::StartOver;
    if (method_ != ContactMethod::Substep && !moveByEvents(input, lastResort, world)) return false;
    moveCrowds(input, world);
    planSmallIslands(world);
    planFlights();
    const ResolvedCounts resolved = advance(world.settings, input.model, plan_, world.balls, *pool_,
                                            keeper_.books() ? &stepBooks_ : nullptr);
    counts_.substepBalls += static_cast<std::int64_t>(plan_.touching.size());
    counts_.directContacts = resolved.direct;
    counts_.unsolvedIslands = resolved.unsolved;
    return !isReachTooShort(world);
  }

  void commit(World& world, const Integrator& integrator) {
    StageScope stage(clock_.get(), Stage::Other);
    ++world.step;
    stage.next(Stage::Prepare);
    keepContacts();
    if (!world.roles.empty()) findLeaning(world);
    counts_.latePairs = latePairs_.count(world, candidates_.ballPairs(), candidates_.spheres(),
                                         sleep_.awake(), *pool_);
    stage.next(Stage::Other);
    for (const std::uint32_t i : sleep_.awake()) stepsInSubsteps_[i] = nextStepsInSubsteps_[i];
    findQuarantined(world.balls);
    stage.next(Stage::Sleep);
    sleep_.end(world, field_, candidates_, stepBooks_, contactMemory_);
    candidates_.remove(sleep_.fallenAsleep());
    counts_.asleep = static_cast<std::int64_t>(sleep_.asleep());
    stage.next(Stage::Books);
    keeper_.endStep(world, field_, stepBooks_);
    integrator_ = &integrator;
  }

  static double substepOf(const Settings& settings) { return settings.dt / settings.substeps; }

  /// For the prediction of other peers' balls. Those that sleep lean as they did.
  void findLeaning(World& world) const {
    std::vector<std::uint8_t>& leaning = world.leaning;
    leaning.resize(world.balls.size(), 0);
    for (const std::uint32_t i : sleep_.awake()) leaning[i] = candidates_.isLeaning()[i];
    for (const ContactMemory::Kept& c : contactMemory_.contacts())
      if (isBall(c.b)) leaning[c.a] = leaning[c.b] = 1;
  }

  /// Known at once where nobody sleeps.
  bool areAllFinite(const Balls& balls) const {
    if (sleep_.awake().size() < balls.size()) return false;
    const auto numbers = [](const std::vector<Vec3>& v) {
      return std::span(v.front().data(), 3 * v.size());
    };
    return balls.size() == 0 ||
           (areFinite(numbers(balls.position)) && areFinite(numbers(balls.velocity)) &&
            areFinite(numbers(balls.spin)));
  }

  void findQuarantined(const Balls& balls) {
    quarantined_.clear();
    if (areAllFinite(balls)) return;
    for (const std::uint32_t i : sleep_.awake())
      if (!isFinite(balls.state(i))) quarantined_.push_back(i);
  }

  enum class WhenTooFar : std::uint8_t { StartOver, HandOver };

  /// All islands that go by exact impacts. False: reaches were too short and have been enlarged.
  bool moveByEvents(const StepInput& input, WhenTooFar whenTooFar, World& world) {
    StageScope stage(clock_.get(), Stage::Islands);
    bool isComplete = true;
    Balls& balls = world.balls;
    const auto isLeaning = candidates_.isLeaning();
    for (std::size_t n = 0; n < islands_.count(); ++n) {
      const auto island = islands_.balls(n);
      if (std::any_of(island.begin(), island.end(), [&](auto i) { return isLeaning[i] != 0; }))
        continue;
      if (method_ == ContactMethod::Auto &&
          isCrowd(world.settings, island, balls, stepsInSubsteps_)) {
        for (const std::uint32_t i : island)
          if (stepsInSubsteps_[i] > 0) nextStepsInSubsteps_[i] = stepsInSubsteps_[i] - 1;
        continue;
      }
      stage.next(Stage::Exact);
      const IslandFate fate = exact_.run(input, island, islands_.pairs(n), reach_, balls);
      stage.next(Stage::Islands);
      if (fate == IslandFate::TooFar && whenTooFar == WhenTooFar::StartOver) {
        isComplete = false;
        continue;
      }
      if (fate == IslandFate::TooMany && method_ == ContactMethod::Exact) giveUp(world, island);
      if (fate == IslandFate::Alone) {
        isIslandDone_[n] = 1;  // but not its balls, which are still to fly
        counts_.exactBalls += static_cast<std::int64_t>(island.size());
        continue;
      }
      if (fate != IslandFate::Done) {
        ++counts_.handedOver;
        if (island.size() > kCrowd)
          for (const std::uint32_t i : island) nextStepsInSubsteps_[i] = kCrowdSteps;
        continue;
      }
      markDone(n);
      stepBooks_ += exact_.books();
      counts_.impacts += exact_.counts().impacts;
      counts_.clusters += exact_.counts().clusters;
      counts_.exactBalls += static_cast<std::int64_t>(island.size());
    }
    return isComplete;
  }

  void markDone(std::size_t island) {
    isIslandDone_[island] = 1;
    for (const std::uint32_t i : islands_.balls(island)) isDone_[i] = 1;
  }

  /// Large islands that events did not move. Rolling resistance is left to the solver of small
  /// ones, which has it.
  void moveCrowds(const StepInput& input, World& world) {
    nextMemory_.forget(substepOf(world.settings));
    if (world.settings.rollingResistance > 0) return;
    for (std::size_t n = 0; n < islands_.count(); ++n) {
      const auto island = islands_.balls(n);
      if (isIslandDone_[n] || island.size() <= kCrowd) continue;
      crowd_.step({world.settings, input.model, island, islands_.pairs(n), candidates_.isLeaning(),
                   contactMemory_},
                  world.balls, *pool_, keeper_.books() ? &stepBooks_ : nullptr);
      crowd_.keep(nextMemory_);
      counts_.substepBalls += static_cast<std::int64_t>(island.size());
      markDone(n);
    }
  }

  [[noreturn]] static void giveUp(const World& world, std::span<const std::uint32_t> island) {
    throw std::runtime_error(fmt::format(
        "step {}: ball {} and {} others that may meet it have more than {} elastic impacts in one "
        "step; allow more (MostImpacts), make Dt shorter, or let ContactMethod auto choose",
        world.step, island[0], island.size() - 1, world.settings.mostImpacts));
  }

  /// Whether balls went further than their reaches and met somebody whom nobody expected; these
  /// reaches are then enlarged.
  bool isReachTooShort(const World& world) {
    const auto surprised = candidates_.findSurprised(world, reach_, sleep_.awake(), *pool_);
    for (const std::uint32_t i : surprised)
      enlargeReach(start_[i].position, world.balls.state(i), world.settings.dt, reach_[i]);
    return !surprised.empty();
  }

  void findPairs(const World& world) {
    StageScope stage(clock_.get(), Stage::Candidates);
    candidates_.find(world, reach_, sleep_.awake(), *pool_);
    stage.next(Stage::Islands);
    counts_.candidatePairs = candidates_.pairs();
    counts_.contacts =
        static_cast<std::int64_t>(candidates_.ballPairs().size() + candidates_.arenaPairs().size());
    islands_.find(candidates_.ballPairs(), candidates_.arenaPairs(), sleep_.awake());
    isIslandDone_.assign(islands_.count(), 0);
    for (const std::uint32_t i : sleep_.awake()) isDone_[i] = nextStepsInSubsteps_[i] = 0;
  }

  void planSmallIslands(const World& world) {
    plan_.ballContacts.clear();
    plan_.arenaContacts.clear();
    for (std::size_t n = 0; n < islands_.count(); ++n) {
      if (isIslandDone_[n]) continue;
      for (const auto& [a, b] : islands_.pairs(n)) {
        auto& contacts = isBall(b) ? plan_.ballContacts : plan_.arenaContacts;
        contacts.push_back({.a = a, .b = b});
        contactMemory_.start(contacts.back(), substepOf(world.settings));
      }
    }
    // Where friction has just been switched off, no solver would ever take these back.
    const auto forget = [&](Vec3 Contact::*impulse) {
      for (auto* contacts : {&plan_.ballContacts, &plan_.arenaContacts})
        for (Contact& c : *contacts) (c.*impulse).setZero();
    };
    if (world.settings.friction == 0) forget(&Contact::tangentImpulse);
    if (world.settings.rollingResistance == 0) forget(&Contact::rollingImpulse);
  }

  void keepContacts() {
    for (const auto* contacts : {&plan_.ballContacts, &plan_.arenaContacts})
      for (const Contact& c : *contacts) nextMemory_.add(c);
    nextMemory_.arrange();
    std::swap(contactMemory_, nextMemory_);
  }

  void planFlights() {
    const auto isLeaning = candidates_.isLeaning();
    for (const std::uint32_t i : sleep_.awake()) isTouching_[i] = 0;
    for (const Contact& c : plan_.ballContacts) isTouching_[c.a] = isTouching_[c.b] = 1;
    for (const Contact& c : plan_.arenaContacts) isTouching_[c.a] = 1;
    plan_.free.clear();
    plan_.touching.clear();
    plan_.drifting.clear();
    for (const std::uint32_t i : sleep_.awake()) {
      if (isDone_[i] || std::isnan(reach_[i])) continue;
      auto& list = isLeaning[i] ? plan_.drifting : isTouching_[i] ? plan_.touching : plan_.free;
      list.push_back(i);
    }
  }

  // Balls that a thread prepares: waking it takes as long as some thousand.
  static constexpr std::size_t kLeastRange = 4096;

  const SimulationOptions options_;
  ThreadPool one_;
  std::optional<ThreadPool> many_;
  // Kept from step to step.
  Candidates candidates_;
  ContactMemory contactMemory_;
  LatePairs latePairs_;
  std::vector<std::uint8_t> stepsInSubsteps_;  // by ball, see StepperMemory
  Sleep sleep_;
  BookKeeper keeper_;
  // Of the last step.
  StepCounts counts_;
  std::vector<std::uint32_t> quarantined_;
  const Integrator* integrator_ = nullptr;
  ContactMethod method_ = ContactMethod::Substep;
  mutable StepperMemory memory_;  // made when asked for
  std::unique_ptr<StageClock> clock_;
  // Of the step or the attempt at hand.
  ThreadPool* pool_ = &one_;
  Field field_;
  // By ball; only those of balls that are awake are valid.
  std::vector<BallState> start_;
  std::vector<double> reach_;         // m
  std::vector<std::uint8_t> isDone_;  // moved by events
  std::vector<std::uint8_t> isTouching_;
  std::vector<std::uint8_t> nextStepsInSubsteps_;
  Islands islands_;
  std::vector<std::uint8_t> isIslandDone_;
  ExactFlight exact_;
  Crowd crowd_;
  ContactMemory nextMemory_;
  StepPlan plan_;
  Books stepBooks_;
};

}  // namespace

std::unique_ptr<Stepper> makeSimulation(const SimulationOptions& options) {
  return std::make_unique<Simulation>(options);
}

}  // namespace wells
