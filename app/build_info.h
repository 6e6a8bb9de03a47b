// What this program was built from and with: columns of every benchmark row.
#pragma once

#include <string_view>

namespace wells::build_info {

extern const std::string_view kCommit;    // short hash, "-dirty" where sources differ; or "unknown"
extern const std::string_view kCompiler;  // name and version
extern const std::string_view kFlags;     // that change the code generated

}  // namespace wells::build_info
