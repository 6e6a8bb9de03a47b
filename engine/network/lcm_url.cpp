#include "network/lcm_url.h"

#include <arpa/inet.h>

#include <charconv>
#include <limits>

namespace wells {
namespace {

constexpr std::string_view kProvider = "udpm://";
constexpr int kMaxTtl = 255;

int parseNumber(const char* name, std::string_view text, int low, int high) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < low || value > high) {
    throw LcmUrlError("LCM URL: " + std::string(name) + " is \"" + std::string(text) +
                      "\"; it must be a whole number, " + std::to_string(low) + " to " +
                      std::to_string(high));
  }
  return value;
}

// Cuts `text` at the first `separator`: returns what is before, leaves what is after.
std::string_view cutBefore(std::string_view& text, char separator) {
  const auto at = text.find(separator);
  const auto head = text.substr(0, at);
  text = at == std::string_view::npos ? std::string_view{} : text.substr(at + 1);
  return head;
}

std::string parseGroup(std::string_view text) {
  const std::string group(text);
  in_addr address{};
  if (inet_pton(AF_INET, group.c_str(), &address) != 1 || !IN_MULTICAST(ntohl(address.s_addr))) {
    throw LcmUrlError("LCM URL: the group is \"" + group +
                      "\"; it must be a multicast address, 224.0.0.0 to 239.255.255.255");
  }
  return group;
}

void parseOption(std::string_view option, LcmUrl& url) {
  const auto name = cutBefore(option, '=');
  if (name == "ttl") {
    url.ttl = parseNumber("ttl", option, 0, kMaxTtl);
  } else if (name == "recv_buf_size") {
    url.receiveBuffer =
        parseNumber("recv_buf_size", option, 1, std::numeric_limits<std::int32_t>::max());
  } else {
    throw LcmUrlError("LCM URL: unknown option \"" + std::string(name) +
                      "\"; ttl and recv_buf_size are known");
  }
}

}  // namespace

std::string LcmUrl::text() const {
  return std::string(kProvider) + group + ":" + std::to_string(port) +
         "?ttl=" + std::to_string(ttl) + "&recv_buf_size=" + std::to_string(receiveBuffer);
}

LcmUrl parseLcmUrl(std::string_view text) {
  if (!text.starts_with(kProvider)) {
    throw LcmUrlError("LCM URL: \"" + std::string(text) +
                      "\" does not start with udpm://; for example " + LcmUrl{}.text());
  }
  text.remove_prefix(kProvider.size());
  LcmUrl url;
  auto address = cutBefore(text, '?');
  if (!address.empty()) {
    url.group = parseGroup(cutBefore(address, ':'));
    if (!address.empty()) {
      url.port = static_cast<std::uint16_t>(parseNumber("the port", address, 1, 65535));
    }
  }
  while (!text.empty()) parseOption(cutBefore(text, '&'), url);
  return url;
}

std::string lcmUrl(int port, int ttl) {
  LcmUrl url;
  url.port = static_cast<std::uint16_t>(parseNumber("the port", std::to_string(port), 1, 65535));
  url.ttl = parseNumber("ttl", std::to_string(ttl), 0, kMaxTtl);
  return url.text();
}

}  // namespace wells
