#include "services/infill/algo/skins/overhang_fill.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/text_format_test.h"
#include "common/model/bead_section.h"

namespace slicefarm::infill::overhang_fill_test {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

/// Returns the area that the beads cover.
MultiPolygon Covered(const FillGroup& group) {
  std::vector<Polyline> lines;
  for (const Path& path : group.paths) {
    lines.push_back(path.points);
    if (path.closed) lines.back().push_back(path.points.front());
  }
  return OffsetLines(lines, group.paths.front().widths_nm[0] / 2, Cap::kRound);
}

struct OverhangCase {
  std::string name;
  std::string region;
  std::string below;
};

class FillOverhangTest : public testing::TestWithParam<OverhangCase> {
 protected:
  const PolygonWithHoles region_ = P(GetParam().region)[0];
  const MultiPolygon below_ = P(GetParam().below);
  const OverhangFill fill_{.overlap_nm = 100'000};
  const FillGroup group_ = FillOverhang(region_, below_, fill_);
};

TEST_P(FillOverhangTest, CoversTheRegionAndStaysInIt) {
  ASSERT_FALSE(group_.paths.empty());
  const MultiPolygon covered = Covered(group_);
  EXPECT_GT(Area(Intersection(covered, {region_})), 0.95 * Area(region_));
  EXPECT_LT(Area(Difference(covered, Offset({region_}, 110'000))), 1e-3 * Area(region_));
}

/// Returns the distance of a path's point from the area printed before it, without the path's last
/// few millimetres.
double PathToPrinted(const Path& path, size_t point, const MultiPolygon& there) {
  constexpr double kLast = 3e6;
  double route = DistanceToRegion(path.points[point], there), since = 0;
  for (size_t i = point; i-- > 0;) {
    if (since > kLast)
      route = std::min(route,
                       DistanceToSegment(path.points[point], path.points[i], path.points[i + 1]));
    since += Distance(path.points[i], path.points[i + 1]);
  }
  return route;
}

// This is the purpose of the fill: each bead is on the part below or beside an earlier bead. Where
// lines turn, the path's own last millimetres count as the earlier bead.
TEST_P(FillOverhangTest, EachLineLiesBesideWhatIsThere) {
  ASSERT_FALSE(group_.paths.empty());
  MultiPolygon there = below_;
  const auto spacing = static_cast<double>(Spacing(fill_.width_nm, fill_.height_nm));
  for (const Path& path : group_.paths) {
    for (size_t i = 0; i < path.points.size(); ++i)
      EXPECT_LE(PathToPrinted(path, i, there), 2.2 * spacing)
          << ToMm(static_cast<double>(path.points[i].x)) << ' '
          << ToMm(static_cast<double>(path.points[i].y));
    there = Union(there, OffsetLines(std::span(&path.points, 1), fill_.width_nm / 2, Cap::kRound));
  }
}

TEST_P(FillOverhangTest, KeepsItsOrder) {
  EXPECT_TRUE(group_.keep_order);
  EXPECT_TRUE(std::ranges::none_of(group_.paths, [](const Path& path) { return path.reversible; }));
}

INSTANTIATE_TEST_SUITE_P(
    Overhangs, FillOverhangTest,
    testing::Values(
        OverhangCase{"Shelf", "(9 0, 20 0, 20 30, 9 30)", "(0 0, 10 0, 10 30, 0 30)"},
        OverhangCase{"Corner", "(9 -1, 20 -1, 20 20, -1 20, -1 9, 9 9)",
                     "(-5 -5, 10 -5, 10 10, -5 10)"},
        OverhangCase{"RoundAPost", "(-10 -10, 10 -10, 10 10, -10 10)", "(-2 -2, 2 -2, 2 2, -2 2)"},
        OverhangCase{"WithAHole", "(9 0, 30 0, 30 30, 9 30) (15 10, 15 20, 25 20, 25 10)",
                     "(0 0, 10 0, 10 30, 0 30)"}),
    [](const auto& info) { return info.param.name; });

TEST(FillOverhang, OfAShelfIsOnePath) {
  EXPECT_EQ(FillOverhang(P("(9 0, 20 0, 20 30, 9 30)")[0], P("(0 0, 10 0, 10 30, 0 30)"), {})
                .paths.size(),
            1u);
}

TEST(FillOverhang, NothingGrowsFromNothing) {
  const PolygonWithHoles region = P("(0 0, 9 0, 9 9, 0 9)")[0];
  EXPECT_TRUE(FillOverhang(region, {}, {}).paths.empty());
  EXPECT_TRUE(FillOverhang(region, P("(9.5 0, 20 0, 20 9, 9.5 9)"), {}).paths.empty());
}

}  // namespace
}  // namespace slicefarm::infill::overhang_fill_test
