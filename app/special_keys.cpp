#include "special_keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "flight/integrators.h"
#include "key_kinds.h"

namespace wells {

namespace {

namespace fs = std::filesystem;

std::string nonEmptyName(std::string_view value) {
  if (trimmed(value).empty()) throw BadValue("the value is missing");
  return std::string(trimmed(value));
}

Well parseWell(std::string_view text) {
  constexpr std::string_view kParts[] = {"x", "y", "z", "strength", "softening"};
  const auto n = parseNumbers(text, kParts);
  Well well{.position = {n[0], n[1], n[2]}, .strength = n[3], .softening = n[4]};
  requireCoordinates(well.position);
  if (!kStrength.contains(well.strength)) throw BadValue("strength out of range");
  if (!kSoftening.contains(well.softening)) throw BadValue("softening out of range");
  return well;
}

WellPath parseWellPath(std::string_view text, const fs::path& base) {
  const auto parts = splitAtCommas(text);
  if (parts.front() == "still" && parts.size() == 1) return {};
  if (parts.front() != "circle")
    return {.kind = WellPath::Kind::Keyframes, .file = base / nonEmptyName(text)};
  constexpr std::string_view kParts[] = {"radius", "period"};
  const auto comma = text.find(',');
  const auto rest = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  const auto n = parseNumbers(rest, kParts);
  if (!Range::between(0, kLargestLength).contains(n[0])) throw BadValue("radius out of range");
  if (n[1] == 0 || std::abs(n[1]) < 0.1 || std::abs(n[1]) > 1e9)
    throw BadValue("period out of range");
  return {.kind = WellPath::Kind::Circle, .radius = n[0], .period = n[1]};
}

std::vector<std::string> integratorNames() {
  std::vector<std::string> names;
  for (const Integrator& integrator : integrators()) names.emplace_back(integrator.name);
  return names;
}

/// One of `names`, of which `parse` makes a value; `what` they are, for messages.
template <class Enum>
Key choiceKey(std::string keyName, std::span<const std::string_view> names, Enum Settings::*field,
              std::optional<Enum> (*parse)(std::string_view), std::string what, std::string help) {
  return {
      .name = std::move(keyName),
      .allowed = fmt::format("{}", fmt::join(names, ", ")),
      .help = std::move(help),
      .set =
          [field, parse, what = std::move(what)](Config& c, std::string_view v, const fs::path&) {
            const auto value = parse(trimmed(v));
            if (!value) throw BadValue("no such " + what);
            c.settings.*field = *value;
          },
      .get = [field](const Config& c) -> std::vector<std::string> {
        return {std::string(name(c.settings.*field))};
      }};
}

}  // namespace

void requireCoordinates(const Vec3& v) {
  for (const double x : {v.x(), v.y(), v.z()})
    if (!kCoordinate.contains(x)) throw BadValue("out of range");
}

Key arenaCenterKey() {
  return {.name = "ArenaCenter",
          .unit = "m",
          .allowed = vectorAllowed(),
          .help =
              "x,y,z of the centre of ground and wall. Moves the whole arena, with the balls and "
              "wells that stand nowhere by their own coordinates",
          .set =
              [](Config& c, std::string_view v, const fs::path&) {
                const Vec3 center = parseVector(v);
                requireCoordinates(center);
                c.arena.center = center;
              },
          .get = [](const Config& c) { return std::vector{formatVector(c.arena.center)}; }};
}

Key ballsFileKey() {
  Key key = {.name = "BallsFile",
             .allowed =
                 "the name of a CSV file with the header "
                 "id,x,y,z,vx,vy,vz,wx,wy,wz,radius,mass",
             .help =
                 "the balls at the start, as --state-out writes them; replaces NumOfBalls, "
                 "BallRadius (but for the wells' height), BallMass and Seed",
             .set = [](Config& c, std::string_view v,
                       const fs::path& base) { c.ballsFile = base / nonEmptyName(v); },
             .get = [](const Config& c) -> std::vector<std::string> {
               if (c.ballsFile.empty()) return {};
               return {c.ballsFile.string()};
             }};
  key.absent = "balls spread by Seed";
  return key;
}

Key wellKey() {
  return {.name = "Well",
          .unit = "m, m^3/s^2, m",
          .allowed = fmt::format("x,y,z,strength,softening: five numbers; strength {} (m^3/s^2), "
                                 "softening {} (m)",
                                 kStrength.text(), kSoftening.text()),
          .help =
              "a fixed well; strength > 0 attracts, < 0 repels. May be repeated. Wells on the "
              "command line replace the file's",
          .repeat = Key::Repeat::Yes,
          .set = [](Config& c, std::string_view v,
                    const fs::path&) { c.wells.push_back(parseWell(v)); },
          .get =
              [](const Config& c) {
                std::vector<std::string> lines;
                for (const Well& w : c.wells)
                  lines.push_back(
                      fmt::format("{},{},{}", formatVector(w.position), w.strength, w.softening));
                return lines;
              },
          .clear = [](Config& c) { c.wells.clear(); }};
}

Key wellPathKey() {
  return {.name = "WellPath",
          .unit = "m, s",
          .allowed =
              "still, or circle,R,period with R 0 to 1e6 (m) and a period of 0.1 to 1e9 s "
              "(negative: the other way round), or the name of a CSV file with the header "
              "t,x,y,z,strength",
          .help =
              "how this peer's well moves. circle,R,period: round the arena's axis, starting in "
              "the direction in which the well stands, from +x towards +z; a file: linear "
              "between keyframes in world coordinates, t in simulated s",
          .set = [](Config& c, std::string_view v,
                    const fs::path& base) { c.wellPath = parseWellPath(trimmed(v), base); },
          .get = [](const Config& c) -> std::vector<std::string> {
            const WellPath& path = c.wellPath;
            if (path.kind == WellPath::Kind::Circle)
              return {fmt::format("circle,{},{}", path.radius, path.period)};
            if (path.kind == WellPath::Kind::Keyframes) return {path.file.string()};
            return {"still"};
          }};
}

Key integratorKey() {
  return {.name = "Integrator",
          .allowed = joined(integratorNames(), ", "),
          .help = "how balls fly",
          .set =
              [](Config& c, std::string_view v, const fs::path&) {
                const auto names = integratorNames();
                const std::string name(trimmed(v));
                if (std::find(names.begin(), names.end(), name) == names.end())
                  throw BadValue("no such integrator");
                c.settings.integrator = name;
              },
          .get = [](const Config& c) { return std::vector{c.settings.integrator}; }};
}

Key contactMethodKey() {
  return choiceKey(
      "ContactMethod", kContactMethodNames, &Settings::contactMethod, contactMethod,
      "contact method",
      "exact: impacts at their own times within the step, single balls roll and slide on ground or "
      "wall, other lasting contacts by substeps; substep: all contacts by substeps; auto: exact, "
      "but crowds by substeps");
}

Key broadphaseKey() {
  return choiceKey(
      "Broadphase", kBroadphaseNames, &Settings::broadphase, broadphaseKind, "broadphase",
      "how balls that may touch are found: tree: Bullet's btDbvtBroadphase; grid: cells as large "
      "as a ball and its way; auto: grid where radii are about the same, else tree. Changes no "
      "result");
}

Key hostIpKey() {
  return {.name = "HostIP",
          .allowed = "any text",
          .help = "accepted, not used: there is no host",
          .set = [](Config& c, std::string_view v, const fs::path&) { c.hostIp = trimmed(v); },
          .get = [](const Config& c) -> std::vector<std::string> {
            if (c.hostIp.empty()) return {};
            return {c.hostIp};
          }};
}

}  // namespace wells
