#include "services/beading/algo/arachne/small_fills.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "common/geometry/text_format_test.h"
#include "services/beading/algo/skeleton/centrality.h"
#include "services/beading/algo/strategy/strategy_factory.h"

namespace slicefarm::beading::small_fills_test {
namespace {

/// Returns true if the infill's parts of a region are too small. Beads are 0.4 mm wide, the inner
/// ones up to 0.8 mm or `max_width_nm`.
bool IsSmall(const std::string& region, int max_walls, Coord max_width_nm = 800'000) {
  StrategyOptions options;
  options.max_walls = max_walls;
  options.max_width_nm = max_width_nm;
  const auto strategy = MakeStrategy(options);
  const auto graph =
      MakeSkeletalGraph(*MakeBoundary(MakePolygonsOrDie(region)[0]), {.step_nm = 200'000});
  const std::vector<char> central = CentralEdges(*graph, {});
  std::vector<int> counts(central.size(), -1);
  for (size_t edge = 0; edge < counts.size(); ++edge) {
    const int half = static_cast<int>(2 * edge);
    const double thickness = graph->FromNode(half).radius + graph->ToNode(half).radius;
    if (central[edge]) counts[edge] = strategy->OptimalCount(std::llround(thickness));
  }
  const std::vector<char> small = SmallFills(*strategy, *graph, counts);
  EXPECT_EQ(small.size(), graph->nodes.size());
  for (size_t node = 0; node < small.size(); ++node)
    EXPECT_FALSE(small[node] && graph->nodes[node].radius < 0.4e6 * max_walls) << node;
  return std::ranges::any_of(small, [](char is) { return is; });
}

struct BoxCase {
  std::string name;
  int max_walls;
  double x_mm, y_mm;
  bool small;
};
class Boxes : public testing::TestWithParam<BoxCase> {};

TEST_P(Boxes, AreLeftToTheWallsBelowTheLeastArea) {
  const std::string x = std::to_string(GetParam().x_mm), y = std::to_string(GetParam().y_mm);
  EXPECT_EQ(IsSmall("(0 0, " + x + " 0, " + x + " " + y + ", 0 " + y + ")", GetParam().max_walls),
            GetParam().small);
}

// Three walls on each side reduce the size by 2.4 mm: 0.5 mm times 0.9 or 1.1 mm remain.
INSTANTIATE_TEST_SUITE_P(SmallFills, Boxes,
                         testing::Values(BoxCase{"Square", 3, 3, 3, true},
                                         BoxCase{"BelowTheLeastArea", 3, 3.3, 2.9, true},
                                         BoxCase{"AboveTheLeastArea", 3, 3.5, 2.9, false},
                                         BoxCase{"NothingLeft", 3, 9, 2.7, false},
                                         BoxCase{"WiderThanWallsReach", 2, 2.5, 2.5, false},
                                         BoxCase{"TwoWalls", 2, 2.2, 2.2, true},
                                         BoxCase{"TheOuterWallStays", 1, 1.4, 1.4, false},
                                         BoxCase{"AsManyWallsAsFit", 0, 3, 3, false}),
                         [](const auto& info) { return info.param.name; });

TEST(SmallFills, WallsReachAsFarAsTheyMayBeWide) {
  const std::string square = "(0 0, 3 0, 3 3, 0 3)";
  EXPECT_TRUE(IsSmall(square, 3, 560'000));
  EXPECT_FALSE(IsSmall(square, 3, 540'000));
}

// The parts in one region would be large enough together, but each one alone is too small.
TEST(SmallFills, PlacesCountOneByOne) {
  EXPECT_TRUE(
      IsSmall("(0 0, 2.9 0, 2.9 1.25, 6 1.25, 6 0, 8.9 0, 8.9 2.9, 6 2.9, 6 1.65, 2.9 1.65, "
              "2.9 2.9, 0 2.9)",
              3));
}

}  // namespace
}  // namespace slicefarm::beading::small_fills_test
