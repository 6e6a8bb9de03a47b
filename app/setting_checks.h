// Which values the application takes for the shared settings that it obeys itself: how often peers
// send, and each peer's well. Those of the session as a whole are in network/shared_settings.h.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "math/ids.h"

namespace wells {

/// Keys of the application; a well's stand behind the number of its peer: "2.WellStrength".
namespace setting {
inline constexpr std::string_view kNetworkRate = "NetworkRate";    // Hz, as the config key
inline constexpr std::string_view kWell = "Well";                  // attract, repel or off
inline constexpr std::string_view kWellPosition = "WellPosition";  // m, as the config key
inline constexpr std::string_view kWellStrength = "WellStrength";  // m^3/s^2, as the config key
inline constexpr std::string_view kWellPath = "WellPath";  // as the config key, but for files
}  // namespace setting

/// A key of a peer's well.
struct WellSetting {
  PeerId peer = kNobody;
  std::string_view name;  // part of the key that it was read from; one of the four above
};

/// "2.WellStrength" as its parts; nothing for other keys and for a peer outside 1 .. 255.
std::optional<WellSetting> wellSetting(std::string_view key);

/// What a WellPath may be: as in a config, but for files, which would be on another machine.
std::string allowedWellPath();

/// A SettingCheck (network/shared_settings.h) of the keys above. Others are wrong.
std::optional<std::string> checkPeerSetting(std::string_view key, std::string_view value);

}  // namespace wells
