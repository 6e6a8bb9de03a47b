#include "own_well.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "csv.h"
#include "math/elementary.h"
#include "scenes/own_well.h"
#include "special_keys.h"

namespace wells {
namespace {

// Round the vertical through `center`, from +x towards +z.
Vec3 onCircle(const Vec3& center, const Vec3& direction, double radius, double turns) {
  const SinCos a = sinCosOfTurns(turns);
  return center + radius * Vec3{direction.x() * a.cos - direction.z() * a.sin, 0,
                                direction.x() * a.sin + direction.z() * a.cos};
}

}  // namespace

OwnWell::OwnWell(const Config& config, PeerId peer, double dt)
    : path_(config.wellPath), peer_(peer), softening_(config.wellSoftening), dt_(dt) {
  const Vec3 place =
      config.wellPosition.value_or(defaultWellPosition(config.arena, config.ballRadius, peer));
  start_ = {.position = place,
            .strength = config.wellStrength.value_or(
                defaultWellStrength(config.arena, config.wellSoftening))};
  if (path_.kind == WellPath::Kind::Keyframes) readKeyframes(path_.file, dt);
  if (path_.kind == WellPath::Kind::Circle) {
    center_ = {config.arena.center.x(), place.y(), config.arena.center.z()};
    const Vec3 away = place - center_;
    direction_ = length(away) > 0 ? Vec3(away / length(away)) : Vec3{1, 0, 0};
    start_.position = onCircle(center_, direction_, path_.radius, 0);
  }
}

void OwnWell::readKeyframes(const std::filesystem::path& file, double dt) {
  const CsvTable table(file, "t,x,y,z,strength");
  const Range place = Range::between(-1e6, 1e6);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double t = table.number(row, "t", Range::between(0, 1e9));
    const WellKeyframe key{
        .step = std::llround(t / dt),
        .position = {table.number(row, "x", place), table.number(row, "y", place),
                     table.number(row, "z", place)},
        .strength = table.number(row, "strength", kStrength)};
    if (!fromFile_.empty() && key.step <= fromFile_.back().step)
      table.refuse(row, "t", "not later than the line before",
                   fmt::format("times that rise by at least Dt = {} s", dt));
    fromFile_.push_back(key);
  }
  if (fromFile_.empty()) return;
  start_ = fromFile_.front();
  start_.step = 0;
  if (fromFile_.front().step == 0) fromFile_.erase(fromFile_.begin());
}

std::vector<WellKeyframe> OwnWell::circleKeyframes(std::int64_t after, std::int64_t last) const {
  const std::int64_t interval = std::max<std::int64_t>(1, std::llround(kCircleInterval / dt_));
  std::vector<WellKeyframe> keys;
  for (std::int64_t step = (after / interval + 1) * interval; step <= last; step += interval) {
    const double turns = static_cast<double>(step) * dt_ / path_.period;
    keys.push_back({.step = step,
                    .position = onCircle(center_, direction_, path_.radius, turns),
                    .strength = start_.strength});
  }
  return keys;
}

std::vector<WellKeyframe> OwnWell::keyframes(std::int64_t after, std::int64_t last) const {
  if (path_.kind == WellPath::Kind::Still) return {};
  if (path_.kind == WellPath::Kind::Circle) return circleKeyframes(after, last);
  std::vector<WellKeyframe> keys;
  for (const WellKeyframe& key : fromFile_)
    if (key.step > after && key.step <= last) keys.push_back(key);
  return keys;
}

WellTrack OwnWell::track(std::int64_t last) const {
  WellTrack track{.keyframes = {start_}, .softening = softening_, .peer = peer_};
  const auto more = keyframes(0, last);
  track.keyframes.insert(track.keyframes.end(), more.begin(), more.end());
  return track;
}

}  // namespace wells
