// What one frame shows: plain data, copied by the simulation thread for the graphics thread. No
// reference into the world, so that both threads run on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "math/vector.h"
#include "state/arena.h"

namespace wells {

struct ViewWell {
  Vec3 position = Vec3::Zero();  // m
  double strength = 0;           // m^3/s^2; > 0 attracts, < 0 repels, 0 is off
  double softening = 2;          // m, > 0
  std::int32_t peer = 0;         // whose well it is; 0: nobody's
};

/// A line of the legend that has a swatch of the peer's colour before it.
struct LegendRow {
  std::int32_t peer = 0;
  std::string text;  // UTF-8
};

struct View {
  Arena arena;
  std::vector<Vec3> position;       // m, of the balls' centres
  std::vector<double> radius;       // m, one a ball, or a single one that all share
  std::vector<std::int32_t> owner;  // peer id, one a ball; empty or 0: nobody
  std::vector<ViewWell> wells;
  std::vector<std::string> title;  // the legend's first lines, UTF-8
  std::vector<LegendRow> legend;   // title and legend both empty: no panel
};

}  // namespace wells
