#include "bench_row.h"

#include <fmt/format.h>

#include <fstream>

#include "build_info.h"

namespace wells {

std::string buildColumns() {
  return fmt::format("{},{},{},{}", build_info::kCommit, csvField(build_info::kCompiler),
                     csvField(build_info::kFlags), csvField(processor()));
}

std::string processor() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

std::string csvField(std::string_view text) {
  if (text.find_first_of(",\"") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace wells
