#include "demo_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "ball_file.h"
#include "errors.h"

namespace wells {
namespace {

using Json = nlohmann::json;

Json readReport(const std::filesystem::path& file) {
  try {
    std::ifstream in(file);
    return Json::parse(in);
  } catch (const Json::exception& error) {
    throw RunError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

struct Row {
  const char* label;
  std::function<std::string(const Json&)> cell;
};

std::string integer(const Json& report, const char* key) {
  return fmt::format("{}", report.at(key).get<std::int64_t>());
}

std::string rate(const Json& report, const char* loop) {
  const Json& r = report.at("rates").at(loop);
  const double actual = r.at("actual_Hz").get<double>();
  const double target = r.at("target_Hz").get<double>();
  return target > 0 ? fmt::format("{:.1f} of {:.0f}", actual, target)
                    : fmt::format("{:.1f}", actual);
}

const std::vector<Row>& rows() {
  static const std::vector<Row> table = {
      {"balls owned at the end", [](const Json& r) { return integer(r, "balls_owned"); }},
      {"balls handed over", [](const Json& r) { return integer(r, "handovers"); }},
      {"balls taken over", [](const Json& r) { return integer(r, "handovers_taken"); }},
      {"energy on joining (J)",
       [](const Json& r) { return fmt::format("{:.1f}", r.at("energy_start_J").get<double>()); }},
      {"energy at the end (J)",
       [](const Json& r) { return fmt::format("{:.1f}", r.at("energy_end_J").get<double>()); }},
      {"worst overlap (m)",
       [](const Json& r) { return fmt::format("{:.4f}", r.at("max_overlap_m").get<double>()); }},
      {"escaped balls", [](const Json& r) { return integer(r, "escaped"); }},
      {"simulation (Hz)", [](const Json& r) { return rate(r, "simulation"); }},
      {"network (Hz)", [](const Json& r) { return rate(r, "network"); }},
      {"graphics (Hz)", [](const Json& r) { return rate(r, "graphics"); }},
      {"frames repeated", [](const Json& r) { return integer(r, "frames_repeated"); }},
      {"messages sent", [](const Json& r) { return integer(r, "messages_sent"); }},
      {"messages received", [](const Json& r) { return integer(r, "messages_received"); }},
      {"messages dropped", [](const Json& r) { return integer(r, "messages_dropped"); }},
      {"prediction error, largest (m)",
       [](const Json& r) {
         return fmt::format("{:.2g}", r.at("view_difference_max_m").get<double>());
       }},
  };
  return table;
}

std::string tableOf(const std::vector<Json>& reports) {
  std::string text = fmt::format("{:<31}", "");
  for (const Json& report : reports)
    text += fmt::format("{:>16}", fmt::format("peer {}", report.at("peer").get<int>()));
  text += '\n';
  for (const Row& row : rows()) {
    text += fmt::format("{:<31}", row.label);
    for (const Json& report : reports) text += fmt::format("{:>16}", row.cell(report));
    text += '\n';
  }
  return text;
}

double largestDifference(const Balls& a, const Balls& b) {
  double largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, length(a.position[i] - b.position[i]));
  return largest;
}

std::string differenceOf(const std::vector<Json>& reports, const std::vector<PeerFiles>& peers) {
  if (reports.size() < 2) return "";
  const auto step = [&](std::size_t i) { return reports[i].at("steps").get<std::int64_t>(); };
  if (step(0) != step(1)) {
    return fmt::format(
        "\nThe peers ended at different steps ({} and {}): their views are not compared.\n",
        step(0), step(1));
  }
  return fmt::format("\nLargest difference between the two views at step {}: {:.3g} m.\n", step(0),
                     largestDifference(readBalls(peers[0].state), readBalls(peers[1].state)));
}

}  // namespace

PeerFiles peerFiles(const std::filesystem::path& folder, int id) {
  const auto named = [&](const char* end) { return folder / fmt::format("peer-{}{}", id, end); };
  return {.report = named(".json"),
          .state = named(".csv"),
          .video = named(".mp4"),
          .lastFrame = named(".png"),
          .log = named(".log")};
}

std::string demoSummary(const std::vector<PeerFiles>& peers) {
  std::vector<Json> reports;
  for (const PeerFiles& files : peers) reports.push_back(readReport(files.report));
  try {
    const Json& first = reports.front();
    std::string text =
        fmt::format("{} shared {} balls for {:.2f} s of simulated time by {}.\n\n",
                    peers.size() == 1 ? "One peer, alone," : fmt::format("{} peers", peers.size()),
                    readBalls(peers.front().state).size(), first.at("sim_time_s").get<double>(),
                    first.at("transport").get<std::string>());
    text += tableOf(reports) + differenceOf(reports, peers) + '\n';
    for (std::size_t i = 0; i < peers.size(); ++i)
      text +=
          fmt::format("Video and last frame of peer {}: {}, {}\n", reports[i].at("peer").get<int>(),
                      peers[i].video.string(), peers[i].lastFrame.string());
    return text;
  } catch (const Json::exception& error) {
    throw RunError(fmt::format("{}: {}", peers.front().report.string(), error.what()));
  }
}

}  // namespace wells
