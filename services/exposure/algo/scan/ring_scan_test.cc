#include "services/exposure/algo/scan/ring_scan.h"

#include <gtest/gtest.h>

#include <random>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/text_format_test.h"
#include "services/exposure/algo/scan/coverage_test.h"

namespace slicefarm::exposure::ring_scan_test {
namespace {

ExposureGroup Scan(const MultiPolygon& region, ExposureOptions options, CutCounts* counts = nullptr,
                   int32_t layer = 0) {
  ExposureGroup group;
  CutCounts sum;
  options.strategy = ScanStrategy::kRings;
  EXPECT_TRUE(ScanByRings(region, options, layer, {}, {}, group, sum).ok());
  if (counts != nullptr) *counts = sum;
  return group;
}

TEST(ScanByRings, OneLineAPieceIfLinkedElseOneARing) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 8 0, 8 4, 4 4, 4 8, 0 8)");
  CutCounts counts;
  EXPECT_EQ(Scan(region, {}, &counts).LineCount(), 2u);
  EXPECT_EQ(counts.pieces, 2);
  ExposureOptions options;
  options.link_rings = false;
  const ExposureGroup rings = Scan(region, options);
  EXPECT_GT(rings.LineCount(), 40u);
  rings.ForEachLine([](std::span<const Point> line) {
    EXPECT_TRUE(line.size() == 2 || line.front() == line.back());
  });
}

TEST(ScanByRings, LinksAreShort) {
  ExposureOptions options;
  options.fill_corners = false;
  options.ring_overlap_nm = 0;  // the outermost ring is half a distance inside
  const ExposureGroup group = Scan(MakePolygonsOrDie("(0 0, 8 0, 8 8, 0 8)"), options);
  const double link = 80'000 * std::sqrt(2.0) + 2;
  int short_edges = 0;
  for (size_t i = 1; i < group.points.size(); ++i)
    short_edges += Distance(group.points[i - 1], group.points[i]) <= link ? 1 : 0;
  EXPECT_EQ(short_edges, 49 + 4);  // links of 50 rings, and 4 sides of 80 um of the innermost ring
}

/// Returns the area that a spot can melt without leaving the region: the region's opening by the
/// spot.
MultiPolygon Reachable(const MultiPolygon& region, Coord spot_nm) {
  return OffsetTwice(region, -spot_nm / 2, spot_nm / 2,
                     {.join = Join::kRound, .arc_tolerance_nm = 100});
}

TEST(ScanByRings, CoversWhatTheSpotCanReach) {
  std::mt19937 random(12);
  for (int32_t i = 0; i < 15; ++i) {
    const MultiPolygon region = RandomIsland(random, {}, 5);
    MeltedRaster raster(Reachable(region, 80'000), 11'000);
    Scan(region, {}, nullptr, i).ForEachLine([&](std::span<const Point> line) {
      raster.Add(line, 80'000);
    });
    EXPECT_GE(raster.Share(1), 0.995) << ToText(region);
  }
}

TEST(ScanByRings, CornersStayOpenUnlessTheyAreFilled) {
  const MultiPolygon triangle = MakePolygonsOrDie("(0 0, 4 0, 2 2)");
  double shares[2] = {};
  for (const bool fill : {false, true}) {
    ExposureOptions options;
    options.fill_corners = fill;
    options.turn_rings = false;  // links would melt some corners too
    MeltedRaster raster(Reachable(triangle, 80'000), 7'000);
    Scan(triangle, options).ForEachLine([&](std::span<const Point> line) {
      raster.Add(line, 80'000);
    });
    shares[fill] = raster.Share(1);
  }
  EXPECT_LT(shares[false], 0.995);
  EXPECT_GE(shares[true], 0.998);
}

TEST(ScanByRings, ShortRingsAreLeftOut) {
  ExposureOptions options;
  options.minimum_vector_nm = 3'000'000;
  options.link_rings = false;
  const ExposureGroup group = Scan(MakePolygonsOrDie("(0 0, 8 0, 8 8, 0 8)"), options);
  group.ForEachLine([](std::span<const Point> line) { EXPECT_GE(Length(line), 3e6); });
}

/// Insets of random regions, as in real layers: offsets leave touching rings and short edges.
TEST(ScanByRings, TakesWhateverOffsetsLeave) {
  std::mt19937 random(13);
  for (int i = 0; i < 300; ++i) {
    const MultiPolygon region = FastOffset(RandomIsland(random, {}, Uniform(random, 0.3, 6)),
                                           -static_cast<Coord>(Uniform(random, 1e4, 4e5)));
    ExposureGroup group;
    CutCounts counts;
    ExposureOptions options;
    options.strategy = ScanStrategy::kRingsInward;
    const absl::Status status = ScanByRings(region, options, 0, {}, {}, group, counts);
    ASSERT_TRUE(status.ok()) << status << ToText(region);
    for (const Point p : group.points) {
      if (Inside(p, region)) continue;
      ASSERT_LE(DistanceToBoundary(p, region), 1'000);
    }
  }
}

}  // namespace
}  // namespace slicefarm::exposure::ring_scan_test
