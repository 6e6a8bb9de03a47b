// What benchmarks make of the times that they measured, on times that are made up.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "app/temporary_folder.h"
#include "bench_run.h"
#include "feature_bench.h"
#include "paired_ratio.h"
#include "scenes/catalogue.h"
#include "speed_table.h"
#include "stage_times.h"
#include "wake_cost.h"

namespace wells {
namespace {

TEST(PairedRatio, IsTheMedianOfRatiosNotTheRatioOfMedians) {
  // A machine that is three times as slow for the third pair.
  const PairedRatio ratio =
      pairedRatio(std::vector<double>{10, 12, 30}, std::vector<double>{1, 2, 3});
  EXPECT_EQ(ratio.median, 10);  // of 10, 6, 10
  EXPECT_EQ(ratio.least, 6);
  EXPECT_EQ(ratio.most, 10);
}

TEST(PairedRatio, OfAnEvenNumberIsTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(pairedRatio(std::vector<double>{1, 2, 3, 40}, std::vector<double>{1, 1, 1, 1}).median,
            2.5);
}

TEST(PairedRatio, LeavesOutWhatHasNoPair) {
  const PairedRatio ratio = pairedRatio(std::vector<double>{4, 9, 100}, std::vector<double>{2, 3});
  EXPECT_EQ(ratio.median, 2.5);
  EXPECT_EQ(ratio.most, 3);
  EXPECT_TRUE(std::isnan(pairedRatio({}, std::vector<double>{1}).median));
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

/// Commas outside quotes.
long columns(const std::string& line) {
  bool isQuoted = false;
  return 1 + std::ranges::count_if(line, [&](char c) {
           if (c == '"') isQuoted = !isQuoted;
           return c == ',' && !isQuoted;
         });
}

void expectTable(const std::string& csv, std::size_t rows) {
  const auto all = lines(csv);
  ASSERT_EQ(all.size(), rows + 1);
  for (const std::string& line : all) EXPECT_EQ(columns(line), columns(all.front())) << line;
}

/// Two methods in rounds, and one that did not end.
class SpeedTables : public testing::Test {
 protected:
  SpeedTables() {
    BenchResult measured;
    measured.scene = "T1";
    measured.end.ballOverlap = 0.0421;
    measured.end.escaped = 3;
    std::ofstream(folder_ / "row.csv") << csvHeader() << '\n' << csvRow(measured) << '\n';
    const BenchRow row(folder_ / "row.csv");
    SpeedMethod bullet, threads, exact;
    bullet.engine = "bullet";
    threads.threads = 2;
    exact.contacts = "exact";
    result_ = {&findSpeedScene("T1-10000"), 300, 5, {}};
    result_.rows = {{bullet, {80, 82, 160}, row},
                    {SpeedMethod{}, {8, 8, 8}, row},
                    {threads, {4, 5, 8}, row},
                    {exact, {}, {}, "not done in 20 s"}};
    result_.rows[1].ballBytes = 512;
  }

  TemporaryFolder folder_;
  SpeedResult result_;
};

TEST_F(SpeedTables, DivideRoundByRound) {
  EXPECT_EQ(timesBullet(result_, result_.rows[1]).median, 10.25);
  EXPECT_EQ(timesBullet(result_, result_.rows[1]).most, 20);
  EXPECT_EQ(timesOneThread(result_, result_.rows[2])->median, 1.6);
  EXPECT_FALSE(timesOneThread(result_, result_.rows[1]));
  EXPECT_EQ(result_.rounds(), 3);
}

TEST_F(SpeedTables, HaveARowForEachMethod) {
  expectTable(speedCsv(std::span(&result_, 1)), 4);
  const auto text = lines(speedText(result_));
  ASSERT_EQ(text.size(), 6u);
  EXPECT_NE(text[0].find("10000 balls, steps 0 to 300, 3 round(s) of up to 5"), std::string::npos);
  for (const char* part : {"ours ", " 8 ", "10.2 (10..20)", "0.0421", " 3 ", " 512 "})
    EXPECT_NE(text[3].find(part), std::string::npos) << part << " in " << text[3];
  EXPECT_NE(text[4].find("1.6 (1..2)"), std::string::npos) << text[4];
  EXPECT_NE(text[5].find("not done in 20 s"), std::string::npos);
}

TEST_F(SpeedTables, PlotEachMethodThatRanAndTheLineOf60Hz) {
  const std::string script = speedScript(std::span(&result_, 1));
  for (const char* part : {"title 'stock Bullet'", "title 'ours'", "title 'ours on 2 threads'",
                           "1000.0/60", "set logscale xy"})
    EXPECT_NE(script.find(part), std::string::npos) << part;
  EXPECT_EQ(script.find("exact"), std::string::npos);
}

TEST(SpeedPlan, NamesMethodsAndAsksForThem) {
  SpeedMethod method;
  EXPECT_EQ(name(method), "ours");
  EXPECT_EQ(arguments(method), (std::vector<std::string>{"--engine", "ours"}));
  method.substeps = 4;
  method.iterations = 1;
  method.threads = 2;
  EXPECT_EQ(name(method), "ours 4x1 on 2 threads");
  EXPECT_EQ(arguments(method), (std::vector<std::string>{"--engine", "ours", "--substeps", "4",
                                                         "--iterations", "1", "--threads", "2"}));
  Settings settings;
  apply(method, settings);
  EXPECT_EQ(settings.substeps, 4);
  EXPECT_EQ(settings.iterations, 1);
  EXPECT_EQ(settings.contactMethod, ContactMethod::Auto);
}

TEST(SpeedPlan, IsOfScenesThatExistAndFitsItsTime) {
  double shares = 0;  // s
  for (const SpeedScene& scene : speedScenes()) {
    EXPECT_NO_THROW(findScene(scene.scene)) << scene.name;
    shares += scene.share;
    const auto methods = speedMethods(scene, std::vector<std::int64_t>{1, 2});
    EXPECT_TRUE(methods.front().isBullet());
    EXPECT_EQ(methods[1], SpeedMethod{});
    EXPECT_EQ(methods[2].threads, 2);
  }
  EXPECT_LE(shares, kFullMinutes * 60);
}

TEST(FeatureTable, SaysWhatIsFree) {
  FeatureRow row;
  row.scene = "T1, 1,000";
  row.unused = {1.02, 1.0, 1.3};
  FeatureRow dear = row;
  dear.unused.median = 1.021;
  const std::vector<FeatureRow> rows = {row, dear};
  expectTable(featureCsv(rows), 2);
  const auto text = lines(featureText(rows));
  ASSERT_EQ(text.size(), 3u);
  EXPECT_NE(text[1].find("1.020 (1.000..1.300) pass"), std::string::npos) << text[1];
  EXPECT_NE(text[2].find("1.021 (1.000..1.300) FAIL"), std::string::npos) << text[2];
}

TEST(StageTable, ShowsTheSumBesideTheStep) {
  StageRow row{"T1-25", "ours", 300, {}, 0.005};
  row.mean[static_cast<std::size_t>(Stage::Solve)] = 0.003;
  row.mean[static_cast<std::size_t>(Stage::Other)] = 0.001;
  expectTable(stageCsv(std::span(&row, 1)), 1);
  const std::string line = lines(stageText(std::span(&row, 1)))[1];
  std::istringstream cells(line);
  std::string scene, method, step, sum;
  cells >> scene >> method >> step >> sum;
  EXPECT_EQ(step + " " + sum, "5 4");
}

TEST(WakeTable, DividesByThoseAwake) {
  const std::vector<WakeRow> rows = {{0, 60, 0, 1e-6}, {10, 60, 40, 2e-4}};
  expectTable(wakeCsv(rows), 2);
  const auto text = lines(wakeText(rows));
  EXPECT_NE(text[2].find(" 0.2 "), std::string::npos) << text[2];  // ms
  EXPECT_TRUE(text[2].ends_with(" 5")) << text[2];                 // us a ball
}

}  // namespace
}  // namespace wells
