// What must hold in every state.
#include <algorithm>

#include "search/healing.h"
#include "search/model.h"

namespace wells {

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

void Model::check(std::uint32_t number, const Knowledge& ball) {
  checkTenures(ball);
  const Group& group = groups_[number].group;
  std::array<std::uint32_t, 1 + kMaxPeers> choices{groups_[number].core};
  for (int peer = 0; peer < kMaxPeers; ++peer) {
    const Word record = ball.records[peer];
    if (isMember(group.members[peer])) {
      hearAll(group, peer, record, ball.messages(), records_[peer]);
    } else {
      records_[peer].assign(1, record);
    }
    choices[1 + peer] = choices_.number(records_[peer]);
  }
  const std::size_t known = checkedChoices_.size();
  checkedChoices_.number(choices);
  if (checkedChoices_.size() == known) return;

  for (const Word first : records_[0])
    for (const Word second : records_[1])
      for (const Word third : records_[2]) {
        std::uint64_t one = groups_[number].core;
        for (const Word record : {first, second, third}) one = one << 16 | record;
        const std::size_t before = checked_.size();
        checked_.number(one);
        if (checked_.size() > before) checkCase(group, {first, second, third});
      }
}

void Model::checkCase(const Group& group, const std::array<Word, kMaxPeers>& records) {
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
  if (limits_.promises == Promises::Safety) return;
  for (const Turns turns : {Turns::LowestFirst, Turns::HighestFirst, Turns::AllAtOnce})
    if (const auto failure = failureToHeal(group, entries, limits_, protocol_, turns))
      fail("does not heal: " + *failure);
}

}  // namespace wells
