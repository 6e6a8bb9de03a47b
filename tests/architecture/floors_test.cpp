// The architecture, held by a test: a folder of engine/ includes only folders on lower floors, and
// siblings do not include each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, int> kFloors = {
    {"math", 0},   {"threads", 0},   {"state", 1},    {"forces", 2},   {"broadphase", 2},
    {"scenes", 2}, {"render", 2},    {"flight", 3},   {"contacts", 4}, {"ownership", 2},
    {"world", 5},  {"reference", 5}, {"baseline", 5}, {"network", 6}};

const fs::path kEngine = fs::path(SOURCE_DIR) / "engine";

// By hand: GCC 12 warns, wrongly, inside <regex> when the sanitizers are on.
std::vector<std::string> includesOf(const fs::path& file) {
  const std::string kInclude = "#include\"";
  std::vector<std::string> found;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::erase_if(line, [](unsigned char c) { return std::isspace(c) != 0; });
    if (!line.starts_with(kInclude)) continue;
    const std::string rest = line.substr(kInclude.size());
    found.push_back(rest.substr(0, rest.find('"')));
  }
  return found;
}

std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(kEngine))
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
      files.push_back(entry.path());
  return files;
}

TEST(Floors, EveryFolderHasOne) {
  for (const auto& entry : fs::directory_iterator(kEngine))
    EXPECT_TRUE(!entry.is_directory() || kFloors.contains(entry.path().filename())) << entry.path();
}

TEST(Floors, NoFolderIncludesItsOwnFloorOrAHigherOne) {
  const auto files = sources();
  ASSERT_GT(files.size(), 40u);
  for (const fs::path& file : files) {
    const std::string folder = fs::relative(file, kEngine).begin()->string();
    for (const std::string& include : includesOf(file)) {
      const std::string target = fs::path(include).begin()->string();
      ASSERT_TRUE(kFloors.contains(target))
          << file << " includes \"" << include << "\": allowed are paths from engine/";
      EXPECT_TRUE(target == folder || kFloors.at(target) < kFloors.at(folder))
          << file << " includes \"" << include << "\"";
    }
  }
}

TEST(Floors, FilesAreShort) {
  for (const fs::path& file : sources()) {
    std::ifstream in(file);
    const auto lines = std::count(std::istreambuf_iterator<char>(in), {}, '\n');
    EXPECT_LE(lines, 400) << file;
  }
}

}  // namespace
