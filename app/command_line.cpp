#include "command_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>
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

// Breaks `text` at blanks into lines of at most `width` characters, each indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::istringstream words(text);
  std::string lines;
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > width - indent) {
      lines += std::string(indent, ' ') + line + '\n';
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? lines : lines + std::string(indent, ' ') + line + '\n';
}

// An option's name on a line of its own, what it means below it: help texts here are long.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool) const override {
    const std::string value = option->get_type_name();
    const std::string standard = option->get_default_str();
    const std::string text = option->get_description() +
                             (standard.empty() ? "" : fmt::format(". Default: {}", standard));
    return fmt::format("  {}{}{}\n{}", option->get_name(false, true), value.empty() ? "" : " ",
                       value, wrapped(text, 6, 100));
  }
};

[[noreturn]] void refuseUnknown(const CLI::App& app, const std::string& argument) {
  const std::string name = argument.substr(0, argument.find('='));
  const std::string nearest = nearestWord(name, optionNames(app));
  throw UsageError(fmt::format("{}: no such option;{} allowed: those of \"{} --help\"", argument,
                               nearest.empty() ? "" : " did you mean " + nearest + "?",
                               app.get_name()));
}

}  // namespace

Parsed parseArguments(CLI::App& app, std::span<const std::string> arguments) {
  app.allow_extras();
  app.formatter(std::make_shared<HelpFormatter>());
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
