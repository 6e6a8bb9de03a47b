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

Record accept(const Record& record, [[maybe_unused]] const Incarnation& self) {
  assert(record.version.owner == self);
  return {record.version, Standing::Heard};
}

Record offer(const Record& record, [[maybe_unused]] const Incarnation& self,
             const Incarnation& receiver, std::int64_t step) {
  assert(owns(record, self));
  Record next{record.version, Standing::Named};
  ++next.version.epoch;
  next.version.owner = receiver;
  next.version.step = step;
  return next;
}

Record decline(const Record& record, const Incarnation& self, const Incarnation& giver,
               std::int64_t step) {
  return offer(accept(record, self), self, giver, step);
}

Record adopt(const Record& record, const Incarnation& self, std::int64_t step) {
  return {{.generation = record.version.generation,
           .term = record.version.term + 1,
           .adopter = self,
           .owner = self,
           .step = step},
          Standing::Heard};
}

Record publish(const Record& record, std::int64_t step) {
  assert(record.standing == Standing::Heard && step >= record.version.step);
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
