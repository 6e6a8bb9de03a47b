#include "snapshot_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "errors.h"
#include "text_file.h"

namespace wells {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, std::string_view reason) {
  throw UsageError(
      fmt::format("{}: {}; allowed: a snapshot that --save-snapshot wrote", file.string(), reason));
}

std::string readBytes(const fs::path& file) {
  std::error_code ignored;
  if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored))
    refuse(file, "is no regular file");
  std::ifstream in(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in) refuse(file, fmt::format("cannot be read: {}", std::strerror(errno)));
  return bytes;
}

}  // namespace

void writeSnapshot(const fs::path& file, const Snapshot& snapshot) {
  try {
    writeAtomically(file, encode(snapshot));
  } catch (const SnapshotError& error) {
    throw RunError(fmt::format("{}: cannot be saved: {}", file.string(), error.what()));
  }
}

Snapshot readSnapshot(const fs::path& file) {
  try {
    return decode(readBytes(file));
  } catch (const SnapshotError& error) {
    refuse(file, error.what());
  }
}

}  // namespace wells
