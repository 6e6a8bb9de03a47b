#include "search/model.h"

#include <algorithm>
#include <tuple>

#include "search/healing.h"

namespace wells {
namespace {

constexpr std::int64_t kStep = 0;  // knowledge.h says why

// In place of a record that was learned.
constexpr Word kNothingNew = 0, kNotTried = 1, kRefused = 2;

/// The order of tenures; owner and step left out.
auto tenureOf(const Version& version) {
  return std::tuple(version.generation, version.term, version.adopter, version.epoch);
}

void require(bool holds, const char* what) {
  if (!holds) throw Flaw{what};
}

/// Names the event in which a flaw shows.
template <class Action>
void during(const Event& event, const Action& action) {
  try {
    action();
  } catch (Flaw& flaw) {
    flaw.event = event;
    throw;
  }
}

bool contains(const std::vector<Word>& words, Word word) {
  return std::ranges::find(words, word) != words.end();
}

std::uint16_t packed(const Member& member) {
  return static_cast<std::uint16_t>(static_cast<int>(member.phase) << 12 | member.number << 4 |
                                    member.generation);
}

}  // namespace

Entry Model::entry(Word record) const {
  return {
      {versions_[versionOfRecord(record)], record & kHeardBit ? Standing::Heard : Standing::Named},
      record & kOpenBit ? Offer::Open : Offer::Closed};
}

Telling Model::telling(Word message) const {
  return {newsOf(message), versions_[versionOfMessage(message)]};
}

Word Model::wordOf(const Entry& entry) {
  const bool isHeard = entry.record.standing == Standing::Heard;
  const bool isOpen = !isHeard && entry.offer == Offer::Open;
  return static_cast<Word>(versions_.number(entry.record.version) << 2 | (isHeard ? kHeardBit : 0) |
                           (isOpen ? kOpenBit : 0));
}

Word Model::raised(Word before, const Entry& next) {
  const Record old = entry(before).record;
  require(next.record.version >= old.version, "a peer goes back to a lower version");
  require(next.record.version > old.version || next.record.standing == Standing::Heard ||
              old.standing == Standing::Named,
          "a peer forgets that it has heard the owner");
  return wordOf(next);
}

void Model::send(Knowledge& ball, News news, const Version& version) {
  ball.send(static_cast<Word>(versions_.number(version) << 1 | (news == News::Offer ? 1 : 0)));
}

// What an owner can publish is sent at once: the network may keep it for as long as it likes.
void Model::publish(const Group& group, int peer, Knowledge& ball) {
  const Party self = partyOf(group, peer);
  const Entry before = entry(ball.records[peer]);
  if (!protocol_.transitions.mayPublish(before.record, self)) return;
  const Record next = protocol_.transitions.publish(before.record, self, kStep);
  ball.records[peer] = raised(ball.records[peer], {next, before.offer});
  Version sent = next.version;
  sent.owner = self.self;  // a message of states says who owns by who sends it
  send(ball, News::State, sent);
}

void Model::begin(const Group& group, int peer, const Record& next, Knowledge& ball) {
  require(protocol_.transitions.owns(next, partyOf(group, peer).self),
          "who has taken the ball does not own it");
  ball.records[peer] = raised(ball.records[peer], {next});
  publish(group, peer, ball);
}

bool Model::adopt(const Group& group, int peer, Life life, Knowledge& ball) {
  const Transitions& rules = protocol_.transitions;
  const Record record = entry(ball.records[peer]).record;
  const Party self = partyOf(group, peer);
  if (!rules.mayAdopt(record, self, life)) return false;
  const Record next = rules.adopt(record, self, kStep);
  if (next.version.term >= limits_.terms) return false;
  require(tenureOf(next.version) > tenureOf(record.version), "an old tenure begins anew");
  begin(group, peer, next, ball);
  return true;
}

Word Model::learn(Word record, Word message) {
  if (learned_.size() <= record) learned_.resize(record + 1u);
  Words& row = learned_[record];
  if (row.size() <= message) row.resize(message + 64u, kNotTried);
  if (row[message] != kNotTried) return row[message];
  const Transitions& rules = protocol_.transitions;
  const Record before = entry(record).record;
  const Telling told = telling(message);
  if (!rules.isPossible(told.version) || rules.contradicts(before, told.version))
    return row[message] = kRefused;
  const auto next = told.news == News::State ? rules.learnState(before, told.version)
                                             : rules.learnOffer(before, told.version);
  return row[message] = next ? raised(record, {*next, Offer::Open}) : kNothingNew;
}

/// The record of `peer` after a message.
Word Model::hear(const Group& group, int peer, Word record, Word message) {
  const Member& member = group.members[peer];
  if (versions_.founded(versionOfMessage(message)) !=
      group.generations[member.generation - 1].founded)
    return record;
  Word next = 0;
  const Event event{Deed::Hear, static_cast<std::uint8_t>(peer), message, record};
  during(event, [&] {
    next = learn(record, message);
    require(next != kRefused, "an honest message is refused");
  });
  if (next == kNothingNew) return record;
  if (member.phase != Phase::Active &&
      protocol_.conduct.gathering == Conduct::Gathering::ForgetsOffers)
    next = static_cast<Word>(next & ~kOpenBit);
  return next;
}

/// All records that `peer` may have by now, the one that it has included.
void Model::hearAll(const Group& group, int peer, Word record, std::span<const Word> messages,
                    Words& records) {
  records.assign(1, record);
  if (limits_.hearing == Hearing::AtAnyTime) return;
  for (std::size_t i = 0; i < records.size(); ++i)
    for (const Word message : messages) {
      const Word next = hear(group, peer, records[i], message);
      if (!contains(records, next)) records.push_back(next);
    }
}

void Model::follow(const Group& from, const Group& to, const Event& event, const Knowledge& ball,
                   std::vector<BallMove>& moves) {
  const Transitions& rules = protocol_.transitions;
  const int peer = event.peer;
  moves.clear();
  if (event.deed == Deed::Activate || event.deed == Deed::ActivateAlone) {
    activate(from, to, event, ball, moves);
  } else {
    moves.push_back({event, ball, to});
    Knowledge& next = moves.back().to;
    Word& record = next.records[peer];
    const Generation generation = generationOf(to, to.members[peer].generation);
    during(event, [&] {
      if (event.deed == Deed::Crash || event.deed == Deed::Found) record = 0;
      if (event.deed == Deed::Found)
        begin(to, peer, rules.found(generation, partyOf(to, peer).self, kStep), next);
      if (event.deed == Deed::Enter) record = raised(record, {rules.unknown(generation)});
      if (event.deed == Deed::Fence) record = wordOf({rules.unknown(generation)});
      // FenceAlone keeps the record, which names an incarnation that is gone: adoption follows.
    });
  }
  for (BallMove& move : moves) prune(to, move.to);
}

void Model::activate(const Group& from, const Group& to, const Event& event, const Knowledge& ball,
                     std::vector<BallMove>& moves) {
  const int peer = event.peer;
  const Word before = ball.records[peer];
  const bool isBlind = protocol_.conduct.activation == Conduct::Activation::Blind;
  const auto isUnknown = [&](Word record) {
    return entry(record).record.version.owner == Incarnation{};
  };
  Words records;
  hearAll(from, peer, before, ball.messages(), records);
  if (!isBlind) std::erase_if(records, isUnknown);
  // What it can hear later as well need not be tried as what it has heard by now.
  for (std::size_t i = 0; i < records.size(); ++i) {
    Words later;
    hearAll(to, peer, records[i], ball.messages(), later);
    std::erase_if(records, [&](Word record) {
      return record != records[i] && contains(later, record) && record > records[i];
    });
  }
  for (const Word record : records) {
    moves.push_back({event, ball, to});
    moves.back().to.records[peer] = record;
  }
  if (event.deed != Deed::ActivateAlone || !isUnknown(before)) return;
  // Nobody tells it of the ball: it takes it from where it was first.
  during(event, [&] {
    Knowledge next = ball;
    if (adopt(to, peer, Life::Ended, next)) moves.push_back({event, next, to});
  });
}

void Model::ballMoves(const Group& group, const Knowledge& ball, std::vector<BallMove>& moves) {
  moves.clear();
  for (int peer = 0; peer < limits_.peers; ++peer) {
    if (!isMember(group.members[peer])) continue;
    if (limits_.hearing == Hearing::AtAnyTime) hear(group, peer, ball, moves);
    Words records;
    hearAll(group, peer, ball.records[peer], ball.messages(), records);
    for (const Word record : records) {
      Knowledge heard = ball;
      heard.records[peer] = record;
      act(group, peer, heard, moves);
      offer(group, peer, heard, moves);
    }
  }
  for (BallMove& move : moves) prune(group, move.to);
}

void Model::hear(const Group& group, int peer, const Knowledge& ball,
                 std::vector<BallMove>& moves) {
  for (const Word message : ball.messages()) {
    const Word before = ball.records[peer];
    const Word next = hear(group, peer, before, message);
    if (next == before) continue;
    moves.push_back({{Deed::Hear, static_cast<std::uint8_t>(peer), message, before}, ball, group});
    moves.back().to.records[peer] = next;
  }
}

void Model::act(const Group& group, int peer, const Knowledge& ball, std::vector<BallMove>& moves) {
  const Transitions& rules = protocol_.transitions;
  const Entry before = entry(ball.records[peer]);
  const Party self = partyOf(group, peer);
  const auto attempt = [&](Deed deed, const Group& after, const auto& change) {
    const Event event{deed, static_cast<std::uint8_t>(peer), 0, ball.records[peer]};
    Knowledge next = ball;
    during(event, [&] {
      if (change(next)) moves.push_back({event, next, after});
    });
  };
  attempt(Deed::Take, group, [&](Knowledge& next) {
    if (!rules.mayTake(before.record, self)) return false;
    begin(group, peer, rules.take(before.record, self), next);
    return true;
  });

  const Incarnation& owner = before.record.version.owner;
  const Life life = lifeOf(group, peer, owner, protocol_.conduct);
  attempt(Deed::Adopt, group, [&](Knowledge& next) { return adopt(group, peer, life, next); });
  if (life == Life::Lasts && owner != self.self)
    if (const auto after = afterSuspicion(group, peer, value(owner.peer) - 1, limits_))
      attempt(Deed::AdoptWrongly, *after,
              [&](Knowledge& next) { return adopt(*after, peer, Life::Ended, next); });

  // Nothing new with the real rules, under which the act of taking the ball publishes it.
  attempt(Deed::Publish, group, [&](Knowledge& next) {
    publish(group, peer, next);
    prune(group, next);
    return next.records != ball.records || next.messageCount != ball.messageCount;
  });
  if (rules.withdraw && before.record.standing == Standing::Named && before.offer == Offer::Open)
    attempt(Deed::Withdraw, group, [&](Knowledge& next) {
      const auto record = rules.withdraw(before.record, self);
      if (!record || record->version.epoch >= limits_.epochs) return false;
      begin(group, peer, *record, next);
      return true;
    });
}

void Model::offer(const Group& group, int peer, const Knowledge& ball,
                  std::vector<BallMove>& moves) {
  const Transitions& rules = protocol_.transitions;
  const Record before = entry(ball.records[peer]).record;
  const Party self = partyOf(group, peer);
  const Era& era = group.generations[group.members[peer].generation - 1];
  const auto attempt = [&](const Party& receiver) {
    if (!rules.mayOffer(before, self, receiver)) return;
    Event event{Deed::Offer, static_cast<std::uint8_t>(peer), 0, ball.records[peer]};
    during(event, [&] {
      const Record next = rules.offer(before, self, receiver, kStep);
      if (next.version.epoch >= limits_.epochs) return;
      require(tenureOf(next.version) > tenureOf(before.version), "an old tenure begins anew");
      event.subject = static_cast<Word>(versions_.number(next.version) << 1 | 1);
      Knowledge to = ball;
      to.records[peer] = raised(to.records[peer], {next, Offer::Open});
      send(to, News::Offer, next.version);
      moves.push_back({event, to, group});
    });
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
  unsigned awaited = 0;  // bit by rank of founding
  for (int generation = 1; generation <= group.foundings; ++generation)
    if (mayAwaitNewcomers(group, generation, limits_))
      awaited |= 1u << group.generations[generation - 1].founded;
  Word kept = 0;
  for (const Word message : ball.messages()) {
    bool matters = awaited >> versions_.founded(versionOfMessage(message)) & 1u;
    for (int peer = 0; peer < limits_.peers && !matters; ++peer)
      matters = isMember(group.members[peer]) &&
                hear(group, peer, ball.records[peer], message) != ball.records[peer];
    if (matters) ball.messageWords[kept++] = message;
  }
  ball.messageCount = kept;
}

void Model::checkTenures(const Knowledge& ball) const {
  std::array<Word, Knowledge::kMaxMessages + kMaxPeers> seen{};
  std::size_t count = 0;
  const auto see = [&](Word number) {
    const Version& version = versions_[number];
    if (version.owner == Incarnation{}) return;
    for (std::size_t i = 0; i < count; ++i)
      if (versions_.tenure(seen[i]) == versions_.tenure(number))
        require(versions_[seen[i]].owner == version.owner, "a tenure has two owners");
    seen[count++] = number;
  };
  for (const Word message : ball.messages()) see(versionOfMessage(message));
  for (const Word record : ball.records) see(versionOfRecord(record));
}

void Model::check(const Group& group, const Knowledge& ball) {
  checkTenures(ball);
  std::array<Words, kMaxPeers> records;
  for (int peer = 0; peer < kMaxPeers; ++peer) {
    if (isMember(group.members[peer]))
      hearAll(group, peer, ball.records[peer], ball.messages(), records[peer]);
    else
      records[peer].assign(1, ball.records[peer]);
  }
  Core core{};
  const bool calm = isCalm(group);
  for (int peer = 0; peer < kMaxPeers; ++peer) {
    core[peer] = packed(group.members[peer]);
    core[6 + peer] = group.generations[peer].founded;
  }
  core[9] = calm ? 1 : 0;
  for (const Word first : records[0])
    for (const Word second : records[1])
      for (const Word third : records[2]) {
        core[3] = first;
        core[4] = second;
        core[5] = third;
        const std::size_t before = checked_.size();
        checked_.number(core);
        if (checked_.size() == before) continue;
        checkCore(group, {first, second, third});
      }
}

void Model::checkCore(const Group& group, const std::array<Word, kMaxPeers>& records) {
  const auto fail = [&](const std::string& what) { throw Flaw{what, {}, records}; };
  std::array<Version, kMaxPeers> acting;
  std::size_t actors = 0;
  std::array<Entry, kMaxPeers> entries;
  for (int peer = 0; peer < limits_.peers; ++peer) {
    const Member& member = group.members[peer];
    entries[peer] = entry(records[peer]);
    if (!isMember(member)) continue;
    const Record& record = entries[peer].record;
    const Version& version = record.version;
    if (version.generation != generationOf(group, member.generation))
      fail("a record of another generation");
    if (member.phase != Phase::Active) continue;
    if (version.owner == Incarnation{}) fail("an active peer knows nothing of the ball");
    if (!protocol_.transitions.isPossible(version)) fail("a version that nobody can have made");
    if (!protocol_.transitions.owns(record, partyOf(group, peer).self)) continue;
    for (std::size_t i = 0; i < actors; ++i)
      if (acting[i].generation == version.generation && acting[i].term == version.term &&
          acting[i].adopter == version.adopter)
        fail("two peers act as owners in one term");
    acting[actors++] = version;
  }
  if (actors > 1 && isCalm(group)) fail("two peers act as owners though nothing has failed");
  for (const Turns turns : {Turns::LowestFirst, Turns::HighestFirst, Turns::AllAtOnce})
    if (const auto failure = failureToHeal(group, entries, limits_, protocol_, turns))
      fail("does not heal: " + *failure);
}

}  // namespace wells
