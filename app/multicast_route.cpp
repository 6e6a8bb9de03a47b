#include "multicast_route.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <memory>
#include <span>

namespace wells {
namespace {

struct RouteQuestion {
  nlmsghdr message{};
  rtmsg route{};
  rtattr attribute{};
  in_addr destination{};
};

RouteQuestion questionFor(const LcmUrl& url) {
  RouteQuestion question;
  question.message.nlmsg_len = sizeof question;
  question.message.nlmsg_type = RTM_GETROUTE;
  question.message.nlmsg_flags = NLM_F_REQUEST;
  question.route.rtm_family = AF_INET;
  question.route.rtm_dst_len = 32;
  question.attribute.rta_type = RTA_DST;
  question.attribute.rta_len = RTA_LENGTH(sizeof question.destination);
  inet_pton(AF_INET, url.group.c_str(), &question.destination);
  return question;
}

// The index of the interface in the kernel's answer; 0: there is none.
unsigned interfaceIn(std::span<const std::byte> answer) {
  nlmsghdr message{};
  if (answer.size() < NLMSG_LENGTH(sizeof(rtmsg))) return 0;
  std::memcpy(&message, answer.data(), sizeof message);
  if (message.nlmsg_type != RTM_NEWROUTE) return 0;
  auto rest = answer.subspan(NLMSG_LENGTH(sizeof(rtmsg)));
  rtattr attribute{};
  while (rest.size() >= sizeof attribute) {
    std::memcpy(&attribute, rest.data(), sizeof attribute);
    if (attribute.rta_len < sizeof attribute || attribute.rta_len > rest.size()) return 0;
    unsigned index = 0;
    if (attribute.rta_type == RTA_OIF && attribute.rta_len >= RTA_LENGTH(sizeof index)) {
      std::memcpy(&index, rest.data() + RTA_LENGTH(0), sizeof index);
      return index;
    }
    rest = rest.subspan(std::min<std::size_t>(RTA_ALIGN(attribute.rta_len), rest.size()));
  }
  return 0;
}

unsigned askKernel(const LcmUrl& url) {
  const int descriptor = socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE);
  if (descriptor < 0) return 0;
  const RouteQuestion question = questionFor(url);
  std::array<std::byte, 4096> answer;
  ssize_t size = -1;
  // The kernel answers before send() returns.
  if (send(descriptor, &question, sizeof question, 0) == sizeof question)
    size = recv(descriptor, answer.data(), answer.size(), MSG_DONTWAIT);
  close(descriptor);
  return size > 0 ? interfaceIn(std::span(answer).first(static_cast<std::size_t>(size))) : 0;
}

std::string addressOf(const std::string& interface) {
  ifaddrs* list = nullptr;
  if (getifaddrs(&list) != 0) return "";
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> owner(list, freeifaddrs);
  for (const ifaddrs* entry = list; entry; entry = entry->ifa_next) {
    if (interface != entry->ifa_name || !entry->ifa_addr || entry->ifa_addr->sa_family != AF_INET)
      continue;
    std::array<char, INET_ADDRSTRLEN> text{};
    inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(entry->ifa_addr)->sin_addr,
              text.data(), text.size());
    return text.data();
  }
  return "";
}

}  // namespace

std::optional<MulticastRoute> multicastRoute(const LcmUrl& url) {
  std::array<char, IF_NAMESIZE> name{};
  const unsigned index = askKernel(url);
  if (index == 0 || !if_indextoname(index, name.data())) return std::nullopt;
  return MulticastRoute{name.data(), addressOf(name.data())};
}

}  // namespace wells
