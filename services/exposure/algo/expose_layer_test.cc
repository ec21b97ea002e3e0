#include "services/exposure/algo/expose_layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "common/base/error.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/text_format_test.h"
#include "services/exposure/algo/scan/coverage_test.h"

namespace slicefarm::exposure::expose_layer_test {
namespace {

const ScanStrategy kStrategies[] = {ScanStrategy::kRings, ScanStrategy::kRingsInward,
                                    ScanStrategy::kStripes, ScanStrategy::kIslands,
                                    ScanStrategy::kHatch};

SlicedLayer LayerOf(MultiPolygon outlines, int32_t index = 0, int32_t object = 0) {
  ObjectSection section{.stack = object,
                        .layer = index,
                        .layer_count = 100,
                        .height_nm = 50'000,
                        .regions = {{.outlines = std::move(outlines)}},
                        .whole = {},
                        .z_nm = 0,
                        .marks = {}};
  return {{index, (index + 1) * 50'000, 50'000}, {std::move(section)}};
}

absl::StatusOr<ExposedLayer> Expose(const std::vector<SlicedLayer>& layers, size_t which,
                                    const std::vector<ExposureOptions>& regions,
                                    std::vector<Copy> copies = {{}}) {
  return ExposeLayer(layers[which], ObjectLayers(layers), regions, copies, {});
}

ExposedLayer ExposeOrDie(const MultiPolygon& outlines, const ExposureOptions& options,
                         int32_t index = 0) {
  const std::vector<SlicedLayer> layers = {LayerOf(outlines, index)};
  auto layer = Expose(layers, 0, {options});
  EXPECT_TRUE(layer.ok()) << layer.status();
  return layer.ok() ? *std::move(layer) : ExposedLayer{};
}

template <typename Visit>
void ForEachLineOf(const ExposedLayer& layer, ExposureKind kind, Visit visit) {
  for (const ExposureGroup& group : layer.groups)
    if (group.kind == kind) group.ForEachLine(visit);
}

double KindLengthMm(const ExposedLayer& layer, ExposureKind kind) {
  double length = 0;
  ForEachLineOf(layer, kind,
                [&](std::span<const Point> line) { length += Length(line) / kNmPerMm; });
  return length;
}

const char kPart[] = "(0 0, 12 0, 12 9, 7 9, 6 4, 5 9, 0 8) (2 2, 3 5, 4 2)";

TEST(ExposeLayer, ContoursLieWhereCompensationSaysAndInOrder) {
  ExposureOptions options;
  options.contours = 3;
  const ExposedLayer layer = ExposeOrDie(MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)"), options);
  ASSERT_FALSE(layer.groups.empty());
  const ExposureGroup& contours = layer.groups[0];
  EXPECT_EQ(contours.kind, ExposureKind::kContour);
  std::vector<Coord> left;
  contours.ForEachLine([&](std::span<const Point> line) {
    EXPECT_EQ(line.front(), line.back());
    left.push_back(Bounds(line).min.x);
  });
  EXPECT_EQ(left, (std::vector<Coord>{200'000, 120'000, 40'000}));

  options.contours_first = false;
  EXPECT_EQ(ExposeOrDie(MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)"), options).groups.back().kind,
            ExposureKind::kContour);
}

/// A raster of points measures the share that the spot melts of the area that it can reach.
TEST(ExposeLayer, TheRegionIsCovered) {
  const MultiPolygon part = MakePolygonsOrDie(kPart);
  for (const ScanStrategy strategy : kStrategies) {
    ExposureOptions options;
    options.strategy = strategy;
    MeltedRaster raster(Offset(part, -1'000), 17'000);
    const ExposedLayer layer = ExposeOrDie(part, options);
    for (const ExposureGroup& group : layer.groups)
      group.ForEachLine([&](std::span<const Point> line) { raster.Add(line, options.spot_nm); });
    EXPECT_GE(raster.Share(1), 0.995) << static_cast<int>(strategy);
  }
}

/// Lines overlap at different positions in each layer: at their ends, where cells meet, and in the
/// corners and the middle of rings.
TEST(ExposeLayer, NoColumnIsMeltedTwiceInMostLayers) {
  constexpr int32_t kLayers = 60;
  for (const ScanStrategy strategy : kStrategies) {
    // In small parts every ring reaches into the corners, because otherwise too large a share would
    // stay open. Therefore rings are tested on a larger part.
    const MultiPolygon cube =
        MakePolygonsOrDie(IsRings(strategy) ? "(0 0, 10 0, 10 10, 0 10)" : "(0 0, 4 0, 4 4, 0 4)");
    ExposureOptions options;
    options.strategy = strategy;
    options.link_rings = false;  // each ring is a line, which melts a point once
    MeltedRaster shifted(cube, 37'000), still(cube, 37'000);
    for (const bool shifts : {true, false}) {
      options.shift_grids = options.turn_rings = shifts;
      for (int32_t index = 0; index < kLayers; ++index)
        for (const ExposureGroup& group : ExposeOrDie(cube, options, index).groups)
          group.ForEachLine([&](std::span<const Point> line) {
            (shifts ? shifted : still).Add(line, options.spot_nm - 2'000);
          });
    }
    EXPECT_LE(shifted.Most(), 1.4 * kLayers) << static_cast<int>(strategy);
    EXPECT_GE(still.Most(), 1.7 * kLayers) << static_cast<int>(strategy);
  }
}

/// Wall widths from one contour's width, including widths with space for one more line but not for
/// two. Each layer is tested, because hatch along the wall is the worst case.
TEST(ExposeLayer, WallsOfAnyWidthAreMelted) {
  for (const char* width : {"0.085", "0.12", "0.17", "0.2", "0.239", "0.25", "0.31", "0.33",
                            "0.345", "0.36", "0.4", "0.48", "0.6"}) {
    const std::string text = std::string("(0 0, 10 0, 10 ") + width + ", 0 " + width + ")";
    const MultiPolygon wall = MakePolygonsOrDie(text.c_str());
    for (const ScanStrategy strategy : kStrategies) {
      for (const double angle : {0.0, 5.0, 30.0, 90.0}) {
        ExposureOptions options;
        options.strategy = strategy;
        options.hatch_angle_deg = angle;
        options.layer_rotation_deg = 0;
        MeltedRaster raster(wall, 4'700);
        const ExposedLayer layer = ExposeOrDie(wall, options, 3);
        for (const ExposureGroup& group : layer.groups)
          group.ForEachLine(
              [&](std::span<const Point> line) { raster.Add(line, options.spot_nm); });
        EXPECT_GE(raster.Share(1), 0.995)
            << text << ' ' << static_cast<int>(strategy) << ' ' << angle;
      }
    }
  }
}

/// The measured figures of a layer agree with a raster.
TEST(ExposeLayer, TellsHowMuchIsMelted) {
  const MultiPolygon part = MakePolygonsOrDie(kPart);
  ExposureOptions options;
  EXPECT_GE(ExposeOrDie(part, options, 7).melted.Melted(), 0.995);
  options.contours = 0;
  options.hatch_distance_nm = 160'000;
  options.overlap_nm = 0;
  MeltedSample sum;
  for (int32_t layer = 0; layer < 20; ++layer) sum.Add(ExposeOrDie(part, options, layer).melted);
  EXPECT_NEAR(sum.Melted(), 0.5, 0.03);
  EXPECT_NEAR(sum.MeanJmm2(), 0.5 * 200 / 800 / 0.08, 0.1);
}

/// Rings on both sides of a cut keep a hatch distance between them: only the insides of turns and
/// the links are exposed twice.
TEST(ExposeLayer, RingsExposeCutsOnce) {
  const MultiPolygon part = MakePolygonsOrDie(kPart);
  for (const Coord overlap : {0, 40'000}) {
    ExposureOptions options;
    options.strategy = ScanStrategy::kRings;
    options.contours = 0;
    options.thin_walls = false;
    options.ring_overlap_nm = overlap;
    options.fill_corners = false;
    MeltedRaster raster(part, 13'000);
    const ExposedLayer layer = ExposeOrDie(part, options);
    // The spot is slightly narrower than the distance, so that touching lines do not count twice.
    ForEachLineOf(layer, ExposureKind::kHatch,
                  [&](std::span<const Point> line) { raster.Add(line, 78'000); });
    EXPECT_EQ(layer.cuts.pieces, layer.groups[0].LineCount());
    if (overlap == 0)
      EXPECT_LT(raster.Share(2), 0.003);
    else
      EXPECT_GT(raster.Share(2), 0.003);
  }
}

TEST(ExposeLayer, NothingLeavesTheCompensatedOutline) {
  std::mt19937 random(31);
  int points = 0;
  for (int i = 0; i < 30; ++i) {
    const MultiPolygon part = RandomIsland(random, {}, 4);
    for (const ScanStrategy strategy : kStrategies) {
      ExposureOptions options;
      options.strategy = strategy;
      options.ring_overlap_nm = i % 2 * 20'000;
      options.contours = i % 3;
      options.thin_walls = false;
      const auto compensation = static_cast<double>(options.beam_compensation_nm);
      // Points between the ends of lines are tested too.
      const ExposedLayer layer = ExposeOrDie(part, options, i);
      for (const ExposureGroup& group : layer.groups)
        group.ForEachLine([&](std::span<const Point> line) {
          for (size_t k = 1; k < line.size(); ++k) {
            // A line to and fro is a ring without an area.
            ForEachBoundaryPoint({{{line[k - 1], line[k]}, {}}}, 50'000, [&](Point p) {
              ++points;
              EXPECT_TRUE(Inside(p, part)) << ToText(part);
              EXPECT_GE(DistanceToBoundary(p, part), compensation - 3'000) << ToText(part);
            });
          }
        });
    }
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_GT(points, 1'000);
}

TEST(ExposeLayer, HatchTurnsFromLayerToLayer) {
  ExposureOptions options;
  options.strategy = ScanStrategy::kHatch;
  options.hatch_angle_deg = 10;
  options.shift_grids = false;  // no lines along the contour
  const MultiPolygon part = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  for (const int32_t index : {0, 1, 2, 7, 100}) {
    const double expected = std::fmod(10 + 67.0 * index, 180);
    ForEachLineOf(ExposeOrDie(part, options, index), ExposureKind::kHatch,
                  [&](std::span<const Point> line) {
                    if (Distance(line[0], line[1]) < 5e6) return;
                    double angle = std::atan2(static_cast<double>(line[1].y - line[0].y),
                                              static_cast<double>(line[1].x - line[0].x)) *
                                   180 / M_PI;
                    angle = std::fmod(angle + 360, 180);
                    const double off = std::abs(angle - expected);
                    EXPECT_LT(std::min(off, 180 - off), 1e-3);
                  });
  }
}

TEST(ExposeLayer, SkinsAreWhatNeighboursDoNotCover) {
  ExposureOptions options;
  options.strategy = ScanStrategy::kHatch;
  options.contours = 0;
  options.beam_compensation_nm = 0;
  options.upskin_layers = 1;
  options.downskin_layers = 2;
  const MultiPolygon wide = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  const std::vector<SlicedLayer> layers = {LayerOf(MakePolygonsOrDie("(0 0, 10 0, 10 7, 0 7)"), 0),
                                           LayerOf(wide, 1), LayerOf(wide, 2),
                                           LayerOf(MakePolygonsOrDie("(0 0, 4 0, 4 10, 0 10)"), 3)};
  const auto middle = Expose(layers, 2, {options});
  ASSERT_TRUE(middle.ok()) << middle.status();
  // The layer above covers only x < 4; the layer two below covers only y < 7.
  const double down = 10 * 3, up = 6 * 7, core = 4 * 7;
  EXPECT_NEAR(KindLengthMm(*middle, ExposureKind::kDownskin) * 0.08, down, 0.5);
  EXPECT_NEAR(KindLengthMm(*middle, ExposureKind::kUpskin) * 0.08, up, 0.5);
  EXPECT_NEAR(KindLengthMm(*middle, ExposureKind::kHatch) * 0.08, core, 0.5);
  // The first layer is on the plate. The layers above the last one are unknown.
  const auto first = Expose(layers, 0, {options});
  EXPECT_EQ(KindLengthMm(*first, ExposureKind::kDownskin), 0);
  const auto last = Expose(layers, 3, {options});
  EXPECT_GT(KindLengthMm(*last, ExposureKind::kUpskin), 0);
  EXPECT_EQ(KindLengthMm(*last, ExposureKind::kHatch), 0);
}

/// The lines or rings of each kind have the density of the kind's own hatch distance.
TEST(ExposeLayer, SkinsHaveDistancesOfTheirOwn) {
  const MultiPolygon wide = MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)");
  const std::vector<SlicedLayer> layers = {
      LayerOf(MakePolygonsOrDie("(0 0, 20 0, 20 12, 0 12)"), 0), LayerOf(wide, 1),
      LayerOf(MakePolygonsOrDie("(0 0, 8 0, 8 20, 0 20)"), 2)};
  for (const ScanStrategy strategy : kStrategies) {
    ExposureOptions options;
    options.strategy = strategy;
    options.fill_corners = false;
    options.overlap_nm = 0;
    options.ring_overlap_nm = 0;
    options.upskin_layers = options.downskin_layers = 1;
    options.upskin_distance_nm = 50'000;
    options.downskin_distance_nm = 120'000;
    const auto layer = Expose(layers, 1, {options});
    ASSERT_TRUE(layer.ok()) << layer.status();
    const double down = 20 * 8, up = 12 * 12, core = 8 * 12;
    const auto share = [&](ExposureKind kind, double distance, double mm2) {
      return KindLengthMm(*layer, kind) * distance / mm2;
    };
    EXPECT_NEAR(share(ExposureKind::kDownskin, 0.12, down), 0.97, 0.025);
    EXPECT_NEAR(share(ExposureKind::kUpskin, 0.05, up), 0.97, 0.025);
    EXPECT_NEAR(share(ExposureKind::kHatch, 0.08, core), 0.97, 0.025);
  }
}

/// Rings of skins keep contour_distance from the innermost contour, independent of their own hatch
/// distance.
TEST(ExposeLayer, RingsOfSkinsKeepOffTheContour) {
  ExposureOptions options;
  options.strategy = ScanStrategy::kRings;
  options.fill_corners = false;
  options.upskin_layers = 1;
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 4 0, 4 4, 0 4)");
  for (const Coord distance : {40'000, 80'000, 110'000}) {
    options.upskin_distance_nm = distance;
    const auto top = Expose({LayerOf(square)}, 0, {options});
    ASSERT_TRUE(top.ok()) << top.status();
    Coord left = INT64_MAX;
    ForEachLineOf(*top, ExposureKind::kUpskin,
                  [&](std::span<const Point> line) { left = std::min(left, Bounds(line).min.x); });
    EXPECT_EQ(left, 200'000) << distance;
  }
}

/// A table of 10 x 10 mm on a leg of 2 x 10 mm, beginning with layer 3.
TEST(ExposeLayer, ZCompensationLeavesOutWhatLiesOverPowder) {
  std::vector<SlicedLayer> layers;
  for (int32_t i = 0; i < 8; ++i)
    layers.push_back(LayerOf(
        MakePolygonsOrDie(i < 3 ? "(0 0, 2 0, 2 10, 0 10)" : "(0 0, 10 0, 10 10, 0 10)"), i));
  ExposureOptions options;
  options.z_compensation_layers = 2;
  options.downskin_layers = 1;
  EXPECT_EQ(options.Halo(), 3);
  for (int32_t i = 0; i < 8; ++i) {
    const auto layer = Expose(layers, static_cast<size_t>(i), {options});
    ASSERT_TRUE(layer.ok()) << layer.status();
    Coord right = 0;
    for (const ExposureGroup& group : layer->groups)
      right = std::max(right, Bounds(group.points).max.x);
    EXPECT_EQ(right, i < 5 ? 1'960'000 : 9'960'000) << i;
    // The downskin is above the area that the layers below have melted.
    EXPECT_EQ(KindLengthMm(*layer, ExposureKind::kDownskin) > 0, i == 5) << i;
  }
}

TEST(ExposeLayer, ContoursBeginElsewhereInEachLayer) {
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  const auto starts = [&](ContourStart start) {
    ExposureOptions options;
    options.contour_start = start;
    options.contours = 1;
    std::vector<Point> points;
    for (int32_t index = 0; index < 100; ++index)
      points.push_back(ExposeOrDie(square, options, index).groups[0].points[0]);
    return points;
  };
  // The nearest two of 100 starts on 40 mm have at least a quarter of the even distance between
  // them.
  const std::vector<Point> scattered = starts(ContourStart::kScattered);
  for (size_t i = 0; i < scattered.size(); ++i)
    for (size_t k = 0; k < i; ++k) EXPECT_GT(Distance(scattered[i], scattered[k]), 100'000);
  for (const Point start : starts(ContourStart::kRear))
    EXPECT_EQ(start, (Point{9'960'000, 9'960'000}));
  for (const Point start : starts(ContourStart::kNearest))
    EXPECT_EQ(start, (Point{40'000, 40'000}));
}

/// Gas flows to +x: copies and contours are scanned from the right. No hatch line has a line on its
/// lee side that is scanned later.
TEST(ExposeLayer, AgainstTheFlowOfGas) {
  ExposureOptions options;
  options.jump_order = JumpOrder::kAgainstGas;
  options.gas_window_deg = 30;
  options.hatch_angle_deg = options.layer_rotation_deg = 0;
  options.contours = 1;
  options.stripe_width_nm = 1'000'000;
  const MultiPolygon pair = MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9) ; (20 0, 29 0, 29 9, 20 9)");
  const std::vector<SlicedLayer> layers = {LayerOf(pair, 2)};
  const std::vector<Copy> copies = {{0, {0, 0}}, {0, {80'000'000, 0}}, {0, {40'000'000, 0}}};
  const auto layer = Expose(layers, 0, {options}, copies);
  ASSERT_TRUE(layer.ok()) << layer.status();
  ASSERT_EQ(layer->visits.size(), 3u);
  EXPECT_EQ(layer->visits[0].copy, 1);
  EXPECT_EQ(layer->visits[1].copy, 2);
  EXPECT_EQ(layer->visits[2].copy, 0);
  EXPECT_GT(layer->groups[0].points.front().x, 20'000'000);
  for (const ExposureGroup& group : layer->groups) {
    if (group.kind != ExposureKind::kHatch || !group.IsHatch()) continue;
    const std::vector<Point>& ends = group.points;
    for (size_t i = 0; i < ends.size(); i += 2)
      for (size_t k = 0; k < i; k += 2) {
        const Coord low =
            std::max(std::min(ends[i].y, ends[i + 1].y), std::min(ends[k].y, ends[k + 1].y));
        const Coord high =
            std::min(std::max(ends[i].y, ends[i + 1].y), std::max(ends[k].y, ends[k + 1].y));
        if (high - low < 150'000) continue;  // stripes overlap
        EXPECT_LT(ends[i].x + ends[i + 1].x, ends[k].x + ends[k + 1].x);
      }
  }
}

TEST(ExposeLayer, AThinWallIsOneLineAlongItsMiddle) {
  const ExposedLayer layer = ExposeOrDie(MakePolygonsOrDie("(0 0, 10 0, 10 0.06, 0 0.06)"), {});
  ASSERT_EQ(layer.groups.size(), 1u);
  EXPECT_EQ(layer.groups[0].kind, ExposureKind::kThinWall);
  ASSERT_EQ(layer.groups[0].LineCount(), 1u);
  for (const Point p : layer.groups[0].points) EXPECT_EQ(p.y, 30'000);
  EXPECT_NEAR(KindLengthMm(layer, ExposureKind::kThinWall), 10, 0.1);

  ExposureOptions options;
  options.thin_walls = false;
  EXPECT_TRUE(
      ExposeOrDie(MakePolygonsOrDie("(0 0, 10 0, 10 0.06, 0 0.06)"), options).groups.empty());
}

TEST(ExposeLayer, AThickPartHasNoThinWalls) {
  EXPECT_EQ(KindLengthMm(ExposeOrDie(MakePolygonsOrDie(kPart), {}), ExposureKind::kThinWall), 0);
}

TEST(ExposeLayer, RingsFromTheInsideAndFromTheOutside) {
  ExposureOptions options;
  options.contours = 0;
  options.strategy = ScanStrategy::kRings;
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 5 0, 5 5, 0 5)");
  for (const bool link : {false, true}) {
    options.link_rings = link;
    options.strategy = ScanStrategy::kRings;
    const ExposedLayer out = ExposeOrDie(square, options);
    options.strategy = ScanStrategy::kRingsInward;
    const ExposedLayer in = ExposeOrDie(square, options);
    const Point middle{2'500'000, 2'500'000};
    for (const ExposedLayer* layer : {&out, &in}) {
      const std::vector<Point>& points = layer->groups[0].points;
      EXPECT_EQ(layer->groups[0].LineCount(), link ? 1u : 32u);
      const bool outwards = layer == &out;
      EXPECT_EQ(Distance(points.front(), middle) < Distance(points.back(), middle), outwards);
    }
    EXPECT_NEAR(KindLengthMm(out, ExposureKind::kHatch), KindLengthMm(in, ExposureKind::kHatch), 5);
  }
}

TEST(ExposeLayer, CopiesAreVisitedOnceEach) {
  const std::vector<SlicedLayer> layers = {LayerOf(MakePolygonsOrDie("(0 0, 1 0, 1 1, 0 1)"))};
  const std::vector<Copy> copies = {
      {0, {50'000'000, 0}}, {1, {9, 9}}, {0, {10'000'000, 0}}, {0, {30'000'000, 0}}};
  const auto layer = Expose(layers, 0, {ExposureOptions{}}, copies);
  ASSERT_TRUE(layer.ok());
  ASSERT_EQ(layer->visits.size(), 3u);  // object 1 has no section in this layer
  EXPECT_EQ(layer->visits[0].copy, 2);
  EXPECT_EQ(layer->visits[1].copy, 3);
  EXPECT_EQ(layer->visits[2].copy, 0);
  EXPECT_NEAR(layer->area_mm2, 3, 1e-12);
}

TEST(ExposeLayer, RegionsHaveTheirOwnStyles) {
  SlicedLayer layer = LayerOf(MakePolygonsOrDie("(0 0, 5 0, 5 5, 0 5)"));
  layer.sections[0].regions.push_back(
      {.settings = 1, .outlines = MakePolygonsOrDie("(6 0, 9 0, 9 5, 6 5)")});
  ExposureOptions first, second;
  first.strategy = ScanStrategy::kHatch;
  second.strategy = ScanStrategy::kRings;
  const auto exposed = Expose({layer}, 0, {first, second});
  ASSERT_TRUE(exposed.ok()) << exposed.status();
  for (const ExposureGroup& group : exposed->groups)
    EXPECT_EQ(group.settings, Bounds(group.points).min.x > 5'500'000 ? 1 : 0);
}

TEST(ExposeLayer, RefusesSettingsThatAreInNoTable) {
  SlicedLayer layer = LayerOf(MakePolygonsOrDie("(0 0, 5 0, 5 5, 0 5)"));
  layer.sections[0].regions[0].settings = 1;
  EXPECT_EQ(DetailOf(Expose({layer}, 0, {ExposureOptions{}}).status()).reason,
            Reason::kRequestMalformed);
}

TEST(ExposeLayer, StopsWhenCancelled) {
  const std::vector<SlicedLayer> layers = {LayerOf(MakePolygonsOrDie(kPart))};
  const std::vector<ExposureOptions> regions(1);
  const auto layer = ExposeLayer(layers[0], ObjectLayers(layers), regions, std::vector<Copy>{{}},
                                 CancelToken([] { return true; }));
  EXPECT_EQ(DetailOf(layer.status()).reason, Reason::kCancelled);
}

}  // namespace
}  // namespace slicefarm::exposure::expose_layer_test
