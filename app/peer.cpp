#include "peer.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <future>

#include "ball_file.h"
#include "interrupt.h"
#include "peer_runs.h"
#include "text_file.h"
#include "views.h"

namespace wells {
namespace {

std::unique_ptr<Pictures> openPictures(const PeerOptions& options) {
  if (!options.drawsPictures()) return nullptr;
  const Config& config = options.config;
  const bool inWallTime = options.company == Company::Session;
  return std::make_unique<Pictures>(
      PictureOptions{.width = static_cast<int>(config.screenWidth),
                     .height = static_cast<int>(config.screenHeight),
                     .framesPerSecond = config.graphicsRate,
                     .targetRate = inWallTime ? config.graphicsRate * config.timeScale : 0,
                     .camera = makeCamera(config),
                     .frames = options.frames,
                     .video = options.video,
                     .lastFrame = options.lastFrame});
}

RunReport waitFor(std::future<RunReport>& run, const ProgressLine& line,
                  const RunProgress& progress) {
  constexpr std::chrono::milliseconds kInterval{250};
  auto start = std::chrono::steady_clock::now();
  while (run.wait_for(kInterval) != std::future_status::ready) {
    if (!progress.joined) start = std::chrono::steady_clock::now();
    const auto passed = std::chrono::steady_clock::now() - start;
    line.show(progress, std::chrono::duration<double>(passed).count());
  }
  return run.get();
}

void writeOutputs(const PeerSetup& setup, const RunReport& report) {
  const PeerOptions& options = setup.options;
  if (!options.snapshot.empty()) setup.saveSnapshot();
  if (!options.stateOut.empty()) writeAtomically(options.stateOut, ballsAsCsv(report.balls));
  if (!options.report.empty()) writeAtomically(options.report, reportAsJson(report));
}

}  // namespace

int runPeer(const PeerOptions& options) {
  const auto notice = [&](const std::string& text) {
    if (!options.quiet && !text.empty()) printNotice(text);
  };
  for (const std::string& text : options.notices) notice(text);
  PeerSetup setup(options);
  std::optional<Link> link;
  if (options.company == Company::Session) link.emplace(openLink(options));
  if (link) notice(link->notice);
  const std::unique_ptr<Pictures> pictures = openPictures(options);

  catchInterrupts();
  RunProgress progress;
  auto run = std::async(std::launch::async, [&] {
    if (link) return runInSession(setup, *link, pictures.get(), progress, notice);
    return runAlone(setup, pictures.get(), progress);
  });
  RunReport report;
  {
    const ProgressLine line({options.steps, setup.world.settings.dt, options.hasEnd()},
                            options.quiet ? ProgressLine::Shown::No : ProgressLine::Shown::Yes);
    report = waitFor(run, line, progress);
  }
  if (pictures) {
    pictures->close();
    const Pictures::Counts counts = pictures->counts();
    report.graphics = {pictures->targetRate(), counts.meanRate};
    report.framesDrawn = counts.drawn;
    report.framesRepeated = counts.repeated;
  }
  writeOutputs(setup, report);
  if (!options.quiet) fmt::print("{}", reportAsText(report));
  return 0;
}

}  // namespace wells
