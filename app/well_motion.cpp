#include "well_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "csv.h"
#include "errors.h"
#include "math/elementary.h"
#include "scenes/own_well.h"
#include "special_keys.h"

namespace wells {
namespace {

// `start`, turned round the vertical through `center` from +x towards +z, at another radius. A
// start on the axis counts as being in direction +x.
Vec3 onCircle(const Vec3& center, const Vec3& start, double radius, double turns) {
  const Vec3 away{start.x() - center.x(), 0, start.z() - center.z()};
  const Vec3 u = length(away) > 0 ? Vec3(away / length(away)) : Vec3{1, 0, 0};
  const SinCos a = sinCosOfTurns(turns);
  return {center.x() + radius * (u.x() * a.cos - u.z() * a.sin), start.y(),
          center.z() + radius * (u.x() * a.sin + u.z() * a.cos)};
}

}  // namespace

WellMotion::WellMotion(const Config& config, double dt) : config_(config), dt_(dt) {
  if (config.wellPath.kind == WellPath::Kind::Keyframes) readKeyframes(config.wellPath.file);
}

void WellMotion::readKeyframes(const std::filesystem::path& file) {
  const CsvTable table(file, "t,x,y,z,strength");
  if (table.rows() == 0)
    throw UsageError(fmt::format("{}: no keyframe; allowed: at least one line", file.string()));
  const Range place = Range::between(-1e6, 1e6);
  auto& keys = fromFile_.keyframes;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double t = table.number(row, "t", Range::between(0, 1e9));
    const std::int64_t step = std::llround(t / dt_);
    if (!keys.empty() && step <= keys.back().step)
      table.refuse(row, "t", "not later than the line before",
                   fmt::format("times that rise by at least Dt = {} s", dt_));
    keys.push_back({.step = step,
                    .position = {table.number(row, "x", place), table.number(row, "y", place),
                                 table.number(row, "z", place)},
                    .strength = table.number(row, "strength", kStrength)});
  }
}

Vec3 WellMotion::place(PeerId peer) const {
  return config_.wellPosition.value_or(
      defaultWellPosition(config_.arena, config_.ballRadius, peer));
}

void WellMotion::follow(const Config& config, WellMode mode) {
  config_ = config;
  mode_ = mode;
}

WellKeyframe WellMotion::at(PeerId peer, std::int64_t step) const {
  WellKeyframe key = configuredAt(peer, step);
  if (mode_ == WellMode::Attract) key.strength = std::abs(key.strength);
  if (mode_ == WellMode::Repel) key.strength = -std::abs(key.strength);
  if (mode_ == WellMode::Off) key.strength = 0;
  return key;
}

WellKeyframe WellMotion::configuredAt(PeerId peer, std::int64_t step) const {
  const WellPath& path = config_.wellPath;
  if (path.kind == WellPath::Kind::Keyframes) {
    const Well well = wellAt(fromFile_, step, dt_);
    return {.step = step, .position = well.position, .strength = well.strength};
  }
  const double strength =
      config_.wellStrength.value_or(defaultWellStrength(config_.arena, config_.wellSoftening));
  if (path.kind == WellPath::Kind::Still)
    return {.step = step, .position = place(peer), .strength = strength};
  const double turns = static_cast<double>(step) * dt_ / path.period;
  return {.step = step,
          .position = onCircle(config_.arena.center, place(peer), path.radius, turns),
          .strength = strength};
}

WellTrack WellMotion::trackAt(PeerId peer, std::int64_t step) const {
  WellTrack track{.keyframes = {at(peer, step)}, .softening = softening(), .peer = peer};
  extend(track, step);
  return track;
}

void WellMotion::extend(WellTrack& track, std::int64_t step) const {
  const std::int64_t interval = std::max<std::int64_t>(1, std::llround(kInterval / dt_));
  auto& keys = track.keyframes;
  if (config_.wellPath.kind == WellPath::Kind::Still) return;
  while (keys.back().step <= step) keys.push_back(at(track.peer, keys.back().step + interval));
  const auto current = std::find_if(keys.rbegin(), keys.rend(),
                                    [&](const WellKeyframe& key) { return key.step <= step; });
  if (current != keys.rend()) keys.erase(keys.begin(), current.base() - 1);
}

}  // namespace wells
