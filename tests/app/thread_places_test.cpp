// Who runs where, on machines that are told.
#include "thread_places.h"

#include <gtest/gtest.h>

#include <numeric>
#include <thread>

#include "cores.h"
#include "errors.h"
#include "keys.h"
#include "threads/placement.h"
#include "values.h"

namespace wells {
namespace {

using Cores = std::vector<int>;

constexpr OtherLoops kBoth{.graphics = true, .network = true};

Cores firstCores(int count) {
  Cores cores(static_cast<std::size_t>(count));
  std::iota(cores.begin(), cores.end(), 0);
  return cores;
}

Config withKeys(const std::vector<std::pair<std::string, std::string>>& settings) {
  Config config;
  for (const auto& [key, value] : settings) findKey(key)->set(config, value, {});
  return config;
}

TEST(Cores, AreReadAsRisingListsAndWrittenShort) {
  const std::pair<const char*, const char*> cases[] = {{"3", "3"},         {"0,2-5", "0,2-5"},
                                                       {"5,4,3", "3-5"},   {"1-2,2-3", "1-3"},
                                                       {" 7 , 9 ", "7,9"}, {"0-0", "0"}};
  for (const auto& [read, written] : cases) EXPECT_EQ(formatCores(parseCores(read)), written);
  EXPECT_EQ(parseCores("0,2-4"), (Cores{0, 2, 3, 4}));
  for (const char* bad : {"", "a", "1,", "-1", "1-", "2-1", "1024", "0-99999999999", "1.5", "any"})
    EXPECT_THROW(parseCores(bad), BadValue) << bad;
}

TEST(Cores, ChoicesReadWhatTheyWrite) {
  for (const char* key : {"SimulationCores", "GraphicsCores", "NetworkCores"}) {
    EXPECT_EQ(findKey(key)->defaultText(), "auto");
    for (const char* value : {"auto", "any", "0,2-5"})
      EXPECT_EQ(findKey(key)->get(withKeys({{key, value}})), std::vector<std::string>{value});
  }
}

TEST(ThreadPlaces, AreThoseOfTheOriginalWhereTheMachineHasTheCores) {
  const ThreadPlaces places = placeThreads({}, kBoth, firstCores(6), 6);
  EXPECT_EQ(places.graphics, Cores{0});
  EXPECT_EQ(places.network, Cores{1});
  EXPECT_EQ(places.simulation, (Cores{2, 3, 4, 5}));
  EXPECT_EQ(places.simulationThreads, 4);
  EXPECT_EQ(places.why, "pinned: each loop has cores of its own");
}

TEST(ThreadPlaces, TakeOnlyCoresThatTheProcessMayUse) {
  const ThreadPlaces places = placeThreads({}, kBoth, Cores{3, 5, 8, 13}, 16);
  EXPECT_EQ(places.graphics, Cores{3});
  EXPECT_EQ(places.network, Cores{5});
  EXPECT_EQ(places.simulation, (Cores{8, 13}));
  EXPECT_EQ(places.simulationThreads, 2);
}

TEST(ThreadPlaces, KeepNothingForLoopsThatAreNot) {
  const ThreadPlaces drawn = placeThreads({}, {.graphics = true}, firstCores(3), 3);
  EXPECT_EQ(drawn.graphics, Cores{0});
  EXPECT_EQ(drawn.network, std::nullopt);
  EXPECT_EQ(drawn.simulation, (Cores{1, 2}));
  const ThreadPlaces alone = placeThreads({}, {}, firstCores(6), 6);
  EXPECT_EQ(alone.simulation, Cores{});
  EXPECT_EQ(alone.simulationThreads, 6);
  EXPECT_EQ(alone.why, "not pinned: no loop runs beside the simulation");
}

TEST(ThreadPlaces, AreLeftToTheSystemWhereCoresAreFew) {
  for (const int cores : {1, 2, 3}) {
    const ThreadPlaces places = placeThreads({}, kBoth, firstCores(cores), cores);
    EXPECT_EQ(places.graphics, Cores{});
    EXPECT_EQ(places.network, Cores{});
    EXPECT_EQ(places.simulation, Cores{});
    EXPECT_EQ(places.simulationThreads, std::max(1, cores - 1)) << "one draws";
    EXPECT_EQ(places.why, "not pinned: to keep the loops apart takes 4 cores, and there are " +
                              std::to_string(cores));
  }
}

TEST(ThreadPlaces, GoByTheKeysOnceOneIsSet) {
  const Config config = withKeys({{"SimulationCores", "1-2"}, {"GraphicsCores", "any"}});
  const ThreadPlaces places = placeThreads(config, kBoth, firstCores(8), 8);
  EXPECT_EQ(places.simulation, (Cores{1, 2}));
  EXPECT_EQ(places.simulationThreads, 2);
  EXPECT_EQ(places.graphics, Cores{});
  EXPECT_EQ(places.network, Cores{}) << "auto beside others is any";
  EXPECT_EQ(places.why, "as the keys say");
  const Config free = withKeys({{"NetworkCores", "any"}});
  EXPECT_EQ(placeThreads(free, kBoth, firstCores(8), 8).simulation, Cores{});
}

TEST(ThreadPlaces, GiveTheSimulationAsManyThreadsAsAsked) {
  EXPECT_EQ(placeThreads(withKeys({{"Threads", "3"}}), kBoth, firstCores(2), 2).simulationThreads,
            3);
  EXPECT_EQ(placeThreads({}, {}, firstCores(128), 128).simulationThreads, 8);
}

std::string errorOf(const Config& config, const Cores& allowed, int coresOfMachine) {
  try {
    placeThreads(config, kBoth, allowed, coresOfMachine);
    return "accepted";
  } catch (const UsageError& error) {
    return error.what();
  }
}

TEST(ThreadPlaces, RefuseCoresThatAreNotThereOrNotAllowed) {
  EXPECT_EQ(errorOf(withKeys({{"NetworkCores", "1,9"}}), firstCores(4), 4),
            "NetworkCores=1,9: this machine has no core 9; allowed: 0-3");
  EXPECT_EQ(errorOf(withKeys({{"GraphicsCores", "1"}}), Cores{0, 2, 3}, 4),
            "GraphicsCores=1: this process may not run on core 1 (see taskset); allowed: 0,2-3");
}

TEST(ThreadPlaces, HoldForTheThreadAndThoseThatItStarts) {
  const int last = allowedCores().back();
  std::thread([&] {
    placeThisThread("simulation", {});
    EXPECT_GE(allowedCores().size(), 1u);
    placeThisThread("simulation", std::vector{last});
    EXPECT_EQ(allowedCores(), Cores{last});
    std::thread([&] { EXPECT_EQ(allowedCores(), Cores{last}); }).join();
    EXPECT_THROW(placeThisThread("simulation", std::vector{1023}), RunError);
  }).join();
}

TEST(ThreadPlaces, AreWrittenForPeople) {
  EXPECT_EQ(ThreadPlaces::text(std::nullopt), "none");
  EXPECT_EQ(ThreadPlaces::text(Cores{}), "any");
  EXPECT_EQ(ThreadPlaces::text(Cores{1, 2, 3}), "1-3");
}

}  // namespace
}  // namespace wells
