#include "text_file.h"

#include <fcntl.h>
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

// Renaming over a device, a pipe or a socket would take it from everybody who uses it.
bool isReplaceable(const fs::path& file) {
  std::error_code ignored;
  return !fs::exists(file, ignored) || fs::is_regular_file(file, ignored);
}

std::error_code lastError() {
  return {errno, std::generic_category()};
}

std::error_code writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return lastError();
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

// Returns when the bytes are on the disk: renaming a file whose content is still on its way would
// leave an empty one after a power failure.
std::error_code writeThrough(const fs::path& file, std::string_view bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) return lastError();
  std::error_code error = writeAll(descriptor, bytes);
  if (!error && ::fsync(descriptor) != 0 && errno != EINVAL) error = lastError();
  if (::close(descriptor) != 0 && !error) error = lastError();
  return error;
}

// Makes a renaming last. Some file systems cannot; the file is whole either way.
void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
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

void writeAtomically(const fs::path& file, std::string_view bytes) {
  if (!isReplaceable(file))
    throw RunError(fmt::format("{}: cannot be written: is no regular file", file.string()));
  const fs::path temporary = fmt::format("{}.{}.part", file.string(), ::getpid());
  std::error_code error = writeThrough(temporary, bytes);
  if (!error) fs::rename(temporary, file, error);
  if (!error) {
    syncFolder(parentOf(file));
    return;
  }
  std::error_code ignored;
  fs::remove(temporary, ignored);
  throw RunError(fmt::format("{}: cannot be written: {}", file.string(), error.message()));
}

void requireWritable(std::string_view option, const fs::path& file) {
  if (isWritableFolder(parentOf(file)) && isReplaceable(file) && file.has_filename()) return;
  throw UsageError(
      fmt::format("{} {}: cannot be written; allowed: a file in a folder that exists "
                  "and is writable, no folder and no device",
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

void makeFolder(std::string_view option, const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw UsageError(fmt::format(
        "{} {}: cannot be made: {}; allowed: a writable folder, or one that can be made", option,
        folder.string(), error.message()));
  requireFolder(option, folder);
}

}  // namespace wells
