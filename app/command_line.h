// What the subcommands' option parsing has in common: CLI11 with our words for errors.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace wells {

enum class Parsed { Options, HelpShown };

/// Parses `arguments` (without the program's name). Throws UsageError for unknown options (with the
/// nearest one) and missing values; what option callbacks throw passes through.
Parsed parseArguments(CLI::App& app, std::span<const std::string> arguments);

/// Runs `parse` and turns its BadValue into a UsageError "--name value: why; allowed: ...".
void parseOption(std::string_view name, std::string_view value, std::string_view allowed,
                 const std::function<void()>& parse);

}  // namespace wells
