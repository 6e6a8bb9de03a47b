#include "network/shared_settings.h"

#include <charconv>
#include <cmath>
#include <tuple>
#include <utility>

#include "math/hash.h"

namespace wells {
namespace {

constexpr double kMaxRate = 10'000;  // Hz
constexpr double kMinRate = 10;      // Hz; peers speak at each step, and leases are short
constexpr double kMaxFriction = 100;
constexpr double kMaxRollingResistance = 1e6;  // m
constexpr std::int64_t kMaxResets = 1'000'000'000;

template <class T>
std::optional<T> number(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string refusal(std::string_view key, std::string_view value, std::string_view allowed) {
  return std::string(key) + " is " + std::string(value) + "; it must be " + std::string(allowed);
}

struct NumberRange {
  std::string_view key;
  double low;
  double high;
  std::string_view allowed;
};

constexpr NumberRange kNumbers[] = {
    {setting::kSimulationRate, kMinRate, kMaxRate, "10 to 10000 Hz"},
    {setting::kElasticity, 0, 1, "0 to 1"},
    {setting::kFriction, 0, kMaxFriction, "0 to 100"},
    {setting::kRollingResistance, 0, kMaxRollingResistance, "0 to 1e6 m"},
};

std::string_view valueInForce(const SharedSettings& shared, std::string_view key,
                              std::int64_t step) {
  const Register* found = shared.inForce(key, step);
  return found ? std::string_view(found->value) : std::string_view{};
}

}  // namespace

std::optional<std::string> checkSessionSetting(std::string_view key, std::string_view value) {
  for (const NumberRange& range : kNumbers) {
    if (key != range.key) continue;
    const auto given = number<double>(value);
    if (given && *given >= range.low && *given <= range.high) return std::nullopt;
    return refusal(key, value, range.allowed);
  }
  if (key == setting::kPause) {
    if (value == "true" || value == "false") return std::nullopt;
    return refusal(key, value, "true or false");
  }
  if (key == setting::kGravity) {
    if (value == "on" || value == "off" || value == "reversed") return std::nullopt;
    return refusal(key, value, "on, off or reversed");
  }
  if (key == setting::kReset) {
    const auto given = number<std::int64_t>(value);
    if (given && *given >= 1 && *given <= kMaxResets) return std::nullopt;
    return refusal(key, value, "a whole number from 1");
  }
  return std::string(key) + ": no such setting";
}

bool SharedSettings::learn(std::string_view key, const Register& value) {
  const auto known = registers_.find(key);
  if (known == registers_.end()) {
    if (registers_.size() >= kMaxSharedSettings) return false;
    registers_.emplace(key, value);
    return true;
  }
  const auto rank = [](const Register& r) { return std::tie(r.version, r.setter); };
  if (rank(value) <= rank(known->second)) return false;
  former_[known->first] = std::exchange(known->second, value);
  return true;
}

const Register* SharedSettings::inForce(std::string_view key, std::int64_t step) const {
  for (const Registers* registers : {&registers_, &former_}) {
    const auto known = registers->find(key);
    if (known != registers->end() && known->second.fromStep <= step) return &known->second;
  }
  return nullptr;
}

Register SharedSettings::next(std::string_view key, std::string value, std::int64_t setter,
                              std::string setBy, std::int64_t fromStep) const {
  const auto known = registers_.find(key);
  const std::int64_t version = known == registers_.end() ? 0 : known->second.version;
  return {std::move(value), version + 1, setter, std::move(setBy), fromStep};
}

std::uint64_t SharedSettings::digest() const {
  if (registers_.empty()) return 0;
  Hash hash;
  for (const auto& [key, value] : registers_) {
    hash.add(std::string_view(key));
    hash.add(static_cast<std::uint64_t>(value.version));
    hash.add(static_cast<std::uint64_t>(value.setter));
  }
  return hash.value();
}

void SharedSettings::restart() {
  for (auto& [key, value] : registers_) value.fromStep = 0;
  former_.clear();
}

void SharedSettings::clear() {
  registers_.clear();
  former_.clear();
}

Settings applied(const SharedSettings& shared, const Settings& world, std::int64_t step) {
  Settings settings = world;
  const std::string_view gravity = valueInForce(shared, setting::kGravity, step);
  if (gravity == "off") settings.gravity = Vec3::Zero();
  if (gravity == "reversed") settings.gravity = -world.gravity;
  if (const auto e = number<double>(valueInForce(shared, setting::kElasticity, step)))
    settings.elasticity = *e;
  if (const auto mu = number<double>(valueInForce(shared, setting::kFriction, step)))
    settings.friction = *mu;
  if (const auto arm = number<double>(valueInForce(shared, setting::kRollingResistance, step)))
    settings.rollingResistance = *arm;
  return settings;
}

bool isPaused(const SharedSettings& shared, std::int64_t step) {
  if (valueInForce(shared, setting::kPause, step) != "true") return false;
  // A world that stands still comes to no later step: what ends a pause ends it at once.
  return shared.registers().find(setting::kPause)->second.value == "true";
}

double stepRate(const SharedSettings& shared, std::int64_t step, double otherwise) {
  return number<double>(valueInForce(shared, setting::kSimulationRate, step)).value_or(otherwise);
}

std::int64_t resetsAsked(const SharedSettings& shared) {
  const auto known = shared.registers().find(setting::kReset);
  return known == shared.registers().end() ? 0
                                           : number<std::int64_t>(known->second.value).value_or(0);
}

}  // namespace wells
