#include "search/group.h"

#include <algorithm>
#include <stdexcept>

namespace wells {
namespace {

/// One rank in each gap between the used ones.
std::vector<int> freshRanks(unsigned used) {
  std::vector<int> ranks;
  int below = 0;
  for (int rank = 1; rank <= kRanks; ++rank) {
    if (rank < kRanks && !(used >> rank & 1u)) continue;
    const int middle = (below + rank) / 2;
    if (middle == below) throw std::logic_error("search: too many incarnations or foundings");
    ranks.push_back(middle);
    below = rank;
  }
  return ranks;
}

std::vector<int> nextNumbers(const Group& group, int peer, const Conduct& conduct) {
  if (conduct.numbers == Conduct::Numbers::Reused) return {kRanks / 2};
  return freshRanks(group.numbersUsed[peer]);
}

void forgetSuspicions(Group& group, int peer) {
  group.suspects[peer] = 0;
  for (std::uint8_t& suspects : group.suspects)
    suspects &= static_cast<std::uint8_t>(~(1u << peer));
}

void become(Group& group, int peer, const Member& member) {
  forgetSuspicions(group, peer);
  group.members[peer] = member;
  if (member.number != 0)
    group.numbersUsed[peer] =
        static_cast<std::uint16_t>(group.numbersUsed[peer] | 1u << member.number);
  if (member.phase == Phase::Active)
    group.generations[member.generation - 1].wasActive |= bitOf(peer, member.number);
}

void activate(Group& group, int peer) {
  Member& member = group.members[peer];
  member.phase = Phase::Active;
  group.generations[member.generation - 1].wasActive |= bitOf(peer, member.number);
}

/// `group` after `peer` has suspected every other active member of its generation.
std::optional<Group> alone(const Group& group, int peer, const Limits& limits) {
  std::optional<Group> next = group;
  for (int other = 0; other < kMaxPeers && next; ++other) {
    const Member& member = group.members[other];
    if (other != peer && isMember(member) && member.phase == Phase::Active &&
        member.generation == group.members[peer].generation &&
        !(group.suspects[peer] >> other & 1u))
      next = afterSuspicion(*next, peer, other, limits);
  }
  return next;
}

bool isListening(const Member& member) {
  return member.number != 0 && member.phase == Phase::Joining;
}

class Moves {
 public:
  Moves(const Group& group, const Limits& limits, const Conduct& conduct)
      : group_(group), limits_(limits), conduct_(conduct) {
    if (isPassing(group, limits)) {
      for (int peer = 0; moves_.empty(); ++peer)
        if (isListening(group.members[peer])) enter(peer);
      return;
    }
    for (int peer = 0; peer < limits.peers; ++peer) {
      const Member& member = group.members[peer];
      if (member.number == 0) {
        restart(peer);
        continue;
      }
      if (isListening(member)) found(peer);
      enter(peer);
      if (member.phase == Phase::Syncing) join(peer);
      if (member.phase == Phase::Syncing) retreat(peer);
      if (member.phase == Phase::Active) fence(peer);
      if (member.phase == Phase::Active) reset(peer);
      crash(peer);
    }
  }

  std::vector<GroupMove> take() { return std::move(moves_); }

 private:
  Group& add(Deed deed, int peer, int subject = 0) {
    moves_.push_back(
        {{deed, static_cast<std::uint8_t>(peer), static_cast<std::uint16_t>(subject)}, group_});
    return moves_.back().to;
  }

  void restart(int peer) {
    if (group_.restarts >= limits_.restarts) return;
    const std::vector<int> numbers = nextNumbers(group_, peer, conduct_);
    for (const int number : numbers) {
      Group& to = add(Deed::Restart, peer);
      ++to.restarts;
      become(to, peer, {Phase::Joining, static_cast<std::uint8_t>(number), 0});
      moves_.back().isReordering = number != numbers.front();
    }
  }

  void found(int peer) {
    if (group_.eras - group_.resets >= limits_.foundings) return;
    beginEra(Deed::Found, peer, 0);
  }

  // Whoever takes itself for the lowest of the living does it.
  void reset(int peer) {
    if (group_.resets >= limits_.resets) return;
    const Era& era = group_.generations[group_.members[peer].generation - 1];
    beginEra(Deed::Reset, peer, era.resets + 1);
  }

  void beginEra(Deed deed, int peer, int resets) {
    unsigned used = 0;
    for (const Era& era : group_.generations)
      if (era.founded) used |= 1u << era.founded;
    for (const int rank : freshRanks(used)) {
      Group& to = add(deed, peer);
      if (deed == Deed::Reset) ++to.resets;
      to.generations[to.eras++] = {.founded = static_cast<std::uint8_t>(rank),
                                   .resets = static_cast<std::uint8_t>(resets)};
      become(to, peer, {Phase::Active, group_.members[peer].number, to.eras});
    }
  }

