#include "services/milling/algo/motion/stock_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "services/milling/algo/sample_jobs_test.h"

namespace slicefarm::milling::stock_map_test {
namespace {

/// Returns a job with stock of 20 x 20 mm, 10 mm high, around a low plate.
MillingJob WideJob(std::string_view cutter) {
  MillingOptions options = OptionsFor(cutter);
  options.stock_margin_mm = 1;
  MillingJob job = JobOf(Pillars{.heights = {{9}}, .side = 18}.Mesh(), options);
  EXPECT_EQ(job.stock_box.max().z(), 10);
  return job;
}

/// A groove 2 mm deep has the volume of its cross section times its length, plus the ends.
TEST(StockMap, TakesTheVolumeOfAWay) {
  const double length = 10;
  struct Case {
    const char* cutter;
    double volume;
  };
  const double pi = std::numbers::pi;
  for (const Case& c : {
           Case{"cyl:4", 4 * length * 2 + pi * 4 * 2},
           Case{"ball:4", pi * 2 * length + 2 * pi * 8 / 3},
           Case{"cone:4:45", 4 * length + pi * 8 / 3},
       }) {
    StockMap stock(WideJob(c.cutter), 0.05);
    stock.Cut({4, 9, 8}, {4 + length, 9, 8});
    EXPECT_NEAR(stock.removed_mm3(), c.volume, 0.01 * c.volume) << c.cutter;
    stock.Cut({4 + length, 9, 8}, {4, 9, 8});
    EXPECT_NEAR(stock.removed_mm3(), c.volume, 0.01 * c.volume) << c.cutter << ", twice";
  }
}

/// A sloping move removes the same volume after turning by 90 degrees and mirroring. The volume is
/// between the volumes of a level move at its higher end and of a level move at its lower end.
TEST(StockMap, TakesSlopes) {
  for (const std::string_view text : {"cyl:4", "ball:4", "bull:4:1"}) {
    const MillingJob job = WideJob(text);
    StockMap along(job, 0.05), across(job, 0.05), low(job, 0.05), high(job, 0.05);
    along.Cut({4, 9, 9}, {14, 9, 7});
    across.Cut({9, 4, 9}, {9, 14, 7});
    low.Cut({4, 9, 7}, {14, 9, 7});
    high.Cut({4, 9, 9}, {14, 9, 9});
    EXPECT_NEAR(along.removed_mm3(), across.removed_mm3(), 1e-3 * along.removed_mm3());
    EXPECT_LT(along.removed_mm3(), low.removed_mm3());
    EXPECT_GT(along.removed_mm3(), high.removed_mm3());
  }
}

TEST(StockMap, TellsWhereTheCutterRests) {
  StockMap stock(WideJob("cyl:4"), 0.1);
  EXPECT_NEAR(stock.RestHeight({9, 9}, 0.1), 10, 1e-5);
  EXPECT_EQ(stock.RestHeight({-4, 9}, 0.1), 0);
  stock.Cut({9, 9, 12}, {9, 9, 6});
  EXPECT_NEAR(stock.RestHeight({9, 9}, -0.2), 6, 1e-5);
  EXPECT_NEAR(stock.RestHeight({9, 9}, 0.3), 10, 1e-5);  // the wall of the hole
  EXPECT_FALSE(stock.Meets({9, 9, 6}, -0.2));
  EXPECT_TRUE(stock.Meets({9, 9, 5.9}, -0.2));
  EXPECT_NEAR(stock.RestHeightOver({-5, 9}, {30, 9}), 10, 1e-5);
  EXPECT_EQ(stock.RestHeightOver({-5, -5}, {30, -5}), 0);
}

TEST(StockMap, BeginsAsTheStockOfAMesh) {
  const Pillars cast{.heights = {{4, 4}, {4, 7}}, .side = 9};
  auto job = PrepareMilling(Pillars{.heights = {{3}}, .side = 18}.Mesh(), cast.Mesh(),
                            OptionsFor("cyl:2"));
  ASSERT_TRUE(job.ok()) << job.status();
  const StockMap stock(*job, 0.1);
  EXPECT_NEAR(stock.RestHeight({4, 4}, 0), 4, 1e-5);
  EXPECT_NEAR(stock.RestHeight({13, 13}, 0), 7, 1e-5);
}

}  // namespace
}  // namespace slicefarm::milling::stock_map_test
