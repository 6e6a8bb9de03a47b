#include "session_url.h"

#include <fmt/format.h>

#include <cstdlib>

#include "config.h"
#include "errors.h"
#include "network/lcm_url.h"

namespace wells {
namespace {

constexpr const char* kVariable = "LCM_DEFAULT_URL";

// In full: what the URL leaves out is written out.
std::string checkedUrl(const std::string& source, const std::string& url) {
  try {
    return parseLcmUrl(url).text();
  } catch (const LcmUrlError& error) {
    throw UsageError(
        fmt::format("{}{}: {}; allowed: udpm://GROUP:PORT?ttl=HOPS&recv_buf_size=BYTES", source,
                    url, error.what()));
  }
}

}  // namespace

void addSessionUrl(CLI::App& app, std::string& url) {
  const char* variable = std::getenv(kVariable);
  url = variable && *variable ? checkedUrl(std::string(kVariable) + "=", variable)
                              : lcmUrl(static_cast<int>(Config{}.udpPort), 0);
  app.add_option_function<std::string>(
         "--lcm-url", [&url](const std::string& value) { url = checkedUrl("--lcm-url ", value); },
         fmt::format("of the session; ttl=0 stays on this host, ttl=1 reaches the LAN. Without it "
                     "the variable {} counts",
                     kVariable))
      ->type_name("URL")
      ->default_str(url);
}

}  // namespace wells
