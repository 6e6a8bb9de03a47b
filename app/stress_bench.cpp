#include "stress_bench.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <thread>

#include "bench_row.h"
#include "child_process.h"
#include "command_line.h"
#include "engines.h"
#include "errors.h"
#include "progress.h"
#include "stress_row.h"
#include "text_file.h"
#include "values.h"

namespace wells {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// Beyond --limit, for a step that does not end: then the process is killed.
constexpr double kGrace = 5;  // s
const Range kLimits = Range::between(1, 3600);

struct StressOptions {
  std::vector<std::string> cases;
  std::vector<std::string> engines;
  std::string contacts;  // empty: the scenes'
  double limit = 20;     // s of wall time, of a row
  fs::path csv;
  fs::path row;  // not empty: only the row of the one case and engine, to here
  bool list = false;
};

std::optional<StressOptions> parse(std::span<const std::string> arguments) {
  CLI::App app{
      "Runs worlds that break engines, each engine in a process of its own, and says what held.\n"
      "  lost      balls whose centre is outside of the arena, most at once\n"
      "  NaN       balls whose state is no longer finite\n"
      "  gain      by how much kinetic + potential energy was ever above what it had been before;\n"
      "            gain/E: in parts of the energy at hand\n"
      "  overlap   the worst; where balls start overlapped, of the time when they must be apart\n"
      "  exact     share of the balls that ours moved by exact impacts instead of substeps\n"
      "  handed    groups of balls that ours began by exact impacts and left to the substeps\n"
      "Verdicts: \"gained energy\" is more than 1e-6 of what is at hand (single precision rounds "
      "to\n"
      "6e-8), or more than 1e-2 where gravity or wells press balls together for long; it is not\n"
      "judged where wells move. \"infected\": a ball that starts with NaN or infinity changed "
      "others.",
      "./run.sh bench stress"};
  StressOptions options;
  std::vector<std::string> names;
  for (const StressCase& stress : stressCases()) names.emplace_back(stress.name);
  addChoice(app, "--cases", options.cases, names, "default: all; --list explains them");
  addChoice(app, "--engines", options.engines, {engineNames().begin(), engineNames().end()},
            "default: all, " + joined(engineNames(), ", "));
  addName(app, "--contacts", options.contacts,
          fmt::format("contact method of ours: {} (default auto)",
                      fmt::join(kContactMethodNames, ", ")),
          [](std::string_view name) {
            if (!contactMethod(name))
              throw std::invalid_argument(fmt::format("no such contact method; allowed: {}",
                                                      fmt::join(kContactMethodNames, ", ")));
          });
  app.add_option_function<std::string>(
         "--limit",
         [&](const std::string& value) {
           parseOption("--limit", value, fmt::format("a number {}, in s", kLimits.text()),
                       [&] { options.limit = parseNumber(value, kLimits); });
         },
         "wall time of a row; what is not done by then is stopped and says so (default 20)")
      ->type_name("s");
  app.add_option_function<std::string>(
         "--csv", [&](const std::string& value) { options.csv = value; },
         "writes all rows, with more columns, to this file too")
      ->type_name("FILE");
  app.add_flag("--list", options.list, "lists the cases and ends");
  app.add_option_function<std::string>(
         "--row", [&](const std::string& value) { options.row = value; }, "")
      ->group("");  // for processes of our own
  if (parseArguments(app, arguments) == Parsed::HelpShown) return {};
  return options;
}

void listCases() {
  for (const StressCase& stress : stressCases())
    fmt::print("{:18} {:>2} world(s) of {:>3} steps  {}\n", stress.name, stress.versions,
               stress.steps, stress.about);
}

/// One row, in this process.
void runHere(const StressOptions& options) {
  const StressCase& stress = findStressCase(options.cases.front());
  const auto change = [&](World& world) {
    if (const auto method = contactMethod(options.contacts)) world.settings.contactMethod = *method;
  };
  const auto make = [&] { return makeEngine(options.engines.front()); };
  const StressResult result = runStress(stress, make, options.limit, change);

  // The names of the methods are known after a step.
  const auto ran = make();
  World world = stress.make(0).world;
  world.balls = {};
  change(world);
  ran->step(world);
  writeAtomically(options.row, StressRow(stress, *ran, result).text() + '\n');
}

/// A new folder that lives as long as this.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "gravity-wells-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw RunError(
          fmt::format("{}: no folder could be made there", fs::temp_directory_path().string()));
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// One row, in a process of its own: an engine may crash or never come back.
StressRow runElsewhere(const StressOptions& options, const StressCase& stress,
                       const std::string& engine, const fs::path& folder) {
  const fs::path row = folder / "row";
  const fs::path log = folder / "log";
  fs::remove(row);
  std::vector<std::string> arguments = {
      "bench",     "stress",    "--cases", std::string(stress.name),
      "--engines", engine,      "--limit", formatNumber(options.limit),
      "--row",     row.string()};
  if (!options.contacts.empty())
    arguments.insert(arguments.end(), {"--contacts", options.contacts});
  ChildProcess process(arguments, log);
  const auto start = Clock::now();
  std::optional<int> status;
  while (!(status = process.poll())) {
    if (Clock::now() - start > std::chrono::duration<double>(options.limit + kGrace))
      return {stress, engine, "never ended",
              fmt::format("a step was not done after {} s", options.limit + kGrace)};
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  if (*status == 0) return StressRow(readLines(row).at(0));
  const auto said = readLines(log);
  const std::string last = said.empty() ? "" : ": " + said.back();
  if (*status > 128)
    return {stress, engine, "crashed", fmt::format("signal {}{}", *status - 128, last)};
  throw RunError(
      fmt::format("{} on {} ended with status {}{}", engine, stress.name, *status, last));
}

TableWidth tableWidth() {
  winsize size{};
  const bool isKnown = ::isatty(STDOUT_FILENO) != 0 &&
                       ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return isKnown && size.ws_col < kWideTable ? TableWidth::Narrow : TableWidth::Wide;
}

void printCase(const StressCase& stress, TableWidth width) {
  fmt::print("\n{}: {}{}\n{}\n", stress.name, stress.about,
             stress.versions > 1 ? fmt::format(" ({} worlds)", stress.versions) : "",
             tableHeader(width));
}

void printRow(const StressRow& row, TableWidth width) {
  fmt::print("{}\n", tableLine(row, width));
  if (!row.cell("reason").empty()) fmt::print("    {}\n", row.cell("reason"));
  std::fflush(stdout);
}

void runAll(const StressOptions& options) {
  const ScratchFolder folder;
  const StatusLine status;
  const TableWidth width = tableWidth();
  std::string csv = fmt::format("{},{}\n", kStressColumns, kBuildColumns);
  std::map<std::string, std::size_t> held;  // by engine
  const std::size_t rows = options.cases.size() * options.engines.size();
  std::size_t done = 0;
  for (const std::string& name : options.cases) {
    const StressCase& stress = findStressCase(name);
    printCase(stress, width);
    for (const std::string& engine : options.engines) {
      status.show(fmt::format("{}, {}: row {} of {}", name, engine, ++done, rows));
      const StressRow row = runElsewhere(options, stress, engine, folder.path());
      status.show("");
      printRow(row, width);
      if (row.cell("verdict") == "held") ++held[engine];
      csv += fmt::format("{},{}\n", row.csv(), buildColumns());
    }
  }
  fmt::print("\nheld, of {} case(s):\n", options.cases.size());
  for (const std::string& engine : options.engines)
    fmt::print("  {:24} {:>4}\n", engine, held[engine]);
  if (!options.csv.empty()) writeAtomically(options.csv, csv);
}

}  // namespace

int runStressBench(std::span<const std::string> arguments, char** argv) {
  const auto options = parse(arguments);
  if (!options) return 0;
  if (options->list) {
    listCases();
    return 0;
  }
  if (!options->row.empty()) {
    becomeExecutableOf(options->engines.front(), argv);
    runHere(*options);
    return 0;
  }
  if (!options->csv.empty()) requireWritable("--csv", options->csv);
  runAll(*options);
  return 0;
}

}  // namespace wells
