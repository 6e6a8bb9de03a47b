// README's table of keys is the program's own.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "keys.h"

namespace wells {
namespace {

TEST(Readme, HoldsTheTableOfKeys) {
  std::ifstream in(WELLS_SOURCE_DIR "/README.md");
  ASSERT_TRUE(in) << "README.md is missing";
  std::stringstream text;
  text << in.rdbuf();
  EXPECT_NE(text.str().find(keysAsMarkdown()), std::string::npos)
      << "README.md is out of date: replace its tables of keys by the output of "
         "`gravity-wells keys`";
}

}  // namespace
}  // namespace wells
