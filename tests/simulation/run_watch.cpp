// What is seen of a run: messages on their way, and what each peer knows and does.
#include <algorithm>

#include "network/message_fields.h"
#include "simulation/describe.h"
#include "simulation/run.h"

namespace wells::simulation {
namespace {

constexpr double kTwoLeases = 2 * kLease + 0.5;  // s
constexpr double kInTouch = 1;                   // s
constexpr std::string_view kHeartbeats = "WELLS_HEARTBEAT";
constexpr std::string_view kStates = "WELLS_BALLS";
constexpr std::string_view kOffers = "WELLS_OFFERS";
constexpr int kFingerprintBytes = 8;

bool isDoomed(const Process& process, FaultKind kind) {
  return process.doom && process.doom->kind == kind;
}

}  // namespace

bool Run::sending(Process& process, std::string_view channel, Bytes) {
  if (process.isKilled) return false;
  if (channel != kOffers || !isDoomed(process, FaultKind::CrashBeforeOffer)) return true;
  kill(process, *process.doom);
  return false;
}

bool Run::sent(Process& process, std::string_view channel, Bytes bytes) {
  wire_.record(process.slot(), channel, bytes);
  if (channel != kStates && channel != kOffers) return true;
  const auto decoded = decode(channel, bytes, {.balls = schedule_.balls});
  const Message* message = std::get_if<Message>(&decoded);
  if (!message) {
    invariants_.report(Invariant::Complete, now_,
                       fmt::format("{} sends what must be refused", describe(process.self)));
    return true;
  }
  claims(process, *message);
  if (channel == kOffers && isDoomed(process, FaultKind::CrashAfterOffer))
    kill(process, *process.doom);
  return !process.isKilled;
}

void Run::claims(Process& process, const Message& message) {
  if (const auto* states = std::get_if<gravity_wells::ball_states_t>(&message)) {
    const Incarnation owner{PeerId{states->header.peer_id}, states->header.incarnation};
    for (const auto& ball : states->balls) {
      const Version version = versionOf(states->header, ball, owner, states->step);
      invariants_.claim(static_cast<std::size_t>(ball.id), version, now_);
      invariants_.tell(static_cast<std::size_t>(ball.id), version, stateOf(ball), now_);
      answer(static_cast<std::size_t>(ball.id), version);
    }
  } else if (const auto* offers = std::get_if<gravity_wells::offers_t>(&message)) {
    const Incarnation receiver{PeerId{offers->receiver}, offers->receiver_incarnation};
    for (const auto& ball : offers->balls) {
      const Version version = versionOf(offers->header, ball, receiver, offers->step);
      invariants_.claim(static_cast<std::size_t>(ball.id), version, now_);
      invariants_.tell(static_cast<std::size_t>(ball.id), version, stateOf(ball), now_);
      if (isDoomed(process, FaultKind::CrashAfterAnswer) && !process.offered)
        process.offered = {static_cast<std::size_t>(ball.id), version};
    }
  }
}

void Run::answer(std::size_t ball, const Version& version) {
  for (const auto& process : processes_) {
    const auto& offered = process->offered;
    if (!offered || process->isKilled || offered->first != ball ||
        offered->second.owner != version.owner || !sameTenure(offered->second, version))
      continue;
    kill(*process, *process->doom);
  }
}

void Run::received(Process& process, std::string_view channel, Bytes bytes) {
  const bool isRefused =
      isForged_ && std::holds_alternative<Drop>(decode(channel, bytes, {.balls = schedule_.balls}));
  if (isRefused) return;
  const Generation& generation = process.session().generation();
  const int size = static_cast<int>(bytes.size());
  if (channel == kHeartbeats) {
    gravity_wells::heartbeat_t heartbeat;
    if (heartbeat.decode(bytes.data(), 0, size) == size)
      process.contacts().hear(heartbeat, generation, now_);
    return;
  }
  gravity_wells::peer_header_t header;
  if (size > kFingerprintBytes &&
      header._decodeNoHash(bytes.data(), kFingerprintBytes, size - kFingerprintBytes) > 0)
    process.contacts().hear(header, generation, now_);
}

void Run::observe(Process& process) {
  noteChanges(process);
  invariants_.observe(process.view(), now_, [&](const Incarnation& owner) {
    return std::ranges::any_of(processes_, [&](const auto& other) {
      return other.get() != &process && other->self == owner && other->gone == 0 &&
             haveHeardEachOther(process, *other, kTwoLeases);
    });
  });
}

void Run::noteChanges(Process& process) {
  const Session& session = process.session();
  const bool isAnew = process.self != session.self() || process.generation != session.generation();
  if (process.self != session.self())
    trace_.add(now_, "process {} is {}", process.number(), describe(session.self()));
  if (process.generation != session.generation())
    trace_.add(now_, "{} enters {}", describe(session.self()), describe(session.generation()));
  if (process.phase != session.phase())
    trace_.add(now_, "{} is {}", describe(session.self()), name(session.phase()));
  const bool hasJoined = process.phase == Phase::Syncing && session.phase() == Phase::Active;
  if (isAnew || process.phase != session.phase()) process.activeSince = now_;
  if (process.phase != Phase::Syncing || process.generation != session.generation())
    process.syncingSince = now_;
  process.self = session.self();
  process.generation = session.generation();
  process.phase = session.phase();

  process.learn([&](std::size_t ball, const Record& before, const Record& after) {
    if (!trace_.isOn()) return;
    const Incarnation& self = process.self;
    const Incarnation& owner = after.version.owner;
    if (owns(before, self) && !owns(after, self))
      trace_.add(now_, "{} no longer owns ball {}: {}", describe(self), ball, describe(after));
    if (!owns(before, self) && owns(after, self))
      trace_.add(now_, "{} {} ball {}: {}", describe(self),
                 after.version.adopter == self && after.version.epoch == 0 ? "adopts" : "takes",
                 ball, describe(after));
    if (owner != before.version.owner && owner != self && !owns(before, self))
      trace_.add(now_, "{} learns of ball {}: {}", describe(self), ball, describe(after));
  });
  const SessionCounts counts = session.counts();
  if (counts.fences != process.counts.fences)
    trace_.add(now_, "{} is fenced", describe(process.self));
  process.counts = counts;

  // One that has not come to agree with all takes part after two leases nevertheless.
  if (!hasJoined || now_ - process.syncingSince >= 2 * kLease - 0.1) return;
  std::vector<int> others;
  for (const auto& other : processes_)
    if (other.get() != &process && !other->isKilled && other->phase == Phase::Active &&
        other->generation == process.generation && now_ - other->activeSince >= kInTouch &&
        process.contacts().isClose(other->self, kInTouch, now_) &&
        other->contacts().isClose(process.self, kInTouch, now_))
      others.push_back(other->number());
  invariants_.joined(process.view(), others, now_);
}

void Run::addCounts(const Process& process) {
  const SessionCounts counts = process.session().counts();
  const TransportCounts transport = process.transport().counts();
  tally_.messagesSent += transport.messagesSent;
  tally_.messagesReceived += counts.accepted;
  tally_.messagesRefused += counts.drops.total();
  tally_.messagesLostInBuffers += transport.droppedReceiving;
  tally_.handovers += counts.balls.handoversTaken;
  tally_.adoptions += counts.balls.adoptions;
  tally_.fences += counts.fences;
  tally_.resyncs += counts.resyncs;
}

}  // namespace wells::simulation
