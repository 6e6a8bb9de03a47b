#include "ladder_json.h"

#include <fmt/format.h>

#include <bit>
#include <nlohmann/json.hpp>

#include "errors.h"

namespace wells {
namespace {

using Json = nlohmann::json;

// JSON knows neither infinity nor NaN, so numbers travel as their bits.
std::uint64_t bits(double number) {
  return std::bit_cast<std::uint64_t>(number);
}

double number(const Json& json) {
  return std::bit_cast<double>(json.get<std::uint64_t>());
}

Json pointAsJson(const WorkPoint& p) {
  return {bits(p.dt), p.steps,     bits(p.error), bits(p.energyError),
          p.escaped,  bits(p.cpu), p.repeats,     p.stateHash};
}

WorkPoint pointFromJson(const Json& json) {
  WorkPoint point;
  point.dt = number(json.at(0));
  point.steps = json.at(1).get<std::int64_t>();
  point.error = number(json.at(2));
  point.energyError = number(json.at(3));
  point.escaped = json.at(4).get<std::int64_t>();
  point.cpu = number(json.at(5));
  point.repeats = json.at(6).get<std::int64_t>();
  point.stateHash = json.at(7).get<std::uint64_t>();
  return point;
}

}  // namespace

std::string laddersAsJson(std::span<const Ladder> ladders) {
  Json json = Json::array();
  for (const Ladder& ladder : ladders) {
    Json points = Json::array();
    for (const WorkPoint& point : ladder.points) points.push_back(pointAsJson(point));
    json.push_back({{"engine", ladder.method.engine},
                    {"integrator", ladder.method.integrator},
                    {"contacts", ladder.method.contacts},
                    {"points", points},
                    {"notes", ladder.notes}});
  }
  return json.dump();
}

std::vector<Ladder> laddersFromJson(std::string_view text) {
  try {
    std::vector<Ladder> ladders;
    for (const Json& json : Json::parse(text)) {
      Ladder ladder;
      ladder.method = {json.at("engine"), json.at("integrator"), json.at("contacts")};
      for (const Json& point : json.at("points")) ladder.points.push_back(pointFromJson(point));
      ladder.notes = json.at("notes").get<std::vector<std::string>>();
      ladders.push_back(ladder);
    }
    return ladders;
  } catch (const Json::exception& error) {
    throw RunError(fmt::format("the points of another process: {}", error.what()));
  }
}

}  // namespace wells
