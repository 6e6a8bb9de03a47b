// Whole files: reading by line, and writing so that nobody ever sees a part.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace wells {

/// The lines without their ends (LF or CRLF) and without a UTF-8 byte order mark. Throws UsageError
/// when the file cannot be read.
std::vector<std::string> readLines(const std::filesystem::path& file);

/// Writes a temporary file beside `file` to the disk and renames it: whatever happens, `file` holds
/// its old content or the new one. Throws RunError, also for what is no regular file (a device);
/// the temporary file is then gone.
void writeAtomically(const std::filesystem::path& file, std::string_view bytes);

/// Throws UsageError unless a file can be created in the folder of `file`, where nothing but a
/// regular file may stand in its place. `option` is named.
void requireWritable(std::string_view option, const std::filesystem::path& file);

/// Throws UsageError unless `folder` is a writable folder or can be made.
void requireFolder(std::string_view option, const std::filesystem::path& folder);

/// Makes `folder` unless it is there. Throws UsageError unless it is then a writable folder.
void makeFolder(std::string_view option, const std::filesystem::path& folder);

}  // namespace wells
