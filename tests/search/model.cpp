#include "search/model.h"

#include <algorithm>
#include <utility>

namespace wells {
namespace {

// In place of a record that was learned.
constexpr Word kNothingNew = 0, kNotTried = 1, kRefused = 2;

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

Word Model::messageOf(News news, const Version& version) {
  return static_cast<Word>(versions_.number(version) << 1 | (news == News::Offer ? 1 : 0));
}

std::size_t Model::bytes() const {
  return checked_.bytes() + choices_.bytes() + checkedChoices_.bytes() + actsKeys_.bytes() +
         acts_.size() * (sizeof(Acts) + 4 * sizeof(Act));
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
  marks_[record] = ++mark_;
  for (std::size_t i = 0; i < records.size(); ++i)
    for (const Word message : messages) {
      const Word next = hear(group, peer, records[i], message);
      if (std::exchange(marks_[next], mark_) != mark_) records.push_back(next);
    }
}

void Model::hear(std::uint32_t group, int peer, const Knowledge& ball,
                 std::vector<BallMove>& moves) {
  const Word before = ball.records[peer];
  for (const Word message : ball.messages()) {
    const Word next = hear(groups_[group].group, peer, before, message);
    if (next == before) continue;
    const Event event{Deed::Hear, static_cast<std::uint8_t>(peer), message, before};
    carryOut({event, next, 0, group}, ball, moves);
  }
}

void Model::carryOut(const Act& act, const Knowledge& ball, std::vector<BallMove>& moves) const {
  moves.push_back({act.event, ball, act.group});
  Knowledge& to = moves.back().to;
  to.records[act.event.peer] = act.record;
  if (act.sent != 0) to.send(act.sent);
}

void Model::ballMoves(std::uint32_t group, const Knowledge& ball, std::vector<BallMove>& moves) {
  moves.clear();
  for (int peer = 0; peer < limits_.peers; ++peer) {
    if (!isMember(groups_[group].group.members[peer])) continue;
    if (limits_.hearing == Hearing::AtAnyTime) hear(group, peer, ball, moves);
    if (groups_[group].isPassing) continue;
    Words& records = records_[peer];
    hearAll(groups_[group].group, peer, ball.records[peer], ball.messages(), records);
    for (const Word record : records)
      for (const Act& act : actsOf(group, peer, record)) carryOut(act, ball, moves);
  }
  for (BallMove& move : moves) prune(move.group, move.to);
  std::erase_if(moves,
                [&](const BallMove& move) { return move.to == ball && move.group == group; });
}

void Model::follow(std::uint32_t group, std::size_t step, const Knowledge& ball,
                   std::vector<BallMove>& moves) {
  moves.clear();
  const GroupStep& taken = groups_.steps(group)[step];
  const Word before = ball.records[taken.event.peer];
  if (taken.event.deed == Deed::Activate || taken.event.deed == Deed::ActivateAlone) {
    activate(group, taken, ball, moves);
  } else {
    for (const Act& act : resultOf(group, step, before)) carryOut(act, ball, moves);
  }
  for (BallMove& move : moves) prune(move.group, move.to);
}

void Model::activate(std::uint32_t group, const GroupStep& step, const Knowledge& ball,
                     std::vector<BallMove>& moves) {
  const int peer = step.event.peer;
  const Group& to = groups_[step.to].group;
  const auto isUnknown = [&](Word record) {
    return entry(record).record.version.owner == Incarnation{};
  };
  Words records, later;
  hearAll(groups_[group].group, peer, ball.records[peer], ball.messages(), records);
  if (protocol_.conduct.activation == Conduct::Activation::WithAllStates)
    std::erase_if(records, isUnknown);
  std::ranges::sort(records, {}, [&](Word record) { return entry(record).record.version; });
  // What it can hear later as well need not be tried as what it has heard by now.
  for (std::size_t i = 0; i < records.size(); ++i) {
    hearAll(to, peer, records[i], ball.messages(), later);
    records.erase(
        std::remove_if(records.begin() + static_cast<std::ptrdiff_t>(i) + 1, records.end(),
                       [&](Word record) { return marks_[record] == mark_; }),
        records.end());
  }
  for (const Word record : records) carryOut({step.event, record, 0, step.to}, ball, moves);

  if (step.event.deed != Deed::ActivateAlone || !isUnknown(ball.records[peer])) return;
  // Nobody tells it of the ball: it takes it from where it was first.
  Act act{step.event, ball.records[peer], 0, step.to};
  during(step.event, [&] {
    if (adopt(partyOf(to, peer), Life::Ended, act)) carryOut(act, ball, moves);
  });
}

// Messages from which nobody can learn any more, now or later, are dropped: what a record does not
// learn from now it never does, because records only rise.
void Model::prune(std::uint32_t number, Knowledge& ball) {
  const unsigned awaited = groups_[number].awaited;
  const Group& group = groups_[number].group;
  const auto teaches = [&](Word message, int peer) {
    try {
      return isMember(group.members[peer]) &&
             hear(group, peer, ball.records[peer], message) != ball.records[peer];
    } catch (const Flaw&) {
      return true;  // to be found when the state is looked at
    }
  };
  Word kept = 0;
  for (const Word message : ball.messages()) {
    bool matters = awaited >> versions_.founded(versionOfMessage(message)) & 1u;
    for (int peer = 0; peer < limits_.peers && !matters; ++peer) matters = teaches(message, peer);
    if (matters) ball.messageWords[kept++] = message;
  }
  ball.messageCount = kept;
}

bool Model::hasAdopted(int peer, const Knowledge& ball) const {
  const auto isAdopter = [&](Word number) { return versions_.adopter(number) == peer; };
  return std::ranges::any_of(ball.records, isAdopter, versionOfRecord) ||
         std::ranges::any_of(ball.messages(), isAdopter, versionOfMessage);
}

}  // namespace wells
