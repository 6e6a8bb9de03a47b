#include "probe_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace wells {
namespace {

std::string reachText(int ttl) {
  if (ttl == 0) return "stays on this machine";
  if (ttl == 1) return "reaches the LAN";
  return fmt::format("crosses up to {} router{}", ttl - 1, ttl == 2 ? "" : "s");
}

std::string routeText(const std::optional<MulticastRoute>& route) {
  if (!route) return "by an interface that the system does not name";
  return fmt::format("by {}{}", route->interface,
                     route->address.empty() ? "" : " (" + route->address + ")");
}

std::string percent(std::int64_t heard, std::int64_t sent) {
  const double share = sent > 0 ? static_cast<double>(heard) / static_cast<double>(sent) : 0;
  return fmt::format("{:.0f} %", 100 * share);
}

std::string row(const std::string& who, const std::string& heard, const std::string& hearsUs,
                const std::string& roundTrip) {
  return fmt::format("{:<36}{:>8}   {:<12}{:>12}\n", who, heard, hearsUs, roundTrip);
}

std::string roundTripText(const std::optional<double>& roundTrip) {
  return roundTrip ? fmt::format("{:.1f} ms", 1000 * *roundTrip) : "-";
}

std::string table(const ProbeSurroundings& here, const ProbeRound& round) {
  if (round.hosts().empty() && round.peers().empty()) return "";
  std::string text = row("host", "heard", "hears us", "round trip");
  for (const ProbedHost* host : round.hosts()) {
    const std::string who =
        host->name + (host->name == here.host ? " (another run on this machine)" : "");
    text += row(who, percent(host->reception.heard(), host->reception.sent()),
                host->hearsUs() ? "yes, " + percent(host->us->heard, host->us->sent) : "no",
                roundTripText(host->roundTrip));
  }
  for (const NoticedPeer* peer : round.peers()) {
    text += row(fmt::format("peer {} of a session", value(peer->id)),
                percent(peer->reception.heard(), peer->reception.sent()), "not asked", "-");
  }
  return text;
}

std::string finding(const ProbeSurroundings& here, const ProbeRound& round) {
  if (passesBothWays(round)) {
    std::string text =
        here.url.ttl > 0 ? "Multicast passes both ways.\n"
                         : "Multicast passes both ways on this machine; ttl=0 reaches no other.\n";
    for (const ProbedHost* host : round.hosts())
      if (!host->hearsUs())
        text += fmt::format("{} does not hear this machine: let UDP port {} and IGMP in there.\n",
                            host->name, here.url.port);
    return text;
  }
  if (!round.hosts().empty())
    return "Multicast comes from another machine, and does not get back to it.\n";
  if (!round.peers().empty()) {
    return "Multicast comes from peers of a session. Whether they hear this machine, only this "
           "command can\ntell: run it on their machines at the same time.\n";
  }
  return fmt::format("Nobody else was heard in {:g} s.\n", here.seconds);
}

std::string whatToCheck(const ProbeSurroundings& here) {
  const LcmUrl& url = here.url;
  std::string text = "What to check:\n";
  text += fmt::format(
      "- The same command runs on the other machine at the same time, with group {}\n"
      "  and port {}. Give yourself time to start both: --seconds 60.\n",
      url.group, url.port);
  if (url.ttl == 0) {
    LcmUrl reaching = url;
    reaching.ttl = 1;
    text += fmt::format("- ttl=0 stays on this machine. To reach the LAN:\n  --lcm-url '{}'\n",
                        reaching.text());
  }
  text += fmt::format(
      "- The route, on each machine. Here multicast leaves {}{}.\n"
      "  To choose another interface: sudo ip route add 224.0.0.0/4 dev <interface>\n",
      routeText(here.route),
      here.route && here.route->staysHere() ? ", which reaches no other machine" : "");
  text += fmt::format(
      "- The firewall, on each machine: UDP port {0} and IGMP must come in, for example\n"
      "  sudo nft insert rule inet filter input udp dport {0} accept\n",
      url.port);
  text +=
      "- The switch: wireless access points and some switches don't pass multicast; use a cable.\n";
  return text;
}

}  // namespace

bool passesBothWays(const ProbeRound& round) {
  return std::ranges::any_of(round.hosts(), [](const ProbedHost* host) { return host->hearsUs(); });
}

std::string probeReport(const ProbeSurroundings& here, const ProbeRound& round) {
  const LcmUrl& url = here.url;
  std::string text = fmt::format("{}: group {}:{}, ttl {} ({}), {}\n", here.host, url.group,
                                 url.port, url.ttl, reachText(url.ttl), routeText(here.route));
  text += table(here, round);
  text += finding(here, round);
  if (!passesBothWays(round)) text += whatToCheck(here);
  return text;
}

}  // namespace wells
