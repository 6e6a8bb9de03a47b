#include "text_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "errors.h"

namespace wells {

namespace {

namespace fs = std::filesystem;

fs::path parentOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// Of what cannot be looked at, nothing is known but that it is no folder for us.
bool isFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool isWritableFolder(const fs::path& folder) {
  return isFolder(folder) && ::access(folder.c_str(), W_OK) == 0;
}

}  // namespace

std::vector<std::string> readLines(const fs::path& file) {
  if (isFolder(file))
    throw UsageError(fmt::format("{}: is a folder; allowed: a text file", file.string()));
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw UsageError(fmt::format("{}: cannot be read: {}; allowed: the name of a readable file",
                                 file.string(), std::strerror(errno)));
  }
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    if (lines.empty() && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
    if (line.ends_with('\r')) line.pop_back();
    lines.push_back(std::move(line));
  }
  return lines;
}

void writeAtomically(const fs::path& file, std::string_view text) {
  const fs::path temporary = fmt::format("{}.{}.part", file.string(), ::getpid());
  std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  std::error_code error;
  if (out) {
    fs::rename(temporary, file, error);
    if (!error) return;
  }
  const std::string reason = error ? error.message() : std::strerror(errno);
  fs::remove(temporary, error);
  throw RunError(fmt::format("{}: cannot be written: {}", file.string(), reason));
}

void requireWritable(std::string_view option, const fs::path& file) {
  if (isWritableFolder(parentOf(file)) && !isFolder(file) && file.has_filename()) return;
  throw UsageError(
      fmt::format("{} {}: cannot be written; allowed: a file in a folder that exists "
                  "and is writable",
                  option, file.string()));
}

void requireFolder(std::string_view option, const fs::path& folder) {
  std::error_code ignored;
  const bool canBeMade = !fs::exists(folder, ignored) && isWritableFolder(parentOf(folder));
  if (isWritableFolder(folder) || canBeMade) return;
  throw UsageError(
      fmt::format("{} {}: cannot be written; allowed: a writable folder, or a new one "
                  "in a folder that exists",
                  option, folder.string()));
}

}  // namespace wells
