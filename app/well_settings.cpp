#include "well_settings.h"

#include <fmt/format.h>

#include "keys.h"
#include "setting_checks.h"

namespace wells {
namespace {

WellMode wellMode(std::string_view value) {
  if (value == "attract") return WellMode::Attract;
  if (value == "repel") return WellMode::Repel;
  return WellMode::Off;
}

}  // namespace

void WellSettings::apply(const SharedSettings& shared, PeerId self, std::int64_t step,
                         WellMotion& motion) {
  if (shared.registers().empty() && self_ == kNobody) return;
  Config config = config_;
  WellMode mode = WellMode::AsConfigured;
  std::array<Stamp, 4> stamps{};
  std::size_t i = 0;
  for (const std::string_view name :
       {setting::kWellPosition, setting::kWellStrength, setting::kWellPath, setting::kWell}) {
    const Register* set = shared.inForce(fmt::format("{}.{}", value(self), name), step);
    Stamp& stamp = stamps.at(i++);
    if (!set) continue;
    stamp = {set->version, set->setter};
    if (name == setting::kWell) {
      mode = wellMode(set->value);
    } else {
      findKey(name)->set(config, set->value, {});
    }
  }
  if (stamps == stamps_ && self == self_) return;
  stamps_ = stamps;
  self_ = self;
  motion.follow(config, mode);
}

}  // namespace wells
