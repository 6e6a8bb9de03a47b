#include "scenes/exact_answers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace wells {

std::span<const AccuracyCase> accuracyCases() {
  static const std::vector<AccuracyCase> cases = {
      {"bounce", "five elastic impacts on the ground", 10, {{0, {0, 5.454441153150668, 0}}}},
      {"slide-to-roll",
       "sliding ends when friction has made the ball roll",
       3,
       {{0, {11.06100952103573, 0.5, 0}}}},
      {"billiard",
       "two impacts, the second magnifies the error of the first",
       3,
       {{0, {4.150127283247419, 1, -4.735272667157606}},
        {1, {6.729675992849976, 1, 3.364429504120629}},
        {2, {15.12019672390261, 1, 4.170843163036978}}}},
      {"circle-billiard",
       "277 impacts on the wall",
       1000,
       {{0, {5.633488670861579, 1, -4.135048868340559}}}},
      {"orbit",
       "six revolutions about a softened well",
       20,
       {{0, {3.854288449057601966522, 20, 4.725218728097183202115}}}},
  };
  return cases;
}

const AccuracyCase& findAccuracyCase(std::string_view scene) {
  std::vector<std::string_view> names;
  for (const AccuracyCase& answer : accuracyCases()) {
    if (answer.scene == scene) return answer;
    names.push_back(answer.scene);
  }
  throw std::invalid_argument(
      fmt::format("case '{}' is unknown; allowed: {}", scene, fmt::join(names, ", ")));
}

double positionError(const AccuracyCase& answer, const World& world) {
  double worst = 0;
  for (const auto& [ball, position] : answer.end) {
    const double error = length(world.balls.position.at(ball) - position);
    if (!(error <= std::numeric_limits<double>::max()))
      return std::numeric_limits<double>::infinity();
    worst = std::max(worst, error);
  }
  return worst;
}

}  // namespace wells
