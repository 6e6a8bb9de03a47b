#include "search/model.h"

#include <algorithm>

namespace wells {
namespace {

constexpr std::int64_t kStep = 0;  // knowledge.h says why
constexpr Word kRefused = 0xffff;

/// The order of tenures; owner and step left out.
auto tenureOf(const Version& version) {
  return std::tuple(version.generation, version.term, version.adopter, version.epoch);
}

void require(bool holds, const char* what) {
  if (!holds) throw Flaw{what, {}};
}

}  // namespace

Entry Model::entry(const Knowledge& ball, int peer) const {
  const Word word = ball.records[peer];
  return {{versions_[versionOfRecord(word)], word & kHeardBit ? Standing::Heard : Standing::Named},
          word & kOpenBit ? Offer::Open : Offer::Closed};
}

Telling Model::telling(Word message) const {
  return {newsOf(message), versions_[versionOfMessage(message)]};
}

void Model::set(Knowledge& ball, int peer, const Entry& entry) {
  const bool isHeard = entry.record.standing == Standing::Heard;
  const bool isOpen = !isHeard && entry.offer == Offer::Open;
  ball.records[peer] = static_cast<Word>(versions_.number(entry.record.version) << 2 |
                                         (isHeard ? kHeardBit : 0) | (isOpen ? kOpenBit : 0));
}

void Model::raise(Knowledge& ball, int peer, const Entry& entry) {
  const Record before = this->entry(ball, peer).record;
  require(entry.record.version >= before.version, "a peer goes back to a lower version");
  require(entry.record.version > before.version || entry.record.standing == Standing::Heard ||
              before.standing == Standing::Named,
          "a peer forgets that it has heard the owner");
  set(ball, peer, entry);
}

void Model::send(Knowledge& ball, News news, const Version& version) {
  ball.send(static_cast<Word>(versions_.number(version) << 1 | (news == News::Offer ? 1 : 0)));
}

// What an owner can publish is sent at once: the network may keep it for as long as it likes.
void Model::publish(const Group& group, int peer, Knowledge& ball) {
  const Party self = partyOf(group, peer);
  const Entry before = entry(ball, peer);
  if (!protocol_.transitions.mayPublish(before.record, self)) return;
  const Record next = protocol_.transitions.publish(before.record, self, kStep);
  raise(ball, peer, {next, before.offer});
  Version sent = next.version;
  sent.owner = self.self;  // a message of states says who owns by who sends it
  send(ball, News::State, sent);
}

void Model::beginTenure(const Record& before, const Record& next) const {
  require(tenureOf(next.version) > tenureOf(before.version), "an old tenure begins anew");
}

void Model::begin(const Group& group, int peer, const Record& next, Knowledge& ball) {
  require(protocol_.transitions.owns(next, partyOf(group, peer).self),
          "who has taken the ball does not own it");
  raise(ball, peer, {next});
  publish(group, peer, ball);
}

bool Model::adopt(const Group& group, int peer, Knowledge& ball) {
  const Transitions& rules = protocol_.transitions;
  const Record record = entry(ball, peer).record;
  const Party self = partyOf(group, peer);
  const Life life = lifeOf(group, peer, record.version.owner, protocol_.conduct);
  if (!rules.mayAdopt(record, self, life)) return false;
  const Record next = rules.adopt(record, self, kStep);
  beginTenure(record, next);
  begin(group, peer, next, ball);
  return true;
}

Word Model::learn(Word record, Word message) {
  const auto [known, isNew] =
      learned_.try_emplace(static_cast<std::uint32_t>(record) << 16 | message, 0);
  if (!isNew) return known->second;
  const Transitions& rules = protocol_.transitions;
  Knowledge one;
  one.records[0] = record;
  const Record before = entry(one, 0).record;
  const Telling told = telling(message);
  if (!rules.isPossible(told.version) || rules.contradicts(before, told.version))
    return known->second = kRefused;
  const auto next = told.news == News::State ? rules.learnState(before, told.version)
                                             : rules.learnOffer(before, told.version);
  if (next) raise(one, 0, {*next, Offer::Open});
  return known->second = next ? one.records[0] : Word{0};
}

std::optional<Knowledge> Model::follow(const Group& to, const Event& event,
                                       const Knowledge& before) {
  const Transitions& rules = protocol_.transitions;
  const int peer = event.peer;
  const Generation generation = generationOf(to, to.members[peer].generation);
  Knowledge ball = before;
  try {
    switch (event.deed) {
      case Deed::Found:
        ball.records[peer] = 0;
        begin(to, peer, rules.found(generation, partyOf(to, peer).self, kStep), ball);
        break;
      case Deed::Enter:
        raise(ball, peer, {rules.unknown(generation)});
        break;
      case Deed::Activate:
        if (protocol_.conduct.activation == Conduct::Activation::WithAllStates &&
            entry(ball, peer).record.version.owner == Incarnation{})
          return std::nullopt;
        break;
      case Deed::FenceAlone:  // keeps its records, the former incarnation's ownership aside
      case Deed::ActivateAlone:
        adopt(to, peer, ball);
        if (entry(ball, peer).record.version.term >= limits_.terms) return std::nullopt;
        break;
      case Deed::Fence:
        set(ball, peer, {rules.unknown(generation)});
        break;
      case Deed::Crash:
        ball.records[peer] = 0;
        break;
      default:
        break;
    }
  } catch (Flaw& flaw) {
    flaw.event = event;
    throw;
  }
  prune(to, ball);
  return ball;
}

void Model::ballMoves(const Group& group, const Knowledge& ball, std::vector<BallMove>& moves) {
  moves.clear();
  for (int peer = 0; peer < limits_.peers; ++peer) {
    if (!isMember(group.members[peer])) continue;
    hear(group, peer, ball, moves);
    own(group, peer, ball, moves);
    offer(group, peer, ball, moves);
  }
  for (BallMove& move : moves) prune(group, move.to);
}

void Model::hear(const Group& group, int peer, const Knowledge& ball,
                 std::vector<BallMove>& moves) {
  const Member& member = group.members[peer];
  const Generation generation = generationOf(group, member.generation);
  for (const Word message : ball.messages()) {
    if (versions_[versionOfMessage(message)].generation != generation) continue;
    const Event event{Deed::Hear, static_cast<std::uint8_t>(peer), message};
    Word next = 0;
    try {
      next = learn(ball.records[peer], message);
    } catch (Flaw& flaw) {
      flaw.event = event;
      throw;
    }
    if (next == kRefused) throw Flaw{"an honest message is refused", event};
    if (next == 0) continue;
    if (member.phase != Phase::Active &&
        protocol_.conduct.gathering == Conduct::Gathering::ForgetsOffers)
      next = static_cast<Word>(next & ~kOpenBit);
    moves.push_back({event, ball});
    moves.back().to.records[peer] = next;
  }
}

void Model::own(const Group& group, int peer, const Knowledge& ball, std::vector<BallMove>& moves) {
  const Transitions& rules = protocol_.transitions;
  const Entry before = entry(ball, peer);
  const Party self = partyOf(group, peer);
  const auto attempt = [&](Deed deed, const auto& change) {
    const Event event{deed, static_cast<std::uint8_t>(peer)};
    Knowledge next = ball;
    try {
      if (change(next)) moves.push_back({event, next});
    } catch (Flaw& flaw) {
      flaw.event = event;
      throw;
    }
  };
  attempt(Deed::Take, [&](Knowledge& next) {
    if (!rules.mayTake(before.record, self)) return false;
    begin(group, peer, rules.take(before.record, self), next);
    return true;
  });
  attempt(Deed::Adopt, [&](Knowledge& next) {
    return adopt(group, peer, next) && entry(next, peer).record.version.term < limits_.terms;
  });
  // Nothing new with the real rules, which publish in the act of taking.
  attempt(Deed::Publish, [&](Knowledge& next) {
    publish(group, peer, next);
    prune(group, next);
    return next.records != ball.records || next.messageCount != ball.messageCount;
  });
  if (rules.withdraw && before.record.standing == Standing::Named && before.offer == Offer::Open)
    attempt(Deed::Withdraw, [&](Knowledge& next) {
      const auto record = rules.withdraw(before.record, self);
      if (!record || record->version.epoch >= limits_.epochs) return false;
      begin(group, peer, *record, next);
      return true;
    });
}

void Model::offer(const Group& group, int peer, const Knowledge& ball,
                  std::vector<BallMove>& moves) {
  const Transitions& rules = protocol_.transitions;
  const Record before = entry(ball, peer).record;
  const Party self = partyOf(group, peer);
  const Era& era = group.generations[group.members[peer].generation - 1];
  const auto attempt = [&](const Party& receiver) {
    if (!rules.mayOffer(before, self, receiver)) return;
    const Event event{Deed::Offer, static_cast<std::uint8_t>(peer)};
    try {
      const Record next = rules.offer(before, self, receiver, kStep);
      if (next.version.epoch >= limits_.epochs) return;
      beginTenure(before, next);
      moves.push_back({event, ball});
      Knowledge& to = moves.back().to;
      raise(to, peer, {next, Offer::Open});
      send(to, News::Offer, next.version);
      moves.back().event.subject = static_cast<Word>(versions_.number(next.version) << 1 | 1);
    } catch (Flaw& flaw) {
      flaw.event = event;
      throw;
    }
  };
  for (int other = 0; other < limits_.peers; ++other) {
    // Believed to be active, perhaps long ago ...
    for (int number = 1; number < kRanks; ++number)
      if (era.wasActive & bitOf(other, number))
        attempt({incarnationOf(other, number), Phase::Active});
    // ... or known not to be.
    if (isMember(group.members[other]) && group.members[other].phase == Phase::Syncing &&
        group.members[other].generation == group.members[peer].generation)
      attempt(partyOf(group, other));
  }
}

// Messages from which nobody can learn any more, now or later, are dropped: what a record does not
// learn from now it never does, because records only rise.
void Model::prune(const Group& group, Knowledge& ball) {
  std::array<bool, kMaxGenerations> isKept{};
  for (int generation = 1; generation <= group.foundings; ++generation)
    isKept[generation - 1] = mayAwaitNewcomers(group, generation, limits_);
  Word kept = 0;
  for (const Word message : ball.messages()) {
    const Generation& of = versions_[versionOfMessage(message)].generation;
    const auto teaches = [&](int peer) {
      const Member& member = group.members[peer];
      return isMember(member) && generationOf(group, member.generation) == of &&
             learn(ball.records[peer], message) != 0;
    };
    bool matters = false;
    for (int generation = 1; generation <= group.foundings; ++generation)
      matters |= isKept[generation - 1] && generationOf(group, generation) == of;
    for (int peer = 0; peer < limits_.peers && !matters; ++peer) matters = teaches(peer);
    if (matters) ball.messageWords[kept++] = message;
  }
  ball.messageCount = kept;
}

void Model::check(const Group& group, const Knowledge& ball) const {
  std::array<Word, Knowledge::kMaxMessages + kMaxPeers> seen{};
  std::size_t count = 0;
  const auto see = [&](Word number) {
    for (std::size_t i = 0; i < count; ++i)
      if (versions_.tenure(seen[i]) == versions_.tenure(number))
        require(versions_[seen[i]].owner == versions_[number].owner, "a tenure has two owners");
    seen[count++] = number;
  };
  for (const Word message : ball.messages()) see(versionOfMessage(message));

  std::array<Version, kMaxPeers> acting;
  std::size_t actors = 0;
  for (int peer = 0; peer < limits_.peers; ++peer) {
    const Member& member = group.members[peer];
    if (!isMember(member)) continue;
    const Record record = entry(ball, peer).record;
    const Version& version = record.version;
    require(version.generation == generationOf(group, member.generation),
            "a record of another generation");
    if (version.owner != Incarnation{}) see(versionOfRecord(ball.records[peer]));
    if (member.phase != Phase::Active) continue;
    require(version.owner != Incarnation{}, "an active peer has no record of the ball");
    require(protocol_.transitions.isPossible(version), "a version that nobody can have made");
    if (!protocol_.transitions.owns(record, partyOf(group, peer).self)) continue;
    for (std::size_t i = 0; i < actors; ++i)
      require(acting[i].generation != version.generation || acting[i].term != version.term ||
                  acting[i].adopter != version.adopter,
              "two peers act as owners in one term");
    acting[actors++] = version;
  }
  require(actors <= 1 || !isCalm(group), "two peers act as owners though nothing has failed");
}

}  // namespace wells
