#include "services/infill/algo/solid.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/text_format_test.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/solid_raster_test.h"
#include "services/infill/algo/space_filling/fill_checks_test.h"
#include "tests/corpus_slice.h"

namespace slicefarm::infill::solid_test {
namespace {

PolygonWithHoles Island(std::string_view text) { return MakePolygonsOrDie(text)[0]; }

double VolumeArea(const FillGroup& group, Coord height) {
  double area = 0;
  for (const Path& path : group.paths) {
    if (path.closed)
      area += Distance(path.points.front(), path.points.back()) *
              SectionMm2(path.WidthAt(0), height) * 1e12 / static_cast<double>(height);
    for (size_t i = 1; i < path.points.size(); ++i) {
      const Coord width = (path.WidthAt(i - 1) + path.WidthAt(i)) / 2;
      area += Distance(path.points[i - 1], path.points[i]) * SectionMm2(width, height) * 1e12 /
              static_cast<double>(height);
    }
  }
  return area;
}

struct SolidCase {
  std::string name;
  std::string region;
  double angle_deg;
};
class Solid : public testing::TestWithParam<SolidCase> {};

// The plastic is that of the region. Little is covered twice, almost nothing is empty, and nothing
// is outside except the round ends, which contain no plastic.
TEST_P(Solid, CoversTheRegionOnce) {
  const PolygonWithHoles region = Island(GetParam().region);
  SolidFill fill{.angle_rad = GetParam().angle_deg * std::numbers::pi / 180, .overlap_nm = 112'500};
  const auto group = FillSolid(region, fill);
  ASSERT_TRUE(group.ok());
  const RasterCover cover = CoverOf(group->paths, {region}, fill.height_nm, 20'000, 200'000);
  EXPECT_NEAR(cover.plastic, 1, 0.0125);
  EXPECT_LT(cover.empty, 0.006);
  EXPECT_LT(cover.twice, 0.0195);
  EXPECT_LT(cover.outside, 2e-4);
  const Flow flow = FlowOf(group->paths, fill.height_nm);
  EXPECT_EQ(flow.jumps, 0);
  EXPECT_GT(flow.narrowest_nm, 240'000);
}

/// Returns the areas inside three walls of slices of real parts, without large ones, which take
/// long to measure.
std::vector<PolygonWithHoles> RealFillAreas() {
  constexpr Coord kMost = 80'000'000;
  std::vector<PolygonWithHoles> areas;
  for (const char* name : kCorpusSlices)
    for (PolygonWithHoles& area : FastOffset(CorpusSlice(name), -1'242'000))
      if (const Box box = Bounds({area});
          box.max.x - box.min.x < kMost && box.max.y - box.min.y < kMost)
        areas.push_back(std::move(area));
  return areas;
}

// The test covers all areas, including corners and narrow parts. The flow of lines has no steps,
// and no line is narrower than 0.6 nozzles of 0.4 mm.
TEST(SolidOnParts, CoversThemByAnEvenFlow) {
  double area = 0, empty = 0, twice = 0, outside = 0, plastic = 0;
  for (const FillPattern pattern : {FillPattern::kMonotonic, FillPattern::kRectilinear}) {
    for (const PolygonWithHoles& region : RealFillAreas()) {
      const SolidFill fill{.pattern = pattern, .angle_rad = 0.8, .overlap_nm = 112'500};
      const auto group = FillSolid(region, fill);
      ASSERT_TRUE(group.ok());
      const RasterCover cover = CoverOf(group->paths, {region}, fill.height_nm, 25'000, 200'000);
      const double size = Area(region);
      area += size, empty += cover.empty * size, twice += cover.twice * size;
      outside += cover.outside * size, plastic += cover.plastic * size;
      const Flow flow = FlowOf(group->paths, fill.height_nm);
      EXPECT_LE(flow.jumps, 2 * flow.length_m);
      EXPECT_GE(flow.narrowest_nm, 240'000);
    }
  }
  EXPECT_NEAR(plastic / area, 1, 0.012);
  EXPECT_LT(empty / area, 0.015);
  EXPECT_LT(twice / area, 0.02);
  EXPECT_LT(outside / area, 1e-4);
}

// Links at flat angles, several spacings long, are also made: lines that end on a slope of 10
// degrees are one path, and the plastic is that of the region.
TEST(Solid, LinesEndingOnAFlatSlopeAreLinked) {
  const PolygonWithHoles region = Island("(0 0, 60 0, 60 1, 3 11, 0 11)");
  const auto group = FillSolid(region, {.overlap_nm = 112'500});
  ASSERT_TRUE(group.ok());
  EXPECT_EQ(group->paths.size(), 1u);
  EXPECT_NEAR(VolumeArea(*group, 200'000) / Area(region), 1, 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Solid,
    testing::Values(SolidCase{"SquareStraight", "(0 0, 20 0, 20 20, 0 20)", 0},
                    SolidCase{"SquareSlanted", "(0 0, 20 0, 20 20, 0 20)", 45},
                    SolidCase{"NotAMultiple", "(0 0, 20 0, 20 7.77, 0 7.77)", 0},
                    SolidCase{"WithHole", "(0 0, 20 0, 20 20, 0 20) (6 6, 14 6, 14 14, 6 14)", 45},
                    SolidCase{"Triangle", "(0 0, 20 0, 9 17)", 30},
                    SolidCase{"EllShape", "(0 0, 20 0, 20 6, 6 6, 6 20, 0 20)", 45}),
    [](const auto& info) { return info.param.name; });

struct CurveCase {
  FillPattern pattern;
  const char* region;
  double uncovered;  ///< largest uncovered share of the region
};

// Curves end at the region's edge; straight lines and loops leave almost nothing empty.
TEST(Solid, CurvesFillTheRegion) {
  const CurveCase cases[] = {
      {FillPattern::kAlignedRectilinear, "(0 0, 20 0, 20 20, 0 20)", 0.005},
      {FillPattern::kMonotonicLines, "(0 0, 20 0, 20 20, 0 20)", 0.005},
      {FillPattern::kConcentric, "(0 0, 20 0, 20 20, 0 20)", 0.01},
      {FillPattern::kConcentric, "(0 0, 20 0, 20 7.77, 0 7.77)", 0.01},
      {FillPattern::kArchimedean, "(-10 -10, 10 -10, 10 10, -10 10)", 0.03},
      {FillPattern::kOctagram, "(-10 -10, 10 -10, 10 10, -10 10)", 0.03},
      {FillPattern::kHilbert, "(-10 -10, 10 -10, 10 10, -10 10)", 0.06},
      {FillPattern::kPeano, "(-10 -10, 10 -10, 10 10, -10 10)", 0.05},
  };
  for (const CurveCase& c : cases) {
    const PolygonWithHoles region = Island(c.region);
    const SolidFill fill{.pattern = c.pattern, .overlap_nm = 112'500};
    const auto group = FillSolid(region, fill);
    ASSERT_TRUE(group.ok());
    EXPECT_NEAR(VolumeArea(*group, fill.height_nm) / Area(region), 1, 0.06)
        << InfoOf(c.pattern).name;
    std::vector<Polyline> lines;
    for (const Path& path : group->paths) {
      lines.push_back(path.points);
      if (path.closed) lines.back().push_back(path.points.front());
    }
    const MultiPolygon covered =
        OffsetLines(lines, group->paths[0].widths_nm[0] / 2, Cap::kRound, {.join = Join::kRound});
    EXPECT_LT(Area(Difference({region}, covered)) / Area(region), c.uncovered)
        << InfoOf(c.pattern).name;
  }
}

TEST(SolidGroup, MonotonicLinesAreNotLinked) {
  const auto group =
      FillSolid(Island("(0 0, 20 0, 20 20, 0 20)"), {.pattern = FillPattern::kMonotonicLines});
  EXPECT_TRUE(group->keep_order);
  for (const Path& path : group->paths) EXPECT_EQ(path.points.size(), 2u);
}

// The corner of a letter under its top: no line across it is as long as a bead is wide.
TEST(SolidGroup, ASmallPlaceIsNotLeftOpenAtAnyAngle) {
  for (const char* text : {"(0 0, 1.1 0, 0 1.1)", "(0 0, 0.8 0.1, 0.9 0.9, 0.1 0.7)"}) {
    for (int angle = 0; angle < 180; angle += 5) {
      const auto group = FillSolid(Island(text), {.angle_rad = angle * std::numbers::pi / 180});
      ASSERT_TRUE(group.ok());
      EXPECT_FALSE(group->paths.empty()) << text << " at " << angle;
    }
  }
}

TEST(SolidSpacing, FitsTheRegion) {
  for (double height = 3.0; height < 3.5; height += 0.05) {
    const Coord h = FromMm(height);
    const PolygonWithHoles region{{{0, 0}, {10'000'000, 0}, {10'000'000, h}, {0, h}}, {}};
    const auto group = FillSolid(region, {});
    ASSERT_TRUE(group.ok());
    const auto spacing = static_cast<double>(Spacing(group->paths[0].widths_nm[0], 200'000));
    const double count = static_cast<double>(h) / spacing;
    EXPECT_NEAR(count, std::round(count), 1e-4) << height;
  }
}

TEST(SolidGroup, MonotonicKeepsItsOrder) {
  const PolygonWithHoles region = Island("(0 0, 20 0, 20 20, 0 20) (6 6, 14 6, 14 14, 6 14)");
  EXPECT_TRUE(FillSolid(region, {.pattern = FillPattern::kMonotonic})->keep_order);
  EXPECT_FALSE(FillSolid(region, {.pattern = FillPattern::kRectilinear})->keep_order);
}

// Beside a flat slope, strips are as wide as the free space; threads in the air are not.
TEST(SolidGroup, BridgesHaveEvenLines) {
  const PolygonWithHoles region = Island("(0 0, 60 0, 60 1, 3 11, 0 11)");
  const auto widths = [&](Feature feature) {
    const auto group =
        FillSolid(region, {.feature = feature, .pattern = FillPattern::kMonotonicLines});
    std::set<Coord> all;
    for (const Path& path : group->paths) all.insert(path.widths_nm.begin(), path.widths_nm.end());
    return all;
  };
  EXPECT_EQ(widths(Feature::kBridgeInfill).size(), 1u);
  EXPECT_GT(widths(Feature::kSolidInfill).size(), 1u);
}

// The areas that support threads in the air are beside the threads.
TEST(SolidGroup, AnchoredLinesEndOnTheEdge) {
  const PolygonWithHoles region = Island("(0 0, 20 0, 20 10, 0 10)");
  SolidFill fill{.feature = Feature::kBridgeInfill,
                 .pattern = FillPattern::kRectilinear,
                 .overlap_nm = 110'000};
  const auto box_of = [&] {
    Box box;
    const auto group = FillSolid(region, fill);
    EXPECT_TRUE(group.ok()) << group.status();
    for (const Path& path : group->paths) box.Add(Bounds(path.points));
    return box;
  };
  const Box plain = box_of();
  EXPECT_GT(plain.min.x, FromMm(0.01));
  fill.anchored = true;
  const Box anchored = box_of();
  EXPECT_EQ(anchored.min.x, 0);
  EXPECT_EQ(anchored.max.x, FromMm(20));
  // Lines along the edge are still side by side with the wall.
  EXPECT_EQ(anchored.min.y, plain.min.y);
  EXPECT_EQ(anchored.max.y, plain.max.y);
}

// Loops and turns are printed from the middle to the edge, or in the opposite order.
TEST(SolidGroup, SurfacesWithAMiddleHaveAnOrder) {
  const PolygonWithHoles region = Island("(20 20, 34 20, 34 34, 20 34)");
  for (const FillPattern pattern :
       {FillPattern::kConcentric, FillPattern::kArchimedean, FillPattern::kOctagram}) {
    SolidFill fill{.pattern = pattern, .center = std::nullopt};
    ASSERT_TRUE(HasMiddle(pattern));
    EXPECT_FALSE(FillSolid(region, fill)->keep_order);
    fill.order = FillOrder::kOutward;
    const auto outward = FillSolid(region, fill);
    ASSERT_TRUE(outward.ok());
    EXPECT_TRUE(outward->keep_order);
    ASSERT_GT(outward->paths.size(), 4u);
    const Point middle{27'000'000, 27'000'000};
    const auto from_middle = [&](const Path& path) {
      double nearest = 1e9;
      for (const Point p : path.points) nearest = std::min(nearest, Distance(p, middle) / 1e6);
      return nearest;
    };
    EXPECT_LT(from_middle(outward->paths.front()), 1.0);
    EXPECT_GT(from_middle(outward->paths.back()), 5.0);
    // A turn of the octagram has inner corners; its parts may be half a millimetre nearer.
    for (size_t i = 1; i < outward->paths.size(); ++i)
      EXPECT_GT(from_middle(outward->paths[i]), from_middle(outward->paths[i - 1]) - 1.0) << i;
    fill.order = FillOrder::kInward;
    const auto inward = FillSolid(region, fill);
    ASSERT_EQ(inward->paths.size(), outward->paths.size());
    EXPECT_LT(from_middle(inward->paths.back()), 1.0);
    for (const Path& path : inward->paths) EXPECT_EQ(path.reversible, path.closed);
  }
}

// A spiral turns around the object's origin, or around the middle of the region.
TEST(SolidGroup, SpiralsHaveTheirMiddle) {
  const PolygonWithHoles region = Island("(20 20, 30 20, 30 30, 20 30)");
  const auto at = [&](std::optional<Point> center) {
    return *FillSolid(region, {.pattern = FillPattern::kArchimedean, .center = center});
  };
  const PolygonWithHoles centred = Island("(-5 -5, 5 -5, 5 5, -5 5)");
  const FillGroup around = *FillSolid(centred, {.pattern = FillPattern::kArchimedean});
  EXPECT_EQ(at(std::nullopt).paths.size(), around.paths.size());
  EXPECT_EQ(at(std::nullopt).paths.front().points.front(),
            around.paths.front().points.front() + Point(25'000'000, 25'000'000));
  EXPECT_EQ(at(std::nullopt), at(Point{25'000'000, 25'000'000}));
  EXPECT_NE(at(std::nullopt), at(Point{}));
}

TEST(SolidGroup, LinesRunAtTheAngle) {
  const PolygonWithHoles region = Island("(0 0, 20 0, 20 20, 0 20)");
  const auto along = FillSolid(region, {.angle_rad = 0});
  const auto across = FillSolid(region, {.angle_rad = std::numbers::pi / 2});
  EXPECT_EQ(along->paths[0].points[0].y, along->paths[0].points[1].y);
  EXPECT_EQ(across->paths[0].points[0].x, across->paths[0].points[1].x);
}

}  // namespace
}  // namespace slicefarm::infill::solid_test
