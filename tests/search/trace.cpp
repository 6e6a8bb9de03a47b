#include "search/trace.h"

#include <fmt/format.h>

namespace wells {
namespace {

// P2#8: peer 2 in its incarnation 8.
std::string nameOf(const Incarnation& who) {
  if (who.peer == kNobody) return "nobody";
  return fmt::format("P{}#{}", value(who.peer), who.number);
}

std::string nameOf(const Version& version) {
  if (version.owner == Incarnation{}) return "nothing";
  std::string lineage =
      fmt::format("generation {}, term {}", version.generation.foundedUs, version.term);
  if (version.term > 0) lineage += " by " + nameOf(version.adopter);
  return fmt::format("{}, epoch {}: {}", lineage, version.epoch, nameOf(version.owner));
}

}  // namespace

std::string describe(const Event& event, const Group& before, const Group& after,
                     std::optional<int> ball, Word record, const Model& model) {
  const auto self = [&](const Group& group) {
    return nameOf(incarnationOf(event.peer, group.members[event.peer].number));
  };
  std::string who = self(before);
  if (ball && event.deed != Deed::Hear && event.basis != record) {
    const Entry known = model.entry(event.basis);
    who += fmt::format(", which has heard the {} ({}),",
                       known.record.standing == Standing::Heard ? "state" : "offer",
                       nameOf(known.record.version));
  }
  const std::string what = ball ? fmt::format("ball {}", *ball) : "";
  switch (event.deed) {
    case Deed::Found:
      return fmt::format("{} hears nobody and founds generation {}", who,
                         generationOf(after, after.members[event.peer].generation).foundedUs);
    case Deed::Enter:
      return fmt::format("{} enters generation {}", who,
                         generationOf(after, event.subject).foundedUs);
    case Deed::Reset:
      return fmt::format("{} starts the world over, in generation {}", who,
                         generationOf(after, after.members[event.peer].generation).foundedUs);
    case Deed::Retreat:
      return fmt::format("{} finds nobody in its generation, enters generation {} as {}", who,
                         generationOf(after, event.subject).foundedUs, self(after));
    case Deed::Activate:
      return who + " has all states and becomes active";
    case Deed::ActivateAlone:
      return who + " hears nobody and goes on alone";
    case Deed::Crash:
      return who + " crashes or leaves";
    case Deed::Restart:
      return fmt::format("P{} starts again as {}", event.peer + 1, self(after));
    case Deed::Fence:
      return fmt::format("{} stood still, starts over as {}", who, self(after));
    case Deed::FenceAlone:
      return fmt::format("{} stood still with nobody there, goes on as {}", who, self(after));
    case Deed::Hear: {
      const Telling told = model.telling(event.subject);
      return fmt::format("{} hears the {} of {} ({})", who,
                         told.news == News::State ? "state" : "offer", what, nameOf(told.version));
    }
    case Deed::Take:
      return fmt::format("{} takes {} and publishes it", who, what);
    case Deed::Offer:
      if (event.subject == 0) return fmt::format("{} offers {}", who, what);
      return fmt::format("{} offers {} to {}", who, what,
                         nameOf(model.telling(event.subject).version.owner));
    case Deed::Adopt:
      return fmt::format("{} adopts {} and publishes it", who, what);
    case Deed::AdoptWrongly:
      return fmt::format("{} suspects the owner of {} wrongly, adopts it and publishes it", who,
                         what);
    case Deed::Publish:
      return fmt::format("{} publishes {}", who, what);
    case Deed::Withdraw:
      return fmt::format("{} withdraws its offer of {}", who, what);
  }
  return "?";
}

std::vector<std::string> describe(const Group& group, std::span<const Knowledge> balls,
                                  const Model& model, const Limits& limits) {
  std::vector<std::string> lines;
  for (int peer = 0; peer < limits.peers; ++peer) {
    const Member& member = group.members[peer];
    if (member.number == 0) {
      lines.push_back(fmt::format("P{} gone", peer + 1));
      continue;
    }
    const Party party = partyOf(group, peer);
    std::string line = fmt::format("{} {}", nameOf(party.self), name(party.phase));
    for (std::size_t ball = 0; isMember(member) && ball < balls.size(); ++ball) {
      const Record record = model.entry(balls[ball].records[peer]).record;
      std::string_view standing = record.standing == Standing::Heard ? " heard" : " named";
      if (record.version.owner == Incarnation{}) standing = "";
      if (party.phase == Phase::Active && owns(record, party.self)) standing = " OWNS";
      line += fmt::format(" | ball {}: {}{}", ball, nameOf(record.version), standing);
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace wells
