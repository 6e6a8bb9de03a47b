// Each planted defect breaks a promise: at the seed that caught.txt knows, or, when that has become
// another one since, at one of the first.
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <fstream>

#include "planted/catching.h"
#include "planted/defects.h"

namespace wells::planted {
namespace {

constexpr std::uint64_t kFirstSeeds = 300;

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(' ');
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// The column "seeds" of the defect's row in caught.txt; nothing when there is no number.
std::optional<std::uint64_t> knownSeed(std::string_view defect) {
  std::ifstream table(WELLS_CAUGHT_TABLE);
  for (std::string line; std::getline(table, line);) {
    std::istringstream fields(line);
    std::string name, file, seeds;
    std::getline(fields, name, '|');
    std::getline(fields, file, '|');
    std::getline(fields, seeds, '|');
    if (trimmed(name) != defect) continue;
    seeds = trimmed(seeds);
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(seeds.data(), seeds.data() + seeds.size(), seed);
    if (error == std::errc{}) return seed;
  }
  return std::nullopt;
}

/// A seed that breaks a promise with the defect, and none without it.
bool isCaughtAt(const Defect& defect, std::uint64_t seed) {
  return simulate(defect, seed, Planting::On) && !simulate(defect, seed, Planting::Off);
}

class Planted : public testing::TestWithParam<Defect> {};

TEST_P(Planted, IsCaught) {
  const Defect& defect = GetParam();
  if (defect.file.starts_with("ownership/") && search(defect).caught) return;
  const auto seed = knownSeed(defect.name);
  if (seed && isCaughtAt(defect, *seed)) return;
  for (std::uint64_t other = 1; other <= kFirstSeeds; ++other)
    if (isCaughtAt(defect, other)) return;
  FAIL() << defect.what << "\nThis broke no promise in " << kFirstSeeds
         << " seeds. Run gravity-wells-planted and look at what survives.";
}

std::string nameOf(const testing::TestParamInfo<Defect>& info) {
  std::string name(info.param.name);
  std::erase_if(name, [](char c) { return c == '\''; });
  std::ranges::replace_if(
      name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Defects, Planted, testing::ValuesIn(defects().begin(), defects().end()),
                         nameOf);

TEST(PlantedNone, BreaksNoPromise) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const auto caught = simulate({}, seed, Planting::On);
    EXPECT_FALSE(caught) << "seed " << seed << ": " << caught->what;
  }
  EXPECT_FALSE(search({}).caught);
}

}  // namespace
}  // namespace wells::planted
