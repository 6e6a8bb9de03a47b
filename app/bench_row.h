// What the rows of all benchmarks share: quoting, and the last columns, which say what was measured
// with what and on what.
#pragma once

#include <string>
#include <string_view>

namespace wells {

/// The last columns of every row.
inline constexpr std::string_view kBuildColumns = "commit,compiler,flags,cpu";

/// Their values.
std::string buildColumns();

/// Model name of the processor, or "unknown".
std::string processor();

/// A CSV field: quoted where it holds a comma or a quote (RFC 4180).
std::string csvField(std::string_view text);

}  // namespace wells