  void enter(int peer) {
    const Member& member = group_.members[peer];
    for (int generation = 1; generation <= group_.eras; ++generation) {
      const bool isGreater =
          generationOf(group_, generation) > generationOf(group_, member.generation);
      if (isGreater)
        become(add(Deed::Enter, peer, generation), peer,
               {Phase::Syncing, member.number, static_cast<std::uint8_t>(generation)});
    }
  }

  void join(int peer) {
    activate(add(Deed::Activate, peer), peer);
    if (const auto group = alone(group_, peer, limits_)) {
      Group& to = add(Deed::ActivateAlone, peer);
      to = *group;
      activate(to, peer);
    }
  }

  void retreat(int peer) {
    const auto group = alone(group_, peer, limits_);
    if (group_.fences >= limits_.fences || !group) return;
    const std::vector<int> numbers = nextNumbers(group_, peer, conduct_);
    const Generation own = generationOf(group_, group_.members[peer].generation);
    for (int generation = 1; generation <= group_.eras; ++generation)
      for (const int number : numbers) {
        if (generationOf(group_, generation) >= own) continue;
        Group& to = add(Deed::Retreat, peer, generation);
        to = *group;
        ++to.fences;
        become(to, peer,
               {Phase::Syncing, static_cast<std::uint8_t>(number),
                static_cast<std::uint8_t>(generation)});
        moves_.back().isReordering = number != numbers.front();
      }
  }

  void fence(int peer) {
    if (group_.fences >= limits_.fences) return;
    const std::uint8_t generation = group_.members[peer].generation;
    const std::vector<int> numbers = nextNumbers(group_, peer, conduct_);
    for (const int number : numbers) {
      const auto next = static_cast<std::uint8_t>(number);
      Group& to = add(Deed::Fence, peer);
      ++to.fences;
      become(to, peer, {Phase::Syncing, next, generation});
      moves_.back().isReordering = number != numbers.front();
      if (const auto group = alone(group_, peer, limits_)) {
        Group& left = add(Deed::FenceAlone, peer);
        left = *group;
        ++left.fences;
        become(left, peer, {Phase::Active, next, generation});
        moves_.back().isReordering = number != numbers.front();
      }
    }
  }

  void crash(int peer) {
    if (group_.crashes >= limits_.crashes) return;
    Group& to = add(Deed::Crash, peer);
    ++to.crashes;
    become(to, peer, {});
  }

  const Group& group_;
  const Limits& limits_;
  const Conduct& conduct_;
  std::vector<GroupMove> moves_;
};

}  // namespace

Group newGroup(const Limits& limits) {
  Group group;
  for (int peer = 0; peer < limits.peers; ++peer)
    become(group, peer, {Phase::Joining, kRanks / 2, 0});
  return group;
}

bool isPassing(const Group& group, const Limits& limits) {
  return limits.foundings + limits.resets == 1 && group.eras == 1 &&
         std::ranges::any_of(group.members, isListening);
}

std::vector<GroupMove> movesOf(const Group& group, const Limits& limits, const Conduct& conduct) {
  return Moves(group, limits, conduct).take();
}

Generation generationOf(const Group& group, int generation) {
  if (generation == 0) return {};
  const Era& era = group.generations[generation - 1];
  return {.resets = era.resets, .foundedUs = era.founded};
}

Life lifeOf(const Group& group, int peer, const Incarnation& owner, const Conduct& conduct) {
  if (owner.peer == kNobody) return Life::Ended;
  const int other = value(owner.peer) - 1;
  const Member& member = group.members[other];
  const bool isSame = conduct.lease == Conduct::Lease::OfPeer || member.number == owner.number;
  const bool runs =
      isSame && isMember(member) && member.generation == group.members[peer].generation;
  return runs && !(group.suspects[peer] >> other & 1u) ? Life::Lasts : Life::Ended;
}

std::optional<Group> afterSuspicion(const Group& group, int peer, int other, const Limits& limits) {
  if (group.suspicions >= limits.suspicions) return std::nullopt;
  Group next = group;
  next.suspects[peer] = static_cast<std::uint8_t>(next.suspects[peer] | 1u << other);
  ++next.suspicions;
  return next;
}

bool mayAwaitNewcomers(const Group& group, int generation, const Limits& limits) {
  if (group.fences < limits.fences) return true;
  const bool mayRestart = group.restarts < limits.restarts;
  for (int peer = 0; peer < limits.peers; ++peer) {
    const Member& member = group.members[peer];
    if (member.number == 0 || group.crashes < limits.crashes) {
      if (mayRestart) return true;
      if (member.number == 0) continue;
    }
    if (generationOf(group, member.generation) < generationOf(group, generation)) return true;
  }
  return false;
}

bool isCalm(const Group& group) {
  return group.suspicions == 0 && group.crashes == 0 && group.fences == 0 && group.eras <= 1;
}

}  // namespace wells
