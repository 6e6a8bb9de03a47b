#include "simulation/run.h"

#include <algorithm>

#include "simulation/describe.h"

namespace wells::simulation {
namespace {

// s that messages, ticks and looks may take besides the leases themselves.
constexpr double kSlack = 0.5;

bool needsRecord(const Schedule& schedule) {
  return std::ranges::any_of(schedule.faults, [](const Fault& fault) {
    return fault.kind == FaultKind::ReplayLog || fault.kind == FaultKind::RestartStale ||
           fault.kind == FaultKind::Forge;
  });
}

}  // namespace

Outcome simulate(const Schedule& schedule, Trace::Keeping keeping) {
  return Run(schedule, keeping).outcome();
}

Run::Run(const Schedule& schedule, Trace::Keeping keeping)
    : schedule_(schedule),
      trace_(keeping),
      wire_(schedule.seed, schedule.latency,
            needsRecord(schedule) ? Wire::Recording::On : Wire::Recording::Off),
      invariants_(static_cast<std::size_t>(schedule.balls), kLease) {
  wire_.apply({}, {});
}

Outcome Run::outcome() {
  run();
  for (const auto& process : processes_) addCounts(*process);
  tally_.runs = 1;
  tally_.seconds = now_;
  tally_.leastHandovers = tally_.handovers;
  tally_.incomplete = isComplete_ ? 0 : 1;
  return {invariants_.violations(), tally_, trace_.text()};
}

bool Run::isOver() const {
  return !invariants_.violations().empty() || isComplete_ || now_ >= schedule_.end;
}

void Run::run() {
  while (!isOver()) {
    advanceTo(nextTime());
    if (!isHealed_ && now_ >= schedule_.heal) heal();
    if (isHealed_) endPause();
    if (!isStopped_ && now_ >= schedule_.stop) stopWhenSeenEnough();
    endFaults();
    beginFaults();
    for (std::size_t i = 0; i < processes_.size(); ++i)
      if (processes_[i]->next <= now_) tick(*processes_[i]);
    bury();
    checkGroups();
  }
  if (invariants_.violations().empty() && !isComplete_ && !processes_.empty())
    invariants_.report(Invariant::Agree, now_, "the peers' views are not complete");
  for (const Violation& violation : invariants_.violations())
    trace_.add(violation.time, "VIOLATION of \"{}\": {}", name(violation.invariant),
               violation.what);
}

double Run::nextTime() const {
  double next = schedule_.end;
  if (!isHealed_) next = std::min(next, schedule_.heal);
  if (!isStopped_) next = std::min(next, schedule_.stop);
  if (nextFault_ < schedule_.faults.size()) next = std::min(next, schedule_.faults[nextFault_].at);
  for (const Fault& fault : lasting_) next = std::min(next, fault.at + fault.duration);
  for (const Fault& fault : comebacks_) next = std::min(next, fault.at);
  for (const auto& process : processes_) next = std::min(next, process->next);
  return std::max(next, now_);
}

void Run::advanceTo(double time) {
  countDoubled(time - now_);
  now_ = time;
  wire_.advanceTo(time);
}

void Run::beginFaults() {
  for (; nextFault_ < schedule_.faults.size() && schedule_.faults[nextFault_].at <= now_;
       ++nextFault_) {
    const Fault& fault = schedule_.faults[nextFault_];
    if (fault.state) {
      waiting_.push_back(fault);
    } else if (fault.kind == FaultKind::Start || fault.kind == FaultKind::RestartStale) {
      start(fault.slot, fault.kind);
    } else if (fault.kind == FaultKind::ClockJump && !inSlot(fault.slot)) {
      clockOffsets_[fault.slot] = fault.amount;
    } else if (fault.slot == Fault::kAnySlot) {
      strikeNetwork(fault);
    } else if (Process* process = inSlot(fault.slot)) {
      strike(fault, *process);
    }
  }
  for (const Fault& fault : comebacks_)
    if (fault.at <= now_) start(fault.slot, fault.kind);
  std::erase_if(comebacks_, [&](const Fault& fault) { return fault.at <= now_; });
  std::erase_if(waiting_, [&](const Fault& fault) { return fault.at + Fault::kPatience < now_; });
}

void Run::endFaults() {
  for (std::size_t i = 0; i < lasting_.size();) {
    if (lasting_[i].at + lasting_[i].duration > now_) {
      ++i;
      continue;
    }
    const Fault over = lasting_[i];
    lasting_.erase(lasting_.begin() + static_cast<std::ptrdiff_t>(i));
    restore(over);
  }
}

void Run::heal() {
  isHealed_ = true;
  trace_.add(now_, "all faults end");
  beginFaults();
  waiting_.clear();
  comebacks_.clear();
  for (const Fault& fault : std::exchange(lasting_, {})) restore(fault);
  for (const auto& process : processes_) {
    process->next = std::min(process->next, now_);
    process->stallsMidTick = false;
    process->doom.reset();
    process->offered.reset();
  }
}

// Asked for again and again: who has just come back, or joins, hears nothing of it.
void Run::endPause() {
  constexpr double kInterval = 1;  // s
  if (now_ < nextEndOfPause_) return;
  nextEndOfPause_ = now_ + kInterval;
  const bool anyPaused = std::ranges::any_of(processes_, [](const auto& process) {
    return isPaused(process->session().settings(), process->world().step);
  });
  if (anyPaused) ask(setting::kPause, "false");
}

// Where too many were gone for too long, the run goes on until it has shown something.
void Run::stopWhenSeenEnough() {
  constexpr double kMore = 5;  // s
  std::int64_t handovers = tally_.handovers;
  for (const auto& process : processes_)
    handovers += process->session().counts().balls.handoversTaken;
  if (handovers >= kFewHandovers || extensions_ == kMostExtensions) return stop();
  ++extensions_;
  schedule_.stop += kMore;
  schedule_.end += kMore;
}

void Run::stop() {
  isStopped_ = true;
  trace_.add(now_, "the world is to stop");
  std::int64_t last = 0;
  for (const auto& process : processes_) {
    last = std::max(last, process->world().step);
    if (process->session().phase() == Phase::Active) continue;
    invariants_.report(Invariant::AllReturn, now_,
                       fmt::format("{} is still {}", describe(process->session().self()),
                                   name(process->session().phase())));
  }
  stopAt_ = last + 10;
  for (const auto& process : processes_) process->session().stopAt(*stopAt_);
}

void Run::tick(Process& process) {
  if (process.gone > 0 && now_ >= process.gone) {
    process.isKilled = true;
    return;
  }
  if (!process.isMidTick) {
    strikeWhenReady(process);
    if (process.isKilled || process.next > now_) return;
    receive(process);
    if (process.isKilled) return;
    if (process.stallsMidTick) {
      process.stallsMidTick = false;
      process.isMidTick = true;
      process.next = now_ + process.stall;
      return;
    }
  }
  process.isMidTick = false;
  process.ticked = now_;
  process.send(now_);
  process.next = now_ + process.tick();
  if (!process.isKilled) observe(process);
}

void Run::receive(Process& process) {
  try {
    process.receive(now_);
  } catch (const std::runtime_error& error) {
    trace_.add(now_, "process {} ends: {}", process.number(), error.what());
    process.isKilled = true;
    return;
  }
  observe(process);
}

void Run::bury() {
  const bool anyDied = std::ranges::any_of(processes_, [](const auto& p) { return p->isKilled; });
  if (!anyDied) return;
  for (const auto& process : processes_) {
    if (!process->isKilled) continue;
    addCounts(*process);
    comeBack(*process);
  }
  std::erase_if(processes_, [](const auto& process) { return process->isKilled; });
}

void Run::checkGroups() {
  constexpr double kTwoLeases = 2 * kLease + kSlack;
  for (std::size_t first = 0; first < processes_.size(); ++first) {
    const Process& a = *processes_[first];
    std::vector<const Process*> group;
    std::vector<Incarnation> selves;
    for (const auto& other : processes_) {
      if (other.get() != &a && !areClose(a, *other, kTwoLeases)) continue;
      if (other.get() == &a && !isAwake(a, kTwoLeases)) break;
      group.push_back(other.get());
      selves.push_back(other->self);
    }
    // Each group once, by its first member.
    if (group.empty() || group.front() != &a) continue;
    const bool isClosed = std::ranges::all_of(group, [&](const Process* member) {
      return member->contacts().hearsOnly(selves, kTwoLeases, now_) &&
             std::ranges::all_of(group, [&](const Process* other) {
               return other == member || areClose(*member, *other, kTwoLeases);
             });
    });
    if (!isClosed) continue;
    ++tally_.groupChecks;
    std::vector<PeerView> members;
    for (const Process* member : group) members.push_back(member->view());
    invariants_.group(members, now_);
  }
  if (!isHealed_ || now_ < schedule_.heal + kTwoLeases) return;
  const std::vector<PeerView> all = views();
  invariants_.healed(all, now_);
  if (!isStopped_) return;
  isComplete_ = !processes_.empty() && std::ranges::all_of(processes_, [](const auto& process) {
    return process->session().isComplete(process->world());
  });
  if (!isComplete_) return;
  trace_.add(now_, "all views are complete");
  invariants_.complete(all, now_);
}

bool Run::isAwake(const Process& process, double seconds) const {
  return !process.isKilled && process.phase == Phase::Active && !process.losesMessages &&
         now_ - process.lastLoss >= seconds && now_ - process.activeSince >= seconds &&
         now_ - process.ticked <= kLease / 2;
}

bool Run::haveHeardEachOther(const Process& a, const Process& b, double seconds) const {
  return isAwake(a, seconds) && isAwake(b, seconds) && a.generation == b.generation &&
         a.contacts().isSteady(b.self, seconds, now_) &&
         b.contacts().isSteady(a.self, seconds, now_);
}

bool Run::areClose(const Process& a, const Process& b, double seconds) const {
  return haveHeardEachOther(a, b, seconds) && a.contacts().isClose(b.self, seconds, now_) &&
         b.contacts().isClose(a.self, seconds, now_);
}

std::vector<PeerView> Run::views() const {
  std::vector<PeerView> views;
  for (const auto& process : processes_) views.push_back(process->view());
  return views;
}

void Run::countDoubled(double seconds) {
  if (!processes_.empty()) tally_.ballSeconds += schedule_.balls * seconds;
  for (std::size_t i = 0; i < static_cast<std::size_t>(schedule_.balls); ++i) {
    int owners = 0;
    for (const auto& process : processes_)
      if (process->world().roles[i] == Role::Owned) ++owners;
    if (owners > 1) tally_.doubledBallSeconds += (owners - 1) * seconds;
  }
}

}  // namespace wells::simulation
