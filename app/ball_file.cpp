#include "ball_file.h"

#include <fmt/format.h>

#include <iterator>
#include <limits>

#include "csv.h"

namespace wells {
namespace {

constexpr double kHuge = 1e9;  // m, m/s, rad/s: squares and cubes of it are still exact enough

Vec3 vectorOf(const CsvTable& table, std::size_t row, const char* x, const char* y, const char* z) {
  const Range range = Range::between(-kHuge, kHuge);
  return {table.number(row, x, range), table.number(row, y, range), table.number(row, z, range)};
}

}  // namespace

Balls readBalls(const std::filesystem::path& file) {
  const CsvTable table(file, kBallsHeader);
  const std::size_t count = table.rows();
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> rowOf(count, kNone);
  for (std::size_t row = 0; row < count; ++row) {
    const auto last = static_cast<std::int64_t>(count) - 1;
    const auto id = static_cast<std::size_t>(table.integer(row, "id", 0, last));
    if (rowOf[id] != kNone) {
      table.refuse(row, "id", fmt::format("already in line {}", table.line(rowOf[id])),
                   fmt::format("each of 0 to {} once", last));
    }
    rowOf[id] = row;
  }
  Balls balls;
  balls.reserve(count);
  for (const std::size_t row : rowOf) {
    balls.add({.position = vectorOf(table, row, "x", "y", "z"),
               .velocity = vectorOf(table, row, "vx", "vy", "vz"),
               .spin = vectorOf(table, row, "wx", "wy", "wz")},
              table.number(row, "radius", Range::above(0, 1e6)),
              table.number(row, "mass", Range::above(0, 1e12)));
  }
  return balls;
}

std::string ballsAsCsv(const Balls& balls) {
  std::string text(kBallsHeader);
  text += '\n';
  auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    fmt::format_to(out, "{}", i);
    for (const Vec3& v : {balls.position[i], balls.velocity[i], balls.spin[i]})
      fmt::format_to(out, ",{:.17g},{:.17g},{:.17g}", v.x(), v.y(), v.z());
    fmt::format_to(out, ",{:.17g},{:.17g}\n", balls.radius[i], balls.mass[i]);
  }
  return text;
}

}  // namespace wells
