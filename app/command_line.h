// What the subcommands' option parsing has in common: CLI11 with our words for errors.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wells {

enum class Parsed { Options, HelpShown };

/// Parses `arguments` (without the program's name). Throws UsageError for unknown options (with the
/// nearest one) and missing values; what option callbacks throw passes through.
Parsed parseArguments(CLI::App& app, std::span<const std::string> arguments);

/// Runs `parse` and turns its BadValue into a UsageError "--name value: why; allowed: ...".
void parseOption(std::string_view name, std::string_view value, std::string_view allowed,
                 const std::function<void()>& parse);

/// Adds --name COUNT, a whole number low .. high.
void addInteger(CLI::App& app, const std::string& name, std::int64_t& target, std::int64_t low,
                std::int64_t high, const std::string& help);

/// Adds --name COUNT,..., whole numbers 1 .. high; `target` holds its default.
void addIntegers(CLI::App& app, const std::string& name, std::vector<std::int64_t>& target,
                 std::int64_t high, const std::string& help);

/// Adds --name S, a time low .. high, in s; `target` holds its default.
void addSeconds(CLI::App& app, const std::string& name, double& target, double low, double high,
                const std::string& help);

/// Adds --name NAME, where `check` throws std::invalid_argument for a value that is not allowed.
void addName(CLI::App& app, const std::string& name, std::string& target, const std::string& help,
             void (*check)(std::string_view));

/// Adds --name FILE, or FOLDER, as `type` says.
CLI::Option* addPath(CLI::App& app, const std::string& name, std::filesystem::path& target,
                     const std::string& type, const std::string& help);

/// Adds --instructions NAME, which takes effect as it is parsed.
void addInstructions(CLI::App& app, const std::string& group = "Options");

/// Adds --name NAME,...: a choice of `allowed`, each once and all by default.
void addChoice(CLI::App& app, const std::string& name, std::vector<std::string>& target,
               const std::vector<std::string>& allowed, const std::string& help);

}  // namespace wells
