// From the world to what a frame shows of it.
#pragma once

#include <cstdint>
#include <vector>

#include "config.h"
#include "render/camera.h"
#include "render/view.h"
#include "run_report.h"
#include "state/world.h"

namespace wells {

/// The legend's numbers.
struct ViewNotes {
  LoopRate simulation;
  LoopRate network;
  LoopRate graphics;
};

/// `owners` names each ball's owner by id.
View makeView(const World& world, std::vector<std::int32_t> owners, const ViewNotes& notes);

/// The config's camera; what it leaves open is such that the whole arena is seen.
Camera makeCamera(const Config& config);

}  // namespace wells
