#include "ownership/records.h"

#include <cassert>

namespace wells {

Record found(const Generation& generation, const Incarnation& founder, std::int64_t step) {
  return {{.generation = generation, .owner = founder, .step = step}, Standing::Heard};
}

Record unknown(const Generation& generation) {
  return {{.generation = generation, .step = -1}, Standing::Named};
}

std::optional<Record> learnState(const Record& record, const Version& version) {
  const bool firstHeard = version == record.version && record.standing == Standing::Named;
  if (version <= record.version && !firstHeard) return std::nullopt;
  return Record{version, Standing::Heard};
}

std::optional<Record> learnOffer(const Record& record, const Version& version) {
  if (version <= record.version) return std::nullopt;
  return Record{version, Standing::Named};
}

bool mayTake(const Record& record, const Party& party) {
  return party.phase == Phase::Active && record.version.owner == party.self &&
         record.standing == Standing::Named;
}

Record take(const Record& record, [[maybe_unused]] const Party& party) {
  assert(mayTake(record, party));
  return {record.version, Standing::Heard};
}

bool mayOffer(const Record& record, const Party& party, const Party& receiver) {
  return party.phase == Phase::Active && owns(record, party.self) &&
         receiver.phase == Phase::Active && receiver.self.peer != party.self.peer;
}

Record offer(const Record& record, [[maybe_unused]] const Party& party, const Party& receiver,
             std::int64_t step) {
  assert(mayOffer(record, party, receiver));
  Record next{record.version, Standing::Named};
  ++next.version.epoch;
  next.version.owner = receiver.self;
  next.version.step = step;
  return next;
}

bool mayAdopt(const Record& record, const Party& party, Life owner) {
  return party.phase == Phase::Active && record.version.owner != party.self && owner == Life::Ended;
}

Record adopt(const Record& record, const Party& party, std::int64_t step) {
  return {{.generation = record.version.generation,
           .term = record.version.term + 1,
           .adopter = party.self,
           .owner = party.self,
           .step = step},
          Standing::Heard};
}

bool mayPublish(const Record& record, const Party& party) {
  return party.phase == Phase::Active && owns(record, party.self);
}

Record publish(const Record& record, [[maybe_unused]] const Party& party, std::int64_t step) {
  assert(mayPublish(record, party) && step >= record.version.step);
  Record next = record;
  next.version.step = step;
  return next;
}

bool isPossible(const Version& version) {
  if (version.term < 0 || version.epoch < 0 || version.owner.number == 0) return false;
  const bool adopted = version.adopter.peer != kNobody && version.adopter.number != 0;
  const bool firstTerm = version.adopter == Incarnation{};
  if (version.term == 0) return firstTerm;
  return adopted && (version.epoch > 0 || version.owner == version.adopter);
}

bool contradicts(const Record& record, const Version& version) {
  const bool known = record.version.owner != Incarnation{};
  return known && sameTenure(record.version, version) && record.version.owner != version.owner;
}

}  // namespace wells
