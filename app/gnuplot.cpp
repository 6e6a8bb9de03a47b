#include "gnuplot.h"

#include <fmt/format.h>

#include <vector>

#include "child_process.h"
#include "errors.h"
#include "text_file.h"
#include "values.h"

namespace wells {
namespace {

constexpr double kLongestWait = 120;  // s

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

}  // namespace

void runGnuplot(const std::filesystem::path& folder, const std::string& file) {
  const std::filesystem::path log = folder / ".gnuplot.log";
  ChildProcess gnuplot("gnuplot", {"-e", "cd " + quoted(folder.string()), file}, log);
  const std::optional<int> status = gnuplot.wait(kLongestWait);
  if (!status) throw RunError(fmt::format("gnuplot {}: not done after {} s", file, kLongestWait));
  const std::vector<std::string> said = readLines(log);
  std::filesystem::remove(log);
  if (*status != 0)
    throw RunError(fmt::format("gnuplot {}: ended with status {}; it said:\n{}", file, *status,
                               joined(said, "\n")));
}

}  // namespace wells
