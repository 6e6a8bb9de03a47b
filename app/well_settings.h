// What the settings of a session say of one peer's well.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "config.h"
#include "network/shared_settings.h"
#include "well_motion.h"

namespace wells {

class WellSettings {
 public:
  explicit WellSettings(const Config& config) : config_(config) {}

  /// Lets `motion` follow what is in force at `step` for the well of `self`, if that has changed.
  void apply(const SharedSettings& shared, PeerId self, std::int64_t step, WellMotion& motion);

 private:
  using Stamp = std::pair<std::int64_t, std::int64_t>;  // version and setter; 0, 0: not set

  Config config_;  // without the settings
  PeerId self_ = kNobody;
  std::array<Stamp, 4> stamps_{};
};

}  // namespace wells
