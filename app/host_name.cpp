#include "host_name.h"

#include <fmt/format.h>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <array>

namespace wells {
namespace {

std::string printable(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c <= ' ' || c == 0x7f; }, '?');
  return text;
}

}  // namespace

std::string hostName() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.front() ? printable(name.data()) : "unnamed";
}

std::string userAtHost(std::size_t most) {
  const passwd* user = getpwuid(geteuid());
  const std::string name =
      user ? printable(user->pw_name) : fmt::format("{}", static_cast<unsigned>(geteuid()));
  return fmt::format("{}@{}", name, hostName()).substr(0, most);
}

}  // namespace wells
