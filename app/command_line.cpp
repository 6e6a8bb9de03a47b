#include "command_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <vector>

#include "errors.h"
#include "values.h"

namespace wells {
namespace {

std::vector<std::string> optionNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

[[noreturn]] void refuseUnknown(const CLI::App& app, const std::string& argument) {
  const std::string name = argument.substr(0, argument.find('='));
  const std::string nearest = nearestWord(name, optionNames(app));
  throw UsageError(fmt::format("{}: no such option{}; allowed: those of \"{} --help\"", argument,
                               nearest.empty() ? "" : "; did you mean " + nearest + "?",
                               app.get_name()));
}

}  // namespace

Parsed parseArguments(CLI::App& app, std::span<const std::string> arguments) {
  app.allow_extras();
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // as CLI11 wants it
  try {
    app.parse(reversed);
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help() << std::flush;
    return Parsed::HelpShown;
  } catch (const CLI::ParseError& error) {
    throw UsageError(fmt::format("{}; allowed: see \"{} --help\"", error.what(), app.get_name()));
  }
  const auto unknown = app.remaining();
  if (!unknown.empty()) refuseUnknown(app, unknown.front());
  return Parsed::Options;
}

void parseOption(std::string_view name, std::string_view value, std::string_view allowed,
                 const std::function<void()>& parse) {
  try {
    parse();
  } catch (const BadValue& bad) {
    throw UsageError(fmt::format("{} {}: {}; allowed: {}", name, value, bad.what(), allowed));
  }
}

}  // namespace wells
