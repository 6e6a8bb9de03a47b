#include "command_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "errors.h"
#include "math/instruction_set.h"
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

void addInteger(CLI::App& app, const std::string& name, std::int64_t& target, std::int64_t low,
                std::int64_t high, const std::string& help) {
  app.add_option_function<std::string>(
         name,
         [&target, name, low, high](const std::string& value) {
           parseOption(name, value, fmt::format("a whole number {} to {}", low, high),
                       [&] { target = parseInteger(value, low, high); });
         },
         help)
      ->type_name("COUNT");
}

void addIntegers(CLI::App& app, const std::string& name, std::vector<std::int64_t>& target,
                 std::int64_t high, const std::string& help) {
  app.add_option_function<std::string>(
         name,
         [&target, name, high](const std::string& text) {
           const std::string allowed =
               fmt::format("whole numbers 1 to {}, with commas between them", high);
           target.clear();
           parseOption(name, text, allowed, [&] {
             for (const std::string_view word : splitAtCommas(text))
               target.push_back(parseInteger(trimmed(word), 1, high));
           });
         },
         help)
      ->type_name("COUNT,...");
}

void addSeconds(CLI::App& app, const std::string& name, double& target, double low, double high,
                const std::string& help) {
  app.add_option_function<std::string>(
         name,
         [&target, name, range = Range::between(low, high)](const std::string& value) {
           parseOption(name, value, fmt::format("a number {}, in s", range.text()),
                       [&] { target = parseNumber(value, range); });
         },
         help)
      ->type_name("s")
      ->default_str(fmt::format("{}", target));
}

void addName(CLI::App& app, const std::string& name, std::string& target, const std::string& help,
             void (*check)(std::string_view)) {
  app.add_option_function<std::string>(
         name,
         [&target, name, check](const std::string& value) {
           try {
             check(value);
           } catch (const std::invalid_argument& error) {
             throw UsageError(fmt::format("{} {}: {}", name, value, error.what()));
           }
           target = value;
         },
         help)
      ->type_name("NAME");
}

CLI::Option* addPath(CLI::App& app, const std::string& name, std::filesystem::path& target,
                     const std::string& type, const std::string& help) {
  return app
      .add_option_function<std::string>(
          name,
          [&target, name](const std::string& value) {
            if (trimmed(value).empty())
              throw UsageError(fmt::format("{} \"\": the value is missing; allowed: a name", name));
            target = value;
          },
          help)
      ->type_name(type);
}

void addInstructions(CLI::App& app, const std::string& group) {
  app.add_option_function<std::string>(
         "--instructions",
         [](const std::string& value) {
           try {
             useInstructionSet(findInstructionSet(value));
           } catch (const std::invalid_argument& error) {
             throw UsageError(fmt::format("--instructions {}: {}", value, error.what()));
           }
         },
         "of the processor, for vector code: baseline, avx2 or avx512; all give the same bits")
      ->type_name("NAME")
      ->default_str("the best that it has")
      ->group(group);
}

void addChoice(CLI::App& app, const std::string& option, std::vector<std::string>& target,
               const std::vector<std::string>& allowed, const std::string& help) {
  target = allowed;
  app.add_option_function<std::string>(
         option,
         [&target, option, allowed](const std::string& value) {
           std::vector<std::string> chosen;
           for (const std::string_view word : splitAtCommas(value)) {
             const std::string name(trimmed(word));
             if (std::find(allowed.begin(), allowed.end(), name) == allowed.end()) {
               const std::string nearest = nearestWord(name, allowed);
               throw UsageError(fmt::format("{} {}: no such name;{} allowed: {}", option, name,
                                            nearest.empty() ? "" : " did you mean " + nearest + "?",
                                            joined(allowed, ", ")));
             }
             if (std::find(chosen.begin(), chosen.end(), name) == chosen.end())
               chosen.push_back(name);
           }
           target = chosen;
         },
         help)
      ->type_name("NAME,...");
}

}  // namespace wells
