#include "simulation/contacts.h"

#include <algorithm>

#include "network/message_fields.h"

namespace wells::simulation {

Contacts::Heard* Contacts::find(const Incarnation& who) {
  const auto place = std::ranges::find(heard_, who, &Heard::who);
  return place == heard_.end() ? nullptr : &*place;
}

const Contacts::Heard* Contacts::find(const Incarnation& who) const {
  return const_cast<Contacts*>(this)->find(who);
}

void Contacts::hear(const gravity_wells::heartbeat_t& heartbeat, const Generation& generation,
                    double now) {
  const auto& header = heartbeat.header;
  const Incarnation who{PeerId{header.peer_id}, header.incarnation};
  Heard* heard = find(who);
  if (!heard) heard = &heard_.emplace_back(Heard{.who = who});
  // One that a later one overtook tells an old phase.
  if (header.sequence <= heard->newestHeartbeat) return hear(header, generation, now);
  heard->newestHeartbeat = header.sequence;
  heard->generation = generationOf(header);
  heard->phase = static_cast<Phase>(heartbeat.phase);
  hear(header, generation, now);
}

void Contacts::hear(const gravity_wells::peer_header_t& header, const Generation& generation,
                    double now) {
  Heard* heard = find({PeerId{header.peer_id}, header.incarnation});
  if (!heard || !heard->sequences.accept(header.sequence)) return;
  // What was lost once and is played back later is news, but no sign of life.
  const bool isLatest = header.sequence > heard->newest;
  heard->newest = std::max(heard->newest, header.sequence);
  if (!generation.exists() || generationOf(header) != generation) return;
  // Its states count even before the first heartbeat that tells of the generation.
  const bool isKnown = heard->generation == generation;
  const bool hasSay = heard->phase == Phase::Syncing || heard->phase == Phase::Active;
  if (isKnown && !hasSay) return;
  heard->asMember = now;
  if (!isKnown || !isLatest) return;
  if (now - heard->renewed > kSteadyGap * lease_) heard->steadySince = now;
  if (now - heard->renewed > kCloseGap * lease_) heard->closeSince = now;
  heard->renewed = now;
}

bool Contacts::isSteady(const Incarnation& who, double span, double now) const {
  const Heard* heard = find(who);
  return heard && now - heard->renewed <= kSteadyGap * lease_ && now - heard->steadySince >= span;
}

bool Contacts::isClose(const Incarnation& who, double span, double now) const {
  const Heard* heard = find(who);
  return heard && now - heard->renewed <= kCloseGap * lease_ && now - heard->closeSince >= span;
}

bool Contacts::hearsOnly(const std::vector<Incarnation>& known, double span, double now) const {
  return std::ranges::all_of(heard_, [&](const Heard& heard) {
    return now - heard.asMember > span || std::ranges::count(known, heard.who) > 0;
  });
}

}  // namespace wells::simulation
