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

/// Some methods in rounds.
class SpeedTables : public testing::Test {
 protected:
  SpeedTables() {
    BenchResult bullet = kept();
    bullet.books.reset();
    bullet.end.ballOverlap = 0.111;
    bullet.end.escaped = 3;
    const BenchRow ours = rowOf(kept());
    result_ = {&findSpeedScene("T1-10000"), 300, 5, {}};
    result_.rows = {{{.engine = "bullet"}, {80, 82, 160}, rowOf(bullet)},
                    {{}, {8, 8, 8}, ours},
                    {{.threads = 2}, {4, 5, 8}, ours},
                    {{.substeps = 3, .iterations = 2, .ballBound = 0.0420}, {6, 6, 6}, ours}};
  }

  /// Of a world that keeps all bounds, those of stock Bullet at least.
  static BenchResult kept() {
    BenchResult result;
    result.scene = "T1";
    result.memory = 10000 * 512 / (1024.0 * 1024);
    result.start.potentialEnergy = -1e6;
    result.end.potentialEnergy = -2e6;
    result.end.ballOverlap = 0.0421;
    result.books.emplace();
    return result;
  }

  BenchRow rowOf(const BenchResult& result) const {
    std::ofstream(folder_ / "row.csv") << csvHeader() << '\n' << csvRow(result) << '\n';
    return BenchRow(folder_ / "row.csv");
  }

  bool keeps(const BenchResult& result) const {
    return keepsBounds(result_, {{}, {}, rowOf(result)});
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
  EXPECT_NE(text[2].find(" 3 "), std::string::npos) << text[2];
  for (const char* part : {"ours ", " 8 ", "10.2 (10..20)", "0.0421", " 0.111 ", " pass ", " 512 "})
    EXPECT_NE(text[3].find(part), std::string::npos) << part << " in " << text[3];
  EXPECT_NE(text[4].find("1.6 (1..2)"), std::string::npos) << text[4];
  for (const char* part : {"ours 3x2", " 0.042 ", " FAIL "})
    EXPECT_NE(text[5].find(part), std::string::npos) << part << " in " << text[5];
}

TEST_F(SpeedTables, SayWhatIsLeftOut) {
  for (SpeedRow& row : result_.rows) row = {row.method};
  EXPECT_EQ(lines(speedText(result_)).size(), 1u);
  EXPECT_NE(speedText(result_).find("T1-10000: left out"), std::string::npos);
  expectTable(speedCsv(std::span(&result_, 1)), 0);
}

TEST_F(SpeedTables, PassWhatKeepsEveryBound) {
  EXPECT_TRUE(keeps(kept()));
  BenchResult result = kept();
  result.end.ballOverlap = 0.1111;  // deeper than Bullet's
  EXPECT_FALSE(keeps(result));
  result = kept();
  result.end.groundOverlap = 0.0121;
  EXPECT_FALSE(keeps(result));
  result = kept();
  result.end.wallOverlap = 0.0121;
  EXPECT_FALSE(keeps(result));
  result = kept();
  result.end.escaped = 1;
  EXPECT_FALSE(keeps(result));
  result = kept();
  result.books->contacts = 1e-12 * 2e6 * 300;  // rounding of 300 steps
  EXPECT_TRUE(keeps(result));
  result.books->contacts *= 1.1;
  EXPECT_FALSE(keeps(result));
}

TEST_F(SpeedTables, PlotEachMethodThatRanAndTheLineOf60Hz) {
  const std::string script = speedScript(std::span(&result_, 1));
  for (const char* part :
       {"title 'stock Bullet'", "title 'ours'", "title 'ours on 2 threads'", "title 'ours, tuned'",
        "'|T1-10000 ours 3x2|'", "1000.0/60", "set logscale xy"})
    EXPECT_NE(script.find(part), std::string::npos) << part;
}

TEST(SpeedPlan, NamesMethodsAndAsksForThem) {
  SpeedMethod method;
  EXPECT_EQ(name(method), "ours");
  EXPECT_EQ(arguments(method), (std::vector<std::string>{"--engine", "ours"}));
  method = {.substeps = 4, .iterations = 1, .threads = 2};
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
  double time = 0;  // s, of a round
  for (const SpeedScene& scene : speedScenes()) {
    EXPECT_NO_THROW(findScene(scene.scene)) << scene.name;
    time += scene.roundTime;
    const auto methods = speedMethods(scene, std::vector<std::int64_t>{1, 2});
    EXPECT_TRUE(methods.front().isBullet());
    EXPECT_EQ(methods[1], SpeedMethod{});
    EXPECT_EQ(methods[2].threads, 2);
  }
  const SpeedOptions options;
  EXPECT_LE(time * static_cast<double>(options.repeats), options.minutes * 60);
}

TEST(FeatureTable, SaysWhatIsFree) {
  FeatureRow row;
  row.scene = "T1, 1,000";
  row.unused = {1.02, 1.0, 1.3};
  FeatureRow dear = row;
  dear.unused->median = 1.021;
  FeatureRow none = row;
  none.unused.reset();
  const std::vector<FeatureRow> rows = {row, dear, none};
  expectTable(featureCsv(rows), 3);
  const auto text = lines(featureText(rows));
  ASSERT_EQ(text.size(), 4u);
  EXPECT_NE(text[1].find("1.020 (1.000..1.300) pass"), std::string::npos) << text[1];
  EXPECT_NE(text[2].find("1.021 (1.000..1.300) FAIL"), std::string::npos) << text[2];
  for (const char* verdict : {"pass", "FAIL"})
    EXPECT_EQ(text[3].find(verdict), std::string::npos) << text[3];
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
