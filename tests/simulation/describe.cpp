#include "simulation/describe.h"

#include <fmt/format.h>

namespace wells::simulation {

std::string describe(const Incarnation& who) {
  if (who == Incarnation{}) return "nobody";
  return fmt::format("{}#{:04x}", value(who.peer), static_cast<std::uint64_t>(who.number) >> 48);
}

std::string describe(const Generation& generation) {
  if (!generation.exists()) return "no generation";
  return fmt::format("generation {}-{:04x}", generation.resets,
                     static_cast<std::uint64_t>(generation.nonce) >> 48);
}

std::string describe(const Version& version) {
  return fmt::format("{}, term {} by {}, epoch {}, owner {}, step {}", describe(version.generation),
                     version.term, describe(version.adopter), version.epoch,
                     describe(version.owner), version.step);
}

std::string describe(const Record& record) {
  return describe(record.version) + (record.standing == Standing::Heard ? ", heard" : ", named");
}

}  // namespace wells::simulation
