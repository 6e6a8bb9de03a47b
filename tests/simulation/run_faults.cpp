// What goes wrong in a run, and how it is put right again.
#include <algorithm>

#include "simulation/describe.h"
#include "simulation/run.h"

namespace wells::simulation {
namespace {

constexpr double kFarewell = 0.2;  // s from a good-bye to the process's end
constexpr double kReplayed = 2;    // s of a log that is played back
constexpr double kStale = 3;       // s of its own former messages that a restarted peer finds
constexpr std::int64_t kSettingDelay = 5;  // steps
constexpr std::int64_t kAsker = 1;         // incarnation of who asks for settings
constexpr int kAsked = 3;                  // times, since any message may be lost
constexpr std::size_t kMostStrangers = 2;

bool isOfNetwork(FaultKind kind) {
  switch (kind) {
    case FaultKind::Loss:
    case FaultKind::Duplication:
    case FaultKind::Delay:
    case FaultKind::ReplayLog:
    case FaultKind::Forge:
    case FaultKind::Pause:
    case FaultKind::Reset:
    case FaultKind::Setting:
      return true;
    default:
      return false;
  }
}

}  // namespace

Process* Run::inSlot(int slot) {
  const auto place =
      std::ranges::find_if(processes_, [&](const auto& p) { return p->slot() == slot; });
  return place == processes_.end() ? nullptr : place->get();
}

void Run::strikeWhenReady(Process& process) {
  if (waiting_.empty() || process.isKilled) return;
  const PeerStates states = statesOf(process);
  for (std::size_t i = 0; i < waiting_.size();) {
    const bool isHit =
        (waiting_[i].slot == Fault::kAnySlot || waiting_[i].slot == process.slot()) &&
        states.contains(*waiting_[i].state);
    if (!isHit) {
      ++i;
      continue;
    }
    const Fault fault = waiting_[i];
    waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i));
    strike(fault, process);
    if (process.isKilled) return;
  }
}

void Run::strike(const Fault& drawn, Process& process) {
  Fault fault = drawn;
  fault.at = now_;
  fault.slot = process.slot();
  if (isOfNetwork(fault.kind)) return strikeNetwork(fault);
  switch (fault.kind) {
    case FaultKind::Start:
    case FaultKind::RestartStale:
      return start(Fault::kAnySlot, fault.kind);
    case FaultKind::Crash:
      return kill(process, fault);
    case FaultKind::CrashBeforeOffer:
    case FaultKind::CrashAfterOffer:
    case FaultKind::CrashAfterAnswer:
      process.doom = fault;  // counted when it happens
      return;
    case FaultKind::Leave:
      if (process.isMidTick || process.gone > 0) return;
      count(fault.kind, process);
      process.leave(now_);
      observe(process);
      process.gone = now_ + kFarewell;
      process.comeback = fault;
      return;
    case FaultKind::DuplicateId:
      if (processes_.size() >= static_cast<std::size_t>(schedule_.peers) + kMostStrangers) return;
      count(fault.kind, process);
      return launch(schedule_.peers + started_, process.id());
    case FaultKind::Stall:
      count(fault.kind, process);
      process.next = now_ + fault.duration;
      return;
    case FaultKind::StallMidTick:
      count(fault.kind, process);
      process.stallsMidTick = true;
      process.stall = fault.duration;
      return;
    case FaultKind::ClockJump:
      if (now_ > 0) count(fault.kind, process);
      clockOffsets_[fault.slot] = fault.amount;
      process.setClockOffset(fault.amount);
      return;
    case FaultKind::Slow:
      process.slowness = 10;
      break;
    case FaultKind::TinyBuffer:
      process.losesMessages = true;
      break;
    default:
      break;
  }
  count(fault.kind, process);
  last(fault);
}

