#include "peer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <future>
#include <limits>

#include "ball_file.h"
#include "interrupt.h"
#include "peer_runs.h"
#include "target_error.h"
#include "text_file.h"
#include "views.h"
#include "well_motion.h"
#include "world_setup.h"

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
                     .cores = options.places.graphics.value(),
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

/// Chooses the method and puts it into `options`.
Choice chooseFor(PeerOptions& options) {
  constexpr double kTrialOfEndless = 5;  // s
  Config& config = options.config;
  const World start = makeWorld(config, options.engine);
  const auto world = [&](double dt) {
    const auto motion = std::make_shared<WellMotion>(config, dt);
    World now = start;
    now.settings.dt = dt;
    now.tracks.push_back(motion->trackAt(PeerId{static_cast<std::int32_t>(config.peerId)}, 0));
    return TrialStart{now, [motion](World& w) { motion->extend(w.tracks.back(), w.step); }};
  };
  // Keyframes fall on steps: those of a path between longer steps might be other ones.
  const bool isStill = config.wellPath.kind == WellPath::Kind::Still;
  const double longest = isStill ? kLongestStep : std::min(kLongestStep, config.settings.dt);
  const double duration = options.duration.value_or(kTrialOfEndless);
  Choice choice = chooseSettings(world, options.targetError, duration, longest,
                                 options.quiet ? ProgressLine::Shown::No : ProgressLine::Shown::Yes,
                                 config.settings);
  countSteps(options);
  return choice;
}

}  // namespace

int runPeer(PeerOptions options) {
  const auto notice = [&](const std::string& text) {
    if (!options.quiet && !text.empty()) printNotice(text);
  };
  for (const std::string& text : options.notices) notice(text);
  std::optional<Choice> choice;
  if (options.targetError > 0) {
    choice = chooseFor(options);
    if (!options.quiet)
      fmt::print("{}", choiceText(*choice, options.targetError,
                                  options.duration.value_or(std::numeric_limits<double>::max())));
  }
  PeerSetup setup(options);
  std::optional<Link> link;
  if (options.company == Company::Session) link.emplace(openLink(options));
  if (link) notice(link->notice);
  const std::unique_ptr<Pictures> pictures = openPictures(options);

  catchInterrupts();
  RunProgress progress;
  auto run = std::async(std::launch::async, [&] {
    placeThisThread("simulation", options.places.simulation);
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
  report.places = options.places;
  if (!link || !link->lcm) report.places.network.reset();
  if (choice)
    report.trial = {.targetError = options.targetError,
                    .error = choice->best.error,
                    .duration = choice->duration,
                    .substeps = choice->best.method.substeps};
  writeOutputs(setup, report);
  if (!options.quiet) fmt::print("{}", reportAsText(report));
  return 0;
}

}  // namespace wells
