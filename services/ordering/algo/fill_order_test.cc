#include "services/ordering/algo/fill_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/model/paths_test.h"

namespace slicefarm::ordering::fill_order_test {
namespace {

using ::testing::ElementsAre;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

Path Line(std::string_view points, bool reversible = true) {
  Path path = MakePathOrDie(points);
  path.feature = Feature::kInternalInfill;
  path.reversible = reversible;
  return path;
}

/// Returns the starts of the paths as printed from `from`. The paths of each inner vector are one
/// block.
std::vector<Point> Starts(std::vector<std::vector<Path>> groups, Point from,
                          std::optional<Point> next = {}) {
  std::vector<FillBlock> blocks;
  for (auto& group : groups) {
    blocks.emplace_back();
    for (Path& path : group) blocks.back().paths.push_back(&path);
  }
  Route route(from);
  WorkBudget budget{10'000};
  PrintFills(std::move(blocks), next, route, budget);
  std::vector<Point> starts;
  for (const Path& path : route.paths()) starts.push_back(path.points[0]);
  return starts;
}

TEST(PrintFills, Zigzags) {
  EXPECT_THAT(Starts({{Line("(0 2, 9 2)")}, {Line("(0 0, 9 0)")}, {Line("(0 1, 9 1)")}}, Mm(0, 0)),
              ElementsAre(Mm(0, 0), Mm(9, 1), Mm(0, 2)));
}

TEST(PrintFills, ABlockStaysInOrder) {
  const std::vector<Path> block = {Line("(0 0, 9 0)"), Line("(9 1, 0 1)"), Line("(0 2, 9 2)")};
  EXPECT_THAT(Starts({block}, Mm(0, 0)), ElementsAre(Mm(0, 0), Mm(9, 1), Mm(0, 2)));
  EXPECT_THAT(Starts({block}, Mm(9, 3)), ElementsAre(Mm(0, 0), Mm(9, 1), Mm(0, 2)));
}

TEST(PrintFills, AOneWayPathIsNotTurned) {
  EXPECT_THAT(Starts({{Line("(0 0, 9 0)")}}, Mm(9, 1)), ElementsAre(Mm(9, 0)));
  EXPECT_THAT(Starts({{Line("(0 0, 9 0)", /*reversible=*/false)}}, Mm(9, 1)),
              ElementsAre(Mm(0, 0)));
}

TEST(PrintFills, LoopsStartNearTheNozzle) {
  Path loop = Line("(0 0, 9 0, 9 9, 0 9)");
  loop.closed = true;
  EXPECT_THAT(Starts({{loop}}, Mm(8, 10)), ElementsAre(Mm(9, 9)));
}

TEST(PrintFills, EndsTowardsWhatComesNext) {
  const std::vector<std::vector<Path>> dots = {{Line("(10 0, 10 1)")}, {Line("(30 0, 30 1)")}};
  EXPECT_EQ(Starts(dots, Mm(20, 0), Mm(40, 0)).front().x, FromMm(10));
  EXPECT_EQ(Starts(dots, Mm(20, 0), Mm(0, 0)).front().x, FromMm(30));
}

}  // namespace
}  // namespace slicefarm::ordering::fill_order_test
