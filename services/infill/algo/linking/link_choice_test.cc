#include "services/infill/algo/linking/link_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <numbers>
#include <random>

#include "common/geometry/text_format_test.h"
#include "services/infill/algo/lines/straight_pieces.h"

namespace slicefarm::infill::link_choice_test {
namespace {

constexpr double kFar = 1e12;
constexpr double kRightAngle = std::numbers::pi / 2;

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

/// Returns the number of paths of linked pieces.
int32_t CountPaths(const EdgeEnds& ends, const Links& links) {
  int32_t loose = 0;
  for (int32_t end = 0; end < ends.size(); ++end)
    loose += LinkedTo(ends, links, end) == kNoEnd ? 1 : 0;
  return loose / 2;
}

/// Returns the number of paths. Checks that each piece is in exactly one path, that there is no
/// ring, and that no end is in two links.
int32_t CheckedPaths(const EdgeEnds& ends, const Links& links) {
  int32_t paths = 0, pieces = 0;
  for (int32_t end = 0; end < ends.size(); ++end) {
    if (ends.IsOnEdge(end) && links[static_cast<size_t>(end)]) {
      EXPECT_FALSE(links[static_cast<size_t>(ends.Next(end))]);
      EXPECT_NE(ends.Next(end), end);
    }
    if (LinkedTo(ends, links, end) != kNoEnd) continue;
    ++paths;  // counted from both ends
    for (int32_t at = end; at != kNoEnd; at = LinkedTo(ends, links, at ^ 1)) ++pieces;
  }
  EXPECT_EQ(pieces, 2 * ends.PieceCount()) << "rings, or pieces in no path";
  EXPECT_EQ(paths / 2, CountPaths(ends, links));
  return paths / 2;
}

int32_t PathsOf(const MultiPolygon& region, std::vector<LineFamily> families,
                double max_link_nm = kFar) {
  const auto pieces = StraightPieces(region, families);
  const EdgeEnds ends(region, *pieces);
  return CheckedPaths(ends, ChooseLinks(ends, max_link_nm));
}

/// Returns the least number of paths, by testing all choices of links.
int32_t FewestPaths(const EdgeEnds& ends) {
  const std::vector<int32_t>& all = ends.OnEdge();
  int32_t fewest = std::numeric_limits<int32_t>::max();
  for (uint32_t chosen = 0; chosen < (1u << all.size()); ++chosen) {
    Links links(static_cast<size_t>(ends.size()), false);
    for (size_t i = 0; i < all.size(); ++i)
      links[static_cast<size_t>(all[i])] = ((chosen >> i) & 1) != 0;
    const bool valid = std::none_of(all.begin(), all.end(), [&](int32_t end) {
      return links[static_cast<size_t>(end)] &&
             (links[static_cast<size_t>(ends.Next(end))] || ends.Next(end) == end);
    });
    if (!valid) continue;
    int32_t pieces = 0;
    for (int32_t end = 0; end < ends.size(); ++end) {
      if (LinkedTo(ends, links, end) != kNoEnd) continue;
      for (int32_t at = end; at != kNoEnd; at = LinkedTo(ends, links, at ^ 1)) ++pieces;
    }
    if (pieces == 2 * ends.PieceCount()) fewest = std::min(fewest, CountPaths(ends, links));
  }
  return fewest;
}

TEST(LinkChoice, ZigzagThroughAConvexRegionIsOnePath) {
  for (const char* text : {"(0 0, 10 0, 10 10, 0 10)", "(0 0, 10 0, 14 5, 9 12, 1 9)"})
    for (const double angle : {0.0, 0.3, 0.8, 1.9})
      EXPECT_EQ(PathsOf(P(text), {{angle, 0.5e6, 1e6}}), 1) << text << ' ' << angle;
}

// The test covers all positions of the grid: the shortest links alone would leave one path per
// direction around the square.
TEST(LinkChoice, GridThroughASquareDoesNotDependOnItsPhase) {
  int32_t most = 0, total = 0;
  for (int i = 0; i < 20; ++i) {
    const double phase = i * 0.2e6;
    const int32_t paths =
        PathsOf(P("(0 0, 80 0, 80 80, 0 80)"),
                {{kRightAngle / 2, phase, 4e6}, {-kRightAngle / 2, 0.37 * phase, 4e6}});
    most = std::max(most, paths), total += paths;
  }
  EXPECT_LE(most, 4);
  EXPECT_LE(total, 40);
}

TEST(LinkChoice, LinksAreNoLongerThanAllowed) {
  const MultiPolygon wedge = P("(0 0, 20 0, 14 6, 0 6)");  // steps of 1 on the left, 1.41 right
  EXPECT_EQ(PathsOf(wedge, {{0, 0.5e6, 1e6}}, 0), 6);
  EXPECT_EQ(PathsOf(wedge, {{0, 0.5e6, 1e6}}, 1.2e6), 3);
  EXPECT_EQ(PathsOf(wedge, {{0, 0.5e6, 1e6}}, 1.5e6), 1);
}

// The number of pieces is small, so that all choices can be tested. The search is not exact: it may
// sometimes need one path more.
TEST(LinkChoice, IsNearTheBestChoice) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> phase(0, 5e6), angle(0, 3);
  const MultiPolygon region = P("(0 0, 20 0, 20 10, 0 10) (6 3, 6 6, 13 6, 13 3)");
  int32_t found = 0, fewest = 0;
  for (int i = 0; i < 60; ++i) {
    const double a = angle(random);
    const LineFamily families[] = {{a, phase(random), 7e6}, {a + 1.2, phase(random), 9e6}};
    const auto pieces = StraightPieces(region, families);
    const EdgeEnds ends(region, *pieces);
    if (ends.size() > 18) continue;
    found += CheckedPaths(ends, ChooseLinks(ends, kFar));
    fewest += FewestPaths(ends);
  }
  EXPECT_GE(fewest, 20);
  EXPECT_LE(found, fewest + fewest / 10);
}

TEST(LinkChoice, NothingOfNothing) {
  const MultiPolygon none;
  const EdgeEnds ends(none, {});
  EXPECT_TRUE(ChooseLinks(ends, kFar).empty());
}

}  // namespace
}  // namespace slicefarm::infill::link_choice_test
