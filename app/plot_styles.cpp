#include "plot_styles.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "accuracy_run.h"

namespace wells {
namespace {

/// gnuplot's numbers of markers.
struct Look {
  std::string_view name;  // of the integrator, or of the engine where it has no choice
  std::string_view colour;
  int filled;
  int open;
};

constexpr Look kIntegrators[] = {{"symplectic-euler", "#E69F00", 5, 4},
                                 {"leapfrog", "#56B4E9", 9, 8},
                                 {"heun", "#009E73", 11, 10},
                                 {"rk4", "#CC79A7", 13, 12},
                                 {"pefrl", "#0072B2", 7, 6}};
constexpr Look kEngines[] = {
    {"reference-euler", "#444444", 1, 1}, {"reference-improved-euler", "#777777", 2, 2},
    {"reference-rk", "#999999", 3, 3},    {"reference-heun", "#555555", 8, 8},
    {"reference-rk4", "#888888", 12, 12}, {"bullet", "#D55E00", 15, 15}};
constexpr Look kOther = {"", "#000000", 6, 6};

template <std::size_t n>
Look find(const Look (&looks)[n], std::string_view name) {
  const auto look = std::find_if(std::begin(looks), std::end(looks),
                                 [&](const Look& each) { return each.name == name; });
  return look == std::end(looks) ? kOther : *look;
}

}  // namespace

std::string plotStyle(const Method& method, double scale) {
  const bool isOurs = method.engine == "ours";
  const Look look = isOurs ? find(kIntegrators, method.integrator) : find(kEngines, method.engine);
  const auto words = [&](std::string_view alpha, double width, int dash, int marker, double size) {
    return fmt::format("lc rgb '#{}{}' lw {:.2g} dt {} pt {} ps {:.2g}", alpha,
                       look.colour.substr(1), width * scale, dash, marker, size * scale);
  };
  if (method == defaultMethod()) return words("90", 14, 1, look.filled, 3);
  if (isOurs && method.contacts == "exact") return words("", 2, 1, look.filled, 1.3);
  if (isOurs) return words("", 1.5, 2, look.open, 1.3);
  if (method.engine == "bullet") return words("", 3, 1, look.filled, 1.6);
  return words("", 2, 4, look.open, 1.3);
}

}  // namespace wells
