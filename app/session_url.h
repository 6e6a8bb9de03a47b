// Which session the operator's tools (spy, peers, set) are about.
#pragma once

#include <string>

#include "command_line.h"

namespace wells {

/// Adds --lcm-url. Without it `url` becomes what LCM_DEFAULT_URL says, or the URL of a peer whose
/// UDPPort is the default. Throws UsageError, now for a wrong LCM_DEFAULT_URL and later for a wrong
/// option.
void addSessionUrl(CLI::App& app, std::string& url);

}  // namespace wells