void Run::strikeNetwork(const Fault& drawn) {
  Fault fault = drawn;
  fault.at = now_;
  countAll(fault.kind, nullptr);
  switch (fault.kind) {
    case FaultKind::ReplayLog:
      return wire_.replay(Fault::kAnySlot, now_ - fault.amount, now_ - fault.amount + kReplayed);
    case FaultKind::Forge:
      isForged_ = true;
      return wire_.forge(static_cast<std::size_t>(schedule_.balls));
    case FaultKind::Pause:
      ask(setting::kPause, "true");
      break;
    case FaultKind::Reset:
      return askToReset();
    case FaultKind::Setting:
      return ask(setting::kFriction, fmt::format("{:.3f}", fault.amount));
    default:
      break;
  }
  last(fault);
}

void Run::last(const Fault& fault) {
  lasting_.push_back(fault);
  applyToWire();
}

void Run::restore(const Fault& fault) {
  trace_.add(now_, "over: {}", name(fault.kind));
  if (Process* process = inSlot(fault.slot)) {
    if (fault.kind == FaultKind::Slow) process->slowness = 1;
    if (fault.kind == FaultKind::TinyBuffer) {
      process->losesMessages = false;
      process->lastLoss = now_;
    }
  }
  if (fault.kind == FaultKind::Pause) ask(setting::kPause, "false");
  applyToWire();
}

void Run::applyToWire() {
  std::vector<Wire::Plug> plugs;
  for (const auto& process : processes_)
    plugs.push_back({process->slot(), process->transport().endpoint()});
  wire_.apply(lasting_, plugs);
}

std::vector<const Process*> Run::oneOfEachGeneration() const {
  std::vector<const Process*> members;
  for (const auto& process : processes_) {
    const bool isNew = std::ranges::none_of(
        members, [&](const Process* member) { return member->generation == process->generation; });
    if (isNew && process->phase == Phase::Active) members.push_back(process.get());
  }
  return members;
}

void Run::ask(std::string_view key, const std::string& value) {
  for (const Process* member : oneOfEachGeneration()) ask(*member, key, value);
}

void Run::askToReset() {
  for (const Process* member : oneOfEachGeneration())
    ask(*member, setting::kReset, std::to_string(resetsAsked(member->session().settings()) + 1));
}

void Run::ask(const Process& member, std::string_view key, const std::string& value) {
  const Session& session = member.session();
  const Generation& generation = session.generation();
  const Register next = session.settings().next(key, value, kAsker + nextAsked_, "simulator",
                                                member.world().step + kSettingDelay);
  gravity_wells::request_t request;
  request.header = {.utime = member.times(now_).wallUs,
                    .protocol = gravity_wells::peer_header_t::PROTOCOL,
                    .peer_id = 0,
                    .incarnation = kAsker,
                    .sequence = ++nextAsked_,
                    .generation_resets = generation.resets,
                    .generation_founded = generation.foundedUs,
                    .generation_nonce = generation.nonce,
                    .step = member.world().step};
  request.count = 1;
  request.settings.push_back({.key = std::string(key),
                              .value = value,
                              .version = next.version,
                              .setter = next.setter,
                              .set_by = next.setBy,
                              .from_step = next.fromStep});
  MessageBuffer buffer;
  const auto bytes = encode(request, buffer);
  for (int i = 0; i < kAsked; ++i) wire_.say(channelOf(request), bytes);
}

void Run::start(int slot, FaultKind kind) {
  if (slot == Fault::kAnySlot)
    for (slot = 0; slot < schedule_.peers && inSlot(slot);) ++slot;
  if (slot == schedule_.peers || inSlot(slot)) return;
  launch(slot, PeerId{slot + 1});
  countAll(kind, processes_.back().get());
  if (kind == FaultKind::RestartStale) wire_.replay(slot, now_ - kStale, now_);
}

