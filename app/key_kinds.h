// Makers of config keys of the common kinds: number, whole number, truth value, point. A `field` is
// a generic lambda from a (const) Config to a (const) reference, so that one accessor serves
// reading and writing.
#pragma once

#include <fmt/format.h>

#include <string>
#include <type_traits>
#include <utility>

#include "keys.h"
#include "values.h"

namespace wells {

inline constexpr double kLargestLength = 1e6;  // m: beyond it squares and cubes lose small parts

inline const Range kCoordinate = Range::between(-kLargestLength, kLargestLength);

/// Throws BadValue unless each component is a kCoordinate.
void requireCoordinates(const Vec3& v);

inline std::string numberAllowed(const Range& range, const std::string& unit) {
  return fmt::format("a number {}{}{}", range.text(), unit.empty() ? "" : ", in ", unit);
}

template <class Field>
Key numberKey(std::string name, std::string unit, Field field, Range range, std::string help) {
  return {.name = std::move(name),
          .unit = unit,
          .allowed = numberAllowed(range, unit),
          .help = std::move(help),
          .set = [=](Config& c, std::string_view v,
                     const std::filesystem::path&) { field(c) = parseNumber(v, range); },
          .get = [=](const Config& c) { return std::vector{formatNumber(field(c))}; }};
}

template <class Field>
Key optionalNumberKey(std::string name, std::string unit, Field field, Range range,
                      std::string help, std::string absent) {
  Key key = {.name = std::move(name),
             .unit = unit,
             .allowed = numberAllowed(range, unit),
             .help = std::move(help),
             .set = [=](Config& c, std::string_view v,
                        const std::filesystem::path&) { field(c) = parseNumber(v, range); },
             .get = [=](const Config& c) -> std::vector<std::string> {
               if (!field(c)) return {};
               return {formatNumber(*field(c))};
             }};
  key.absent = std::move(absent);
  return key;
}

template <class Field>
Key integerKey(std::string name, Field field, std::int64_t low, std::int64_t high,
               std::string help) {
  return {.name = std::move(name),
          .allowed = fmt::format("a whole number {} to {}", low, high),
          .help = std::move(help),
          .set =
              [=](Config& c, std::string_view v, const std::filesystem::path&) {
                using Integer = std::remove_reference_t<decltype(field(c))>;
                field(c) = static_cast<Integer>(parseInteger(v, low, high));
              },
          .get = [=](const Config& c) { return std::vector{fmt::format("{}", field(c))}; }};
}

template <class Field>
Key booleanKey(std::string name, Field field, std::string help) {
  return {
      .name = std::move(name),
      .allowed = "true or false, T or F, 1 or 0",
      .help = std::move(help),
      .set = [=](Config& c, std::string_view v,
                 const std::filesystem::path&) { field(c) = parseBoolean(v); },
      .get =
          [=](const Config& c) { return std::vector<std::string>{field(c) ? "true" : "false"}; }};
}

inline std::string vectorAllowed() {
  return fmt::format("x,y,z: three numbers {}, in m", kCoordinate.text());
}

template <class Field>
Key optionalVectorKey(std::string name, Field field, std::string help, std::string absent) {
  Key key = {.name = std::move(name),
             .unit = "m",
             .allowed = vectorAllowed(),
             .help = std::move(help),
             .set =
                 [=](Config& c, std::string_view v, const std::filesystem::path&) {
                   const Vec3 place = parseVector(v);
                   requireCoordinates(place);
                   field(c) = place;
                 },
             .get = [=](const Config& c) -> std::vector<std::string> {
               if (!field(c)) return {};
               return {formatVector(*field(c))};
             }};
  key.absent = std::move(absent);
  return key;
}

}  // namespace wells
