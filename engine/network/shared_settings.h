// Settings that all peers of a session share and anybody may change while it runs: whether it is
// paused, its pace, gravity, the contacts' coefficients, and each peer's well. Every setting is a
// register; of two values of one register the one with the greater (version, setter) holds,
// everywhere, in whatever order they come. Knows no network and no clock.
//
// This side knows the keys of the session as a whole. Those of a peer's well, "2.WellStrength", and
// of its loops are for the application: it says which values it takes (SettingCheck).
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "state/settings.h"

namespace wells {

inline constexpr std::size_t kMaxSharedSettings = 64;  // more are refused

/// The keys that a session itself obeys:
///   Pause           true or false
///   SimulationRate  steps per wall second, 10 .. 10000
///   Gravity         on, off or reversed, compared with the world's own
///   Elasticity      0 .. 1
///   Friction        0 .. 100
///   RollingResistance  m, 0 .. 1e6
///   Reset           a count: the world starts over until it has been reset so often
namespace setting {
inline constexpr std::string_view kPause = "Pause";
inline constexpr std::string_view kSimulationRate = "SimulationRate";
inline constexpr std::string_view kGravity = "Gravity";
inline constexpr std::string_view kElasticity = "Elasticity";
inline constexpr std::string_view kFriction = "Friction";
inline constexpr std::string_view kRollingResistance = "RollingResistance";
inline constexpr std::string_view kReset = "Reset";
}  // namespace setting

struct Register {
  std::string value;
  std::int64_t version = 0;   // rises by one with each change, from 1
  std::int64_t setter = 0;    // random number of who set it
  std::string setBy;          // who set it, for people
  std::int64_t fromStep = 0;  // the step from which it holds

  bool operator==(const Register&) const = default;
};

/// What is wrong with a value, for people ("Elasticity is 1.5; it must be 0 to 1"); nothing when it
/// may be set.
using SettingCheck =
    std::function<std::optional<std::string>(std::string_view key, std::string_view value)>;

/// Of the keys above. Unknown keys are wrong, too.
std::optional<std::string> checkSessionSetting(std::string_view key, std::string_view value);

class SharedSettings {
 public:
  using Registers = std::map<std::string, Register, std::less<>>;

  /// Takes a value if it is greater than ours. False when it is not, or when there are too many.
  bool learn(std::string_view key, const Register& value);

  const Registers& registers() const { return registers_; }

  /// The register of `key` once its step has come, and the one that it followed until then; nullptr
  /// when there is none.
  const Register* inForce(std::string_view key, std::int64_t step) const;

  /// The register that `value` becomes when `setter` sets it now.
  Register next(std::string_view key, std::string value, std::int64_t setter, std::string setBy,
                std::int64_t fromStep) const;

  /// Of all keys, versions and setters: equal in peers that know the same. 0: nothing is set.
  std::uint64_t digest() const;

  /// All hold from the first step on: the world starts over.
  void restart();

  void clear();

 private:
  Registers registers_;
  Registers former_;  // which those of registers_ follow when their steps come
};

/// `world`'s own settings as the registers in force at `step` change them.
Settings applied(const SharedSettings& shared, const Settings& world, std::int64_t step);

/// True while the session is paused at `step`.
bool isPaused(const SharedSettings& shared, std::int64_t step);

/// Steps per wall second in force, or `otherwise`.
double stepRate(const SharedSettings& shared, std::int64_t step, double otherwise);

/// How many resets have been asked for.
std::int64_t resetsAsked(const SharedSettings& shared);

}  // namespace wells
