#include "cores.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "values.h"

namespace wells {
namespace {

constexpr int kLastCore = 1023;  // that the system can name

int parseCore(std::string_view text) {
  return static_cast<int>(parseInteger(text, 0, kLastCore));
}

CoreChoice parseChoice(std::string_view text) {
  if (text == "auto") return {};
  if (text == "any") return {.kind = CoreChoice::Kind::Any};
  return {.kind = CoreChoice::Kind::Listed, .listed = parseCores(text)};
}

std::string formatChoice(const CoreChoice& choice) {
  if (choice.kind == CoreChoice::Kind::Auto) return "auto";
  if (choice.kind == CoreChoice::Kind::Any) return "any";
  return formatCores(choice.listed);
}

}  // namespace

std::vector<int> parseCores(std::string_view text) {
  std::vector<int> cores;
  for (const std::string_view part : splitAtCommas(text)) {
    const auto dash = part.find('-');
    const int first = parseCore(part.substr(0, dash));
    const int last = dash == std::string_view::npos ? first : parseCore(part.substr(dash + 1));
    if (last < first) throw BadValue(fmt::format("{}-{} runs backwards", first, last));
    cores.resize(cores.size() + static_cast<std::size_t>(last - first + 1));
    std::iota(cores.end() - (last - first + 1), cores.end(), first);
  }
  std::sort(cores.begin(), cores.end());
  cores.erase(std::unique(cores.begin(), cores.end()), cores.end());
  return cores;
}

std::string formatCores(std::span<const int> cores) {
  std::string text;
  for (std::size_t i = 0; i < cores.size();) {
    std::size_t end = i + 1;
    while (end < cores.size() && cores[end] == cores[end - 1] + 1) ++end;
    text += fmt::format("{}{}", text.empty() ? "" : ",", cores[i]);
    if (end - i > 1) text += fmt::format("-{}", cores[end - 1]);
    i = end;
  }
  return text;
}

Key coresKey(std::string name, CoreChoice Config::*choice, std::string help) {
  return {.name = std::move(name),
          .allowed = "auto, any, or a list of core numbers such as 0,2-5",
          .help = std::move(help),
          .set = [choice](Config& c, std::string_view v,
                          const std::filesystem::path&) { c.*choice = parseChoice(trimmed(v)); },
          .get = [choice](const Config& c) { return std::vector{formatChoice(c.*choice)}; }};
}

}  // namespace wells
