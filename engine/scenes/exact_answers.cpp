#include "scenes/exact_answers.h"

#include <algorithm>
#include <limits>

#include "math/find_by_name.h"

namespace wells {

std::string_view unitOf(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::Position:
      return "m";
    case ErrorKind::Energy:
      return "1";
    case ErrorKind::Penetration:
      return "m^2";
    case ErrorKind::Deformation:
      return "m";
    case ErrorKind::EndEnergy:
      return "1";
  }
  return {};
}

std::string_view describe(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::Position:
      return "largest error of a position at the end";
    case ErrorKind::Energy:
      return "relative error of the energy, root mean square";
    case ErrorKind::Penetration:
      return "sum of the squares of all overlaps, mean";
    case ErrorKind::Deformation:
      return "largest change of a height or of a distance of two balls at the end";
    case ErrorKind::EndEnergy:
      return "relative error of the kinetic energy at the end";
  }
  return {};
}

namespace {

std::vector<ExactPosition> columnOfTen() {
  std::vector<ExactPosition> end;
  for (std::uint32_t k = 0; k < 10; ++k) end.push_back({k, {0, 0.5 + k, 0}});
  return end;
}

}  // namespace

std::span<const AccuracyCase> accuracyCases() {
  static const std::vector<AccuracyCase> cases = {
      {"bounce", "five elastic impacts on the ground", 10, {{0, {0, 5.454441153150668, 0}}}},
      {"zeno",
       "five impacts, each at 0.8 of the speed of the last",
       6,
       {{0, {0, 0.978385173086579, 0}}}},
      {"zeno-rest", "infinitely many impacts, then rest", 4, {{0, {0, 0.5, 0}}}},
      {"slide-to-roll",
       "sliding ends when friction has made the ball roll",
       3,
       {{0, {11.06100952103573, 0.5, 0}}}},
      {"backspin", "slides against its spin, rolls on", 3, {{0, {5.263371403607314, 0.5, 0}}}},
      {"backspin-return",
       "slides until its spin takes it back",
       3,
       {{0, {2.239523740179048, 0.5, 0}}}},
      {"rolling-well",
       "rolls to and fro: 5/7 of the well's pull",
       10,
       {{0, {-0.05529601486886331, 0.5, 0}}}},
      {"rolling-stops",
       "slides, rolls, and rests by rolling resistance",
       3,
       {{0, {5.212677231025855, 0.5, 0}}}},
      {"stuck-under-a-well",
       "rolls to and fro until rolling resistance holds it",
       10,
       {{0, {0.1005809587651427, 0.5, 0}}}},
      {"whispering-gallery",
       "held by the wall, which it never hits",
       10,
       {{0, {4.971754630580167, 1, 8.095162499499603}}}},
      {"wall-slide-to-roll",
       "slides along the wall until it rolls",
       5,
       {{0, {-4.370851029136777, 1, -8.434788751420748}}}},
      {"wall-rolling",
       "falls and rises by its spin about the wall's normal, which turns with it",
       10,
       {{0, {-6.335911585696488, 2.211039653220037, -7.078575024553814}}}},
      {"corner-slide-to-roll",
       "rolls on the ground, slides along the wall until it rolls on both",
       10,
       {{0, {-4.735586275310715, 0.5, 8.235546286014594}}}},
      {"corner-rolling",
       "rolls on ground and wall at once, slowed by drag",
       10,
       {{0, {-6.32350977090596, 0.5, 7.089656139563953}}}},
      {"oblique-ground",
       "two impacts with friction: one sticks, one slides",
       2,
       {{0, {6.433331570970116, 4.1, -4}}, {1, {7.050939256966723, 3.480946093925595, 4}}}},
      {"oblique-balls",
       "one impact, whose direction depends on its time",
       2,
       {{0, {3.350127283247419, 1, -2.902242389175270}},
        {1, {9.649872716752581, 1, 3.302242389175270}}}},
      {"friction-balls-stick",
       "an impact with friction: the surfaces stick",
       2,
       {{0, {2.314285714285714, 1, -2.622819794318586}},
        {1, {6.551739689498724, 1, 3.122819794318586}}}},
      {"friction-balls-slip",
       "an impact with friction: the surfaces slip",
       2,
       {{0, {0.8, 3.84, 0}}, {1, {8.2, 8.16, 0}}}},
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
      {"cradle",
       "four impacts within 3 ms",
       1.5,
       {{0, {0.001, 1, 0}},
        {1, {1.002, 1, 0}},
        {2, {2.003, 1, 0}},
        {3, {3.004, 1, 0}},
        {4, {5.2, 1, 0}}}},
      {"galperin",
       "314 impacts, most of them within a few steps",
       4,
       {{0, {9.481610662392738, 1, 0}}, {1, {2.499991669490514, 1, 0}}}},
      {"collapse",
       "infinitely many impacts, then three balls move as one",
       6,
       {{0, {2.833333333333333, 1, 0}},
        {1, {3.833333333333333, 1, 0}},
        {2, {4.833333333333333, 1, 0}}}},
      {"collapse-twin",
       "ten impacts, ever slower",
       10,
       {{0, {4.166652619484130, 1, 0}},
        {1, {5.166673180882147, 1, 0}},
        {2, {6.166674199633723, 1, 0}}}},
      {"pile-stands",
       "friction just holds the four of a pile: nothing in it may move",
       10,
       {},
       ErrorKind::Deformation},
      {"pile-slips",
       "friction is just too small: the top slips down, the others roll out",
       1,
       {{0, {0.6254079540729012, 0.5, 0}},
        {1, {-0.3127039770364506, 0.5, 0.5416191759559833}},
        {2, {-0.3127039770364506, 0.5, -0.5416191759559833}},
        {3, {0, 1.280297950133376, 0}}}},
      {"column", "balls exactly above each other, which the slightest push would topple", 1,
       columnOfTen()},
      {"orbit",
       "six revolutions about a softened well",
       20,
       {{0, {3.854288449057602, 20, 4.725218728097183}}}},
      {"orbit-short",
       "not yet one revolution",
       2,
       {{0, {-2.653257440958655, 20, -5.234073690852200}}}},
      {"circular-orbit",
       "three revolutions at constant speed",
       20,
       {{0, {8.415220018483715, 20, 5.402228432833154}}}},
      {"through-the-centre",
       "18 oscillations where the well is steepest",
       10,
       {{0, {0.002718247695987208, 20, 0}}}},
      {"well-bounces",
       "four impacts on the ground on a path that a well bends",
       6,
       {{0, {-5.637037119862440, 1.771573613259201, 0}}}},
      {"well-bounces-long",
       "eleven impacts on the ground on a path that a well bends",
       16,
       {{0, {0.3865357378588790, 3.593329469780919, 0}}}},
      {"bouncing", "SimBenchmark: energy of 49 bouncing balls", 20, {}, ErrorKind::Energy},
      {"666", "SimBenchmark: overlaps in a heap without friction", 10, {}, ErrorKind::Penetration},
      {"elastic-666",
       "SimBenchmark: energy of a block of balls that bounces apart",
       10,
       {},
       ErrorKind::Energy},
      {"cooling-gas",
       "temperature of a gas after 338 impacts that take energy",
       2,
       {},
       ErrorKind::EndEnergy,
       651.0805376505266},
  };
  return cases;
}

const AccuracyCase& findAccuracyCase(std::string_view scene) {
  return findByName(accuracyCases(), &AccuracyCase::scene, "case", scene);
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
