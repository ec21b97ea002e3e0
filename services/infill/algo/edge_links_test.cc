#include "services/infill/algo/edge_links.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "common/geometry/text_format.h"
#include "common/model/paths_test.h"

namespace slicefarm::infill {
namespace {

constexpr double kFar = 1e12;

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

std::vector<ScanLines> Families(const MultiPolygon& region, std::vector<LineFamily> families) {
  std::vector<ScanLines> lines;
  for (const LineFamily& family : families) lines.push_back(*CutLines(region, family));
  return lines;
}

TEST(EdgeLinks, ZigzagThroughASquareIsOnePath) {
  const MultiPolygon square = P("(0 0, 10 0, 10 10, 0 10)");
  const auto families = Families(square, {{0, 0.5e6, 1e6}});
  const auto paths = LinkAlongEdge(families, {.max_link_nm = 3e6, .link_budget_nm = kFar});
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_NEAR(TotalMm(paths), 109, 1e-6);
}

TEST(EdgeLinks, GridJoinsItsTwoFamilies) {
  const MultiPolygon square = P("(0 0, 10 0, 10 10, 0 10)");
  const double quarter = std::numbers::pi / 4;
  const auto families = Families(square, {{quarter, 0.3e6, 2e6}, {-quarter, 0.1e6, 2e6}});
  const size_t pieces = families[0].PieceCount() + families[1].PieceCount();
  EXPECT_EQ(LinkAlongEdge(families, {.max_link_nm = 0}).size(), pieces);
  EXPECT_LE(LinkAlongEdge(families, {.max_link_nm = 3e6, .link_budget_nm = kFar}).size(), 3u);
}

TEST(EdgeLinks, NeverMakeARing) {
  // Two lines could be joined at both sides.
  const MultiPolygon strip = P("(0 0, 10 0, 10 2, 0 2)");
  const auto families = Families(strip, {{0, 0.5e6, 1e6}});
  const auto paths = LinkAlongEdge(families, {.max_link_nm = 30e6, .link_budget_nm = kFar});
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_NEAR(TotalMm(paths), 21, 1e-6);
}

TEST(EdgeLinks, BudgetBuysTheShortestFirst) {
  const MultiPolygon wedge =
      P("(0 0, 20 0, 14 6, 0 6)");  // steep on the left, slanted on the right
  const auto families = Families(wedge, {{0, 0.5e6, 1e6}});
  const auto paths = LinkAlongEdge(families, {.max_link_nm = 3e6, .link_budget_nm = 3.5e6});
  double pieces = 0;
  for (int i = 0; i < 6; ++i) pieces += 20 - 0.5 - i;
  EXPECT_NEAR(TotalMm(paths), pieces + 3, 1e-6);  // three on the left, at 1 mm each
  EXPECT_EQ(paths.size(), 3u);
}

TEST(EdgeLinks, LinksGoAroundCorners) {
  const MultiPolygon region = P("(0 0, 10 0, 11 1, 10 2, 0 2)");
  const auto families = Families(region, {{0, 0.5e6, 1e6}});
  const auto paths = LinkAlongEdge(families, {.max_link_nm = 1.6e6, .link_budget_nm = kFar});
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_NEAR(TotalMm(paths), 21 + 1, 1e-6);  // the straight side is the shorter way
  const MultiPolygon pointed = P("(0 0, 10 0, 11 1, 10 2, 0 2, -2 1)");
  const auto around = Families(pointed, {{0, 0.5e6, 1e6}});
  const auto path = LinkAlongEdge(around, {.max_link_nm = 1.6e6, .link_budget_nm = kFar});
  ASSERT_EQ(path.size(), 1u);
  EXPECT_TRUE(std::count(path[0].begin(), path[0].end(), Point{11'000'000, 1'000'000}));
}

// Whatever the region: every piece is there once, and links are what the paths have beyond them.
TEST(EdgeLinks, PiecesAndLinksAddUp) {
  const MultiPolygon region = P(
      "(0 0, 20 0, 20 10, 0 10) (3 3, 6 3, 6 6, 3 6) (9 1, 11 1, 11 9, 9 9) ; (30 0, 40 3, 31 9)");
  for (const double angle : {0.0, 0.5, 1.2}) {
    const auto families = Families(region, {{angle, 0, 1.1e6}, {angle + 1.5, 0, 1.3e6}});
    double pieces = 0;
    for (const ScanLines& lines : families) pieces += lines.TotalLength();
    const auto loose = LinkAlongEdge(families, {.max_link_nm = 0});
    EXPECT_NEAR(TotalMm(loose), pieces / kNmPerMm, 1e-3);
    const auto joined = LinkAlongEdge(families, {.max_link_nm = 2e6, .link_budget_nm = 9e6});
    EXPECT_LT(joined.size(), loose.size());
    EXPECT_GT(TotalMm(joined), TotalMm(loose));
    EXPECT_LE(TotalMm(joined), TotalMm(loose) + 9 + 1e-3);
  }
}

TEST(EdgeLinks, NothingOfNothing) {
  EXPECT_TRUE(LinkAlongEdge({}, {}).empty());
  const MultiPolygon none;
  EXPECT_TRUE(LinkAlongEdge(Families(none, {{0, 0, 1e6}}), {}).empty());
}

}  // namespace
}  // namespace slicefarm::infill
