// What peers do with a ball.
#include <tuple>

#include "search/model.h"

namespace wells {
namespace {

constexpr std::int64_t kStep = 0;  // knowledge.h says why

/// The order of tenures; owner and step left out.
auto tenureOf(const Version& version) {
  return std::tuple(version.generation, version.term, version.adopter, version.epoch);
}

void requireNewTenure(const Record& before, const Record& next) {
  require(tenureOf(next.version) > tenureOf(before.version), "an old tenure begins anew");
}

}  // namespace

// What an owner can publish is sent at once: the network may keep it for as long as it likes.
void Model::publish(const Party& self, Act& act) {
  const Entry before = entry(act.record);
  if (!protocol_.transitions.mayPublish(before.record, self)) return;
  const Record next = protocol_.transitions.publish(before.record, self, kStep);
  act.record = raised(act.record, {next, before.offer});
  Version sent = next.version;
  sent.owner = self.self;  // a message of states says who owns by who sends it
  act.sent = messageOf(News::State, sent);
}

void Model::begin(const Party& self, const Record& next, Act& act) {
  require(protocol_.transitions.owns(next, self.self), "who has taken the ball does not own it");
  act.record = raised(act.record, {next});
  publish(self, act);
}

bool Model::adopt(const Party& self, Life life, Act& act) {
  const Transitions& rules = protocol_.transitions;
  const Record record = entry(act.record).record;
  if (!rules.mayAdopt(record, self, life)) return false;
  const Record next = rules.adopt(record, self, kStep);
  if (next.version.term >= limits_.terms) return false;
  requireNewTenure(record, next);
  begin(self, next, act);
  return true;
}

const Model::Acts& Model::actsOf(std::uint32_t number, int peer, Word record) {
  const std::uint32_t key = actsKeys_.number({number, static_cast<std::uint16_t>(peer), record});
  if (key <= acts_.size()) return acts_[key - 1];
  Acts acts;
  const Group& group = groups_[number].group;
  Event event{.peer = static_cast<std::uint8_t>(peer), .basis = record};
  const Act still{event, record, 0, number};
  tryToTake(group, peer, still, acts);
  tryToAdopt(group, peer, still, acts);
  tryToPublish(group, peer, still, acts);
  tryToWithdraw(group, peer, still, acts);
  tryToOffer(group, peer, still, acts);
  return acts_.emplace_back(std::move(acts));
}

void Model::tryToTake(const Group& group, int peer, const Act& still, Acts& acts) {
  const Record record = entry(still.record).record;
  const Party self = partyOf(group, peer);
  if (!protocol_.transitions.mayTake(record, self)) return;
  Act act = still;
  act.event.deed = Deed::Take;
  during(act.event, [&] { begin(self, protocol_.transitions.take(record, self), act); });
  acts.push_back(act);
}

void Model::tryToAdopt(const Group& group, int peer, const Act& still, Acts& acts) {
  const Incarnation owner = entry(still.record).record.version.owner;
  const Party self = partyOf(group, peer);
  const Life life = lifeOf(group, peer, owner, protocol_.conduct);
  Act act = still;
  act.event.deed = Deed::Adopt;
  during(act.event, [&] {
    if (adopt(self, life, act)) acts.push_back(act);
  });
  if (life == Life::Ended || owner == self.self) return;
  const auto after = afterSuspicion(group, peer, value(owner.peer) - 1, limits_);
  if (!after) return;
  act = still;
  act.event.deed = Deed::AdoptWrongly;
  act.group = groups_.number(*after);
  during(act.event, [&] {
    if (adopt(self, Life::Ended, act)) acts.push_back(act);
  });
}

// Nothing new with the real rules, under which the act of taking the ball publishes it.
void Model::tryToPublish(const Group& group, int peer, const Act& still, Acts& acts) {
  Act act = still;
  act.event.deed = Deed::Publish;
  during(act.event, [&] { publish(partyOf(group, peer), act); });
  if (act.sent != 0) acts.push_back(act);
}

void Model::tryToWithdraw(const Group& group, int peer, const Act& still, Acts& acts) {
  const Entry before = entry(still.record);
  const bool isOpen = before.record.standing == Standing::Named && before.offer == Offer::Open;
  if (!protocol_.transitions.withdraw || !isOpen) return;
  const Party self = partyOf(group, peer);
  const auto record = protocol_.transitions.withdraw(before.record, self);
  if (!record || record->version.epoch >= limits_.epochs) return;
  Act act = still;
  act.event.deed = Deed::Withdraw;
  during(act.event, [&] { begin(self, *record, act); });
  acts.push_back(act);
}

void Model::tryToOffer(const Group& group, int peer, const Act& still, Acts& acts) {
  const Transitions& rules = protocol_.transitions;
  const Record before = entry(still.record).record;
  const Party self = partyOf(group, peer);
  const std::uint8_t generation = group.members[peer].generation;
  const auto attempt = [&](const Party& receiver) {
    if (!rules.mayOffer(before, self, receiver)) return;
    Act act = still;
    act.event.deed = Deed::Offer;
    during(act.event, [&] {
      const Record next = rules.offer(before, self, receiver, kStep);
      if (next.version.epoch >= limits_.epochs) return;
      requireNewTenure(before, next);
      act.record = raised(act.record, {next, Offer::Open});
      act.sent = act.event.subject = messageOf(News::Offer, next.version);
      acts.push_back(act);
    });
  };
  for (int other = 0; other < limits_.peers; ++other) {
    // Believed to be active, perhaps long ago ...
    for (int number = 1; number < kRanks; ++number)
      if (group.generations[generation - 1].wasActive & bitOf(other, number))
        attempt({incarnationOf(other, number), Phase::Active});
    // ... or known not to be.
    const Member& member = group.members[other];
    if (isMember(member) && member.phase == Phase::Syncing && member.generation == generation)
      attempt(partyOf(group, other));
  }
}

const Model::Acts& Model::resultOf(std::uint32_t number, std::size_t index, Word record) {
  const std::uint32_t key =
      actsKeys_.number({number, static_cast<std::uint16_t>(kMaxPeers + index), record});
  if (key <= acts_.size()) return acts_[key - 1];
  const GroupStep step = groups_.steps(number)[index];
  const Group& to = groups_[step.to].group;
  const int peer = step.event.peer;
  const Generation generation = generationOf(to, to.members[peer].generation);
  const Party self = partyOf(to, peer);
  Act act{step.event, record, 0, step.to};
  during(step.event, [&] {
    switch (step.event.deed) {
      case Deed::Found:
      case Deed::Reset:
        begin(self, protocol_.transitions.found(generation, self.self, kStep), act);
        break;
      case Deed::Enter:
        act.record = raised(record, {protocol_.transitions.unknown(generation)});
        break;
      case Deed::Fence:
      case Deed::Retreat:
        act.record = wordOf({protocol_.transitions.unknown(generation)});
        break;
      case Deed::Crash:
        act.record = 0;
        break;
      default:  // FenceAlone keeps the record: what the former incarnation owned is adopted next
        break;
    }
  });
  return acts_.emplace_back(Acts{act});
}

}  // namespace wells
