#include "text_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "errors.h"

namespace wells {

namespace fs = std::filesystem;

std::vector<std::string> readLines(const fs::path& file) {
  if (fs::is_directory(file))
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
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (fs::is_directory(folder) && ::access(folder.c_str(), W_OK) == 0 && !fs::is_directory(file) &&
      file.has_filename())
    return;
  throw UsageError(
      fmt::format("{} {}: cannot be written; allowed: a file in a folder that exists "
                  "and is writable",
                  option, file.string()));
}

}  // namespace wells