void Run::launch(int slot, PeerId id) {
  std::uint64_t mix = schedule_.seed * 1000 + static_cast<std::uint64_t>(started_);
  const Process::Birth birth{.number = started_++,
                             .slot = slot,
                             .id = id,
                             .balls = schedule_.balls,
                             .seed = splitmix64(mix),
                             .clockOffset = clockOffsets_[slot]};
  // The watches and the process refer to each other.
  const auto self = std::make_shared<Process*>(nullptr);
  WatchedTransport::Watch watch{
      .sending = [this, self](auto channel, auto bytes) { return sending(**self, channel, bytes); },
      .sent = [this, self](auto channel, auto bytes) { return sent(**self, channel, bytes); },
      .received = [this, self](auto channel, auto bytes) { received(**self, channel, bytes); }};
  const auto notice = [this, number = birth.number](const std::string& text) {
    trace_.add(now_, "process {}: \"{}\"", number, text);
  };
  processes_.push_back(std::make_unique<Process>(birth, wire_.network(), std::move(watch), notice));
  *self = processes_.back().get();
  processes_.back()->next = now_;
  if (stopAt_) processes_.back()->session().stopAt(*stopAt_);
  trace_.add(now_, "process {} starts in slot {} as peer {}", birth.number, slot, value(id));
  applyToWire();
}

void Run::kill(Process& process, const Fault& fault) {
  count(fault.kind, process);
  process.isKilled = true;
  process.comeback = fault;
}

void Run::comeBack(const Process& process) {
  if (!process.comeback || process.comeback->duration == 0) return;
  const Fault& fault = *process.comeback;
  if (process.slot() >= schedule_.peers || isHealed_) return;
  comebacks_.push_back({.at = now_ + fault.duration,
                        .kind = fault.amount == 1 ? FaultKind::RestartStale : FaultKind::Start,
                        .slot = process.slot()});
}

void Run::count(FaultKind kind, const Process& hit) {
  trace_.add(now_, "{}: process {} ({})", name(kind), hit.number(), describe(hit.self));
  ++tally_.faults[static_cast<std::size_t>(kind)];
  const PeerStates states = statesOf(hit);
  for (std::size_t state = 0; state < kPeerStates; ++state)
    if (states.contains(static_cast<PeerState>(state)))
      ++tally_.coverage[static_cast<std::size_t>(kind)][state];
}

void Run::countAll(FaultKind kind, const Process* except) {
  trace_.add(now_, "{}", name(kind));
  ++tally_.faults[static_cast<std::size_t>(kind)];
  for (const auto& process : processes_) {
    if (process.get() == except) continue;
    const PeerStates states = statesOf(*process);
    for (std::size_t state = 0; state < kPeerStates; ++state)
      if (states.contains(static_cast<PeerState>(state)))
        ++tally_.coverage[static_cast<std::size_t>(kind)][state];
  }
}

PeerStates Run::statesOf(const Process& process) const {
  PeerStates states;
  const Session& session = process.session();
  switch (session.phase()) {
    case Phase::Joining:
      states.add(PeerState::Joining);
      return states;
    case Phase::Syncing:
      states.add(PeerState::Syncing);
      return states;
    case Phase::Leaving:
      states.add(PeerState::Leaving);
      return states;
    case Phase::Active:
      break;
  }
  const Incarnation& self = session.self();
  states.add(session.ballsOwnedHere() == 0 ? PeerState::OwnsNothing : PeerState::Owns);
  if (isPaused(session.settings(), process.world().step)) states.add(PeerState::Paused);
  for (std::size_t i = 0; i < session.records().size(); ++i) {
    const Record& record = session.records()[i];
    if (process.hasOpenOffer(i)) states.add(PeerState::Offering);
    if (record.version.owner == self && record.standing == Standing::Named)
      states.add(PeerState::Named);
    const Incarnation& owner = record.version.owner;
    if (owner != self && std::ranges::none_of(processes_, [&](const auto& other) {
          return !other->isKilled && other->self == owner;
        }))
      states.add(PeerState::Bereft);
    for (const auto& other : processes_) {
      const Record& theirs = other->session().records()[i];
      if (theirs.version.owner == self && theirs.standing == Standing::Named &&
          theirs.version > record.version)
        states.add(PeerState::Named);
    }
  }
  return states;
}

}  // namespace wells::simulation
