#include "simulation/process.h"

#include "simulation/toy_world.h"

namespace wells::simulation {
namespace {

constexpr double kDrift = 500e-6;                       // of a clock, either way
constexpr double kTickJitter = 0.1;                     // of a tick, either way
constexpr std::int64_t kEpoch = 1'700'000'000'000'000;  // us, of the wall clocks at time 0

SessionOptions optionsOf(const Process::Birth& birth,
                         std::function<void(const std::string&)> notice) {
  SessionOptions options;
  options.peer = birth.id;
  options.seed = birth.seed;
  options.lease = kLease;
  options.stateRate = 10;
  options.stepRate = kStepRate;
  options.handover.dwell = 2;
  options.canonicalConfig = "BallRadius=0.5\n";
  options.worldHash = 42;
  options.well = toyWell();
  options.predict = toyPredict;
  options.notice = std::move(notice);
  return options;
}

}  // namespace

Process::Process(const Birth& birth, std::shared_ptr<MemoryNetwork> network,
                 WatchedTransport::Watch watch, std::function<void(const std::string&)> notice)
    : birth_(birth),
      random_(birth.seed + 1),
      world_(toyWorld(birth.balls)),
      transport_(std::move(network), std::move(watch)) {
  known_.resize(world_.balls.size());
  made_.resize(world_.balls.size());
  rate_ = 1 + random_.uniform(-kDrift, kDrift);
  origin_ = random_.uniform(0, 1e6);
  session_ = std::make_unique<Session>(optionsOf(birth_, std::move(notice)), world_, transport_);
}

Times Process::times(double now) const {
  return {origin_ + rate_ * now,
          kEpoch + static_cast<std::int64_t>((rate_ * now + birth_.clockOffset) * 1e6)};
}

void Process::receive(double now) {
  session_->beforeStep(world_, times(now));
  stepsDue_ = session_->mayStep(world_, times(now));
}

void Process::send(double now) {
  for (int i = 0; i < stepsDue_; ++i) {
    toyStep(world_, session_->peer());
    session_->afterStep(world_, times(now));
  }
  if (stepsDue_ == 0) session_->afterStep(world_, times(now));
}

void Process::leave(double now) {
  session_->leave(world_, times(now));
}

double Process::tick() {
  return slowness / kStepRate * random_.uniform(1 - kTickJitter, 1 + kTickJitter);
}

void Process::learn(const std::function<void(std::size_t, const Record&, const Record&)>& tell) {
  for (std::size_t i = 0; i < known_.size(); ++i) {
    const Record& after = session_->records()[i];
    Record& before = known_[i];
    if (after.version.owner == before.version.owner && after.standing == before.standing &&
        sameTenure(after.version, before.version))
      continue;
    const bool isOffer = owns(before, session_->self()) && after.standing == Standing::Named &&
                         after.version.epoch == before.version.epoch + 1;
    if (isOffer) made_[i] = after.version;
    tell(i, before, after);
    before = after;
  }
}

bool Process::hasOpenOffer(std::size_t ball) const {
  const Record& record = session_->records()[ball];
  return record.standing == Standing::Named && record.version == made_[ball];
}

PeerView Process::view() const {
  return {.process = birth_.number,
          .self = session_->self(),
          .phase = session_->phase(),
          .generation = session_->generation(),
          .step = world_.step,
          .losesMessages = losesMessages,
          .records = session_->records(),
          .roles = world_.roles,
          .balls = &world_.balls,
          .settings = session_->settings().digest(),
          .registers = &session_->settings().registers(),
          .tracks = &world_.tracks};
}

}  // namespace wells::simulation
