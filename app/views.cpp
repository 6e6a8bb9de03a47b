#include "views.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace wells {
namespace {

void addRate(std::vector<std::string>& title, std::string_view loop, const LoopRate& rate) {
  if (rate.target > 0)
    title.push_back(fmt::format("{} {:.0f} of {:.0f} Hz", loop, rate.actual, rate.target));
  else if (rate.actual > 0)
    title.push_back(fmt::format("{} {:.0f} Hz", loop, rate.actual));
}

std::vector<std::string> titleOf(const World& world, const ViewNotes& notes) {
  std::vector<std::string> title = {fmt::format("t = {:.2f} s", world.time())};
  addRate(title, "simulation", notes.simulation);
  addRate(title, "network", notes.network);
  addRate(title, "graphics", notes.graphics);
  return title;
}

std::vector<LegendRow> legendOf(const std::vector<std::int32_t>& owners) {
  std::map<std::int32_t, std::size_t> counts;
  for (const std::int32_t owner : owners) ++counts[owner];
  std::vector<LegendRow> rows;
  for (const auto& [peer, count] : counts) {
    const std::string who = peer > 0 ? fmt::format("peer {}", peer) : "nobody";
    rows.push_back({peer, fmt::format("{}: {} {}", who, count, count == 1 ? "ball" : "balls")});
  }
  return rows;
}

std::vector<double> radiiOf(const Balls& balls) {
  const auto& r = balls.radius;
  const bool equal =
      !r.empty() && std::all_of(r.begin(), r.end(), [&](double x) { return x == r[0]; });
  return equal ? std::vector<double>{r[0]} : r;
}

}  // namespace

View makeView(const World& world, std::vector<std::int32_t> owners, const ViewNotes& notes) {
  View view{.arena = world.arena,
            .position = world.balls.position,
            .radius = radiiOf(world.balls),
            .owner = std::move(owners),
            .wells = {},
            .title = titleOf(world, notes),
            .legend = {}};
  for (const WellTrack& track : world.tracks) {
    const Well well = wellAt(track, world.step, world.settings.dt);
    if (well.strength == 0) continue;  // off
    view.wells.push_back({.position = well.position,
                          .strength = well.strength,
                          .softening = well.softening,
                          .peer = value(well.peer)});
  }
  view.legend = legendOf(view.owner);
  return view;
}

Camera makeCamera(const Config& config) {
  const double aspect =
      static_cast<double>(config.screenWidth) / static_cast<double>(config.screenHeight);
  Camera camera = cameraOverArena(config.arena, aspect);
  if (config.cameraEye) camera.eye = *config.cameraEye;
  if (config.cameraTarget) camera.target = *config.cameraTarget;
  if (config.cameraFieldOfView) camera.fieldOfView = *config.cameraFieldOfView;
  return camera;
}

}  // namespace wells
