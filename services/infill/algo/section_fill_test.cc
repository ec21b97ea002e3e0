#include "services/infill/algo/section_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/text_format_test.h"
#include "common/model/bead_section.h"
#include "common/model/options/infill_options.h"
#include "services/infill/algo/sample_sections_test.h"

namespace slicefarm::infill::section_fill_test {
namespace {

using sample_sections::BridgeBy;
using sample_sections::FeaturesOf;
using sample_sections::FillPlain;
using sample_sections::LengthOf;
using sample_sections::OneLayer;
using sample_sections::P;
using sample_sections::PathsIn;
using sample_sections::PathsOf;
using sample_sections::Prism;
using sample_sections::Thin;
using sample_sections::VolumeOf;

/// Returns the section of one layer. Its fill area has two halves with one row each.
WalledSection Halves(int32_t layer) {
  WalledIsland island;
  island.fill_areas = {{Role::kPart, 0, 0, P("(1 1, 10 1, 10 19, 1 19)")},
                       {Role::kPart, 1, 0, P("(10 1, 19 1, 19 19, 10 19)")}};
  return {0, layer, 200'000, {island}};
}

TEST(FillSection, EachAreaHasItsRegionsSettings) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(2);
  regions[0].top_solid_layers = regions[0].bottom_solid_layers = 1;
  regions[1].density = 1;
  const auto filled = FillPlain(Halves(5), false, objects, regions);
  ASSERT_TRUE(filled.ok()) << filled.status();
  EXPECT_EQ(FeaturesOf(*filled, 0), std::set{Feature::kInternalInfill});
  EXPECT_EQ(FeaturesOf(*filled, 1), std::set{Feature::kSolidInfill});
}

TEST(FillSection, SkinsAreAsManyLayersAsTheRegionSays) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(2);
  regions[0].top_solid_layers = 2;
  regions[1].top_solid_layers = 4;
  regions[0].bottom_solid_layers = regions[1].bottom_solid_layers = 0;
  const auto filled = FillPlain(Halves(7), false, objects, regions);
  ASSERT_TRUE(filled.ok()) << filled.status();
  EXPECT_EQ(FeaturesOf(*filled, 0), std::set{Feature::kInternalInfill});
  EXPECT_EQ(FeaturesOf(*filled, 1), std::set{Feature::kSolidInfill});
}

// The lowest layer of an object is its bottom and not a bridge, on a raft and on the bed.
TEST(FillSection, TheLowestLayerIsNoBridge) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  const std::vector<InfillOptions> regions(2);
  for (const bool on_bed : {true, false}) {
    const auto filled = FillPlain(Halves(0), on_bed, objects, regions);
    ASSERT_TRUE(filled.ok()) << filled.status();
    EXPECT_EQ(FeaturesOf(*filled, 0), std::set{Feature::kSolidInfill});
  }
}

TEST(FillSection, EverySoManyLayersAreSolid) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(2);
  for (InfillOptions& options : regions) options.top_solid_layers = options.bottom_solid_layers = 0;
  regions[1].solid_every_layers = 3;
  for (const int32_t layer : {5, 6, 7}) {
    const auto filled = FillPlain(Halves(layer), false, objects, regions);
    ASSERT_TRUE(filled.ok()) << filled.status();
    EXPECT_EQ(FeaturesOf(*filled, 0), std::set{Feature::kInternalInfill});
    EXPECT_EQ(FeaturesOf(*filled, 1),
              std::set{layer == 6 ? Feature::kBridgeInfill : Feature::kInternalInfill});
  }
}

// Gyroids at two heights differ. Layers at the same height are equal, independent of their numbers.
TEST(FillSection, PatternsSeeTheHeightInTheObject) {
  auto layers = Prism();
  for (SlicedLayer& layer : layers) layer.sections[0].z_nm = layer.frame.print_z_nm;
  layers[6].sections[0].z_nm = layers[5].sections[0].z_nm;
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(2);
  for (InfillOptions& options : regions) {
    options.top_solid_layers = options.bottom_solid_layers = 0;
    options.pattern = FillPattern::kGyroid;
  }
  const auto fills = [&](int32_t layer) {
    return FillPlain(Halves(layer), false, objects, regions)->islands[0].fills;
  };
  EXPECT_EQ(fills(5), fills(6));
  EXPECT_NE(fills(5), fills(7));
}

TEST(FillSection, AFieldTakesThePlaceOfTheDensity) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> plain(2), fields(2), dense(2);
  for (size_t i = 0; i < 2; ++i) {
    plain[i].top_solid_layers = plain[i].bottom_solid_layers = 0;
    plain[i].pattern = FillPattern::kGyroid;
    fields[i] = dense[i] = plain[i];
    plain[i].density = 0.35;
    fields[i].density_field = R"({"kind":"height","table":[[0,0.35]]})";
    dense[i].density_field = R"({"kind":"height","table":[[0,1]]})";
  }
  const auto fills = [&](const std::vector<InfillOptions>& regions) {
    const auto rows = ParseFields(regions);
    RegionFields read(*rows, layers);
    return *FillSection(Halves(5), false, objects, {}, regions, read);
  };
  EXPECT_EQ(fills(plain), fills(fields)) << "one density for a layer is the pattern's";
  EXPECT_EQ(FeaturesOf(fills(dense), 0), std::set{Feature::kSolidInfill});
}

TEST(FillSection, ThePlateHasNoNeighbours) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(1);
  regions[0].top_solid_layers = regions[0].bottom_solid_layers = 0;
  WalledIsland island;
  island.fill_areas = {{Role::kRaft, 0, 0, P("(1 1, 10 1, 10 19, 1 19)")}};
  const auto filled = FillPlain({Stack(1, kPlateObject, StackKind::kRaft), 0, 300'000, {island}},
                                true, objects, regions);
  ASSERT_TRUE(filled.ok()) << filled.status();
  EXPECT_EQ(FeaturesOf(*filled, 0), std::set{Feature::kSupport});
}

// Otherwise the structure on a narrow column of supports would be printed into the air.
TEST(FillSection, AColumnThatTheLinesPassByHasOneAlongItsMiddle) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(1);
  regions[0].top_solid_layers = regions[0].bottom_solid_layers = 0;
  regions[0].pattern = FillPattern::kAlignedRectilinear;
  regions[0].density = 0.15;
  const auto paths = [&](Role role, bool walled) {
    WalledIsland island;
    island.fill_areas = {{role, 0, 0, P("(4 2, 4.4 2, 4.4 9, 4 9)")}};
    if (walled) island.walls.emplace_back();
    const auto filled = FillPlain({Stack(1, 0, StackKind::kSupport), 3, 200'000, {island}}, false,
                                  objects, regions);
    EXPECT_TRUE(filled.ok()) << filled.status();
    return PathsOf(*filled);
  };
  const auto middle = paths(Role::kSupport, /*walled=*/false);
  ASSERT_EQ(middle.size(), 1);
  EXPECT_EQ(middle[0].feature, Feature::kSupport);
  for (const Point point : middle[0].points) EXPECT_NEAR(ToMm(point.x), 4.2, 0.03);
  EXPECT_TRUE(paths(Role::kSupport, /*walled=*/true).empty()) << "a wall is a line";
  EXPECT_TRUE(paths(Role::kPart, /*walled=*/false).empty());
}

/// Returns the fill of one row in layer 5, for the whole square.
FilledSection SquareOf(const InfillOptions& options, std::span<const PlannedInfill> plans,
                       int32_t layer = 5) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  const std::vector<InfillOptions> regions = {options};
  WalledIsland island;
  island.fill_areas = {{Role::kPart, 0, 0, P("(1 1, 19 1, 19 19, 1 19)")}};
  const auto rows = ParseFields(regions);
  RegionFields fields(*rows, layers);
  LayerPlan plan;
  plan.infill.assign(plans.begin(), plans.end());
  auto filled = FillSection({0, layer, 200'000, {island}}, false, objects, plan, regions, fields);
  EXPECT_TRUE(filled.ok()) << filled.status();
  return *std::move(filled);
}

std::vector<Path> PathsOf(const InfillOptions& options, std::span<const PlannedInfill> plans,
                          int32_t layer = 5) {
  return PathsIn(SquareOf(options, plans, layer));
}

TEST(FillSection, FollowsWhatIsPlanned) {
  InfillOptions options = Thin();
  options.pattern = FillPattern::kLightning;
  PlannedInfill plan;
  plan.pattern = FillPattern::kLightning;
  plan.lines = {{{FromMm(0), FromMm(10)}, {FromMm(8), FromMm(10)}}};
  const std::vector<Path> paths = PathsOf(options, std::span(&plan, 1));
  ASSERT_EQ(paths.size(), 1u);
  EXPECT_EQ(EndOf(paths[0]), (Point{FromMm(8), FromMm(10)}));
  EXPECT_TRUE(PathsOf(options, {}).empty());
  plan.settings = 1;  // plan of another region
  EXPECT_TRUE(PathsOf(options, std::span(&plan, 1)).empty());
}

TEST(FillSection, LeavesOutWhatIsPlannedSo) {
  PlannedInfill plan;
  plan.left_out = P("(0 0, 10 0, 10 20, 0 20)");
  const std::vector<Path> paths = PathsOf(Thin(), std::span(&plan, 1));
  ASSERT_FALSE(paths.empty());
  for (const Path& path : paths)
    for (const Point p : path.points) EXPECT_GE(p.x, FromMm(10));
}

// An area shared by two layers is printed in one of them, with the plastic of both.
TEST(FillSection, CombinedPlacesHoldThePlasticOfTheirLayers) {
  PlannedInfill plan;
  plan.combined = P("(0 0, 20 0, 20 20, 0 20)");
  plan.combined_height_nm = 400'000;
  const double once = VolumeOf(PathsOf(Thin(), {}), Feature::kInternalInfill);
  const double twice = VolumeOf(PathsOf(Thin(), std::span(&plan, 1)), Feature::kInternalInfill);
  EXPECT_NEAR(twice / once, 2, 0.1);
}

// Two halves of a square of 18 mm have one row each; one half is solid.
TEST(FillSection, UsesSayWhatEachRowsLinesComeTo) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions = {Thin(), Thin()};
  regions[0].pattern = FillPattern::kGyroid;
  regions[1].density = 1;
  const auto filled = FillPlain(Halves(5), false, objects, regions);
  ASSERT_TRUE(filled.ok()) << filled.status();
  ASSERT_EQ(filled->uses.size(), 2u);
  const FillStats& sparse = filled->uses[0];
  EXPECT_EQ(sparse.settings, 0);
  EXPECT_EQ(sparse.feature, Feature::kInternalInfill);
  EXPECT_EQ(sparse.pattern, FillPattern::kGyroid);
  EXPECT_NEAR(sparse.area_mm2, 9 * 18, 1e-6);
  EXPECT_NEAR(sparse.volume_mm3, 9 * 18 * 0.2, 1e-6);
  EXPECT_NEAR(sparse.asked_mm3, 0.2 * sparse.volume_mm3, 1e-6);
  const FillStats& solid = filled->uses[1];
  EXPECT_EQ(solid.settings, 1);
  EXPECT_EQ(solid.feature, Feature::kSolidInfill);
  EXPECT_EQ(solid.pattern, FillPattern::kRectilinear);
  EXPECT_NEAR(solid.asked_mm3, solid.volume_mm3, 1e-9);
  EXPECT_NEAR(solid.plastic_mm3 / solid.volume_mm3, 1, 0.0125);

  const std::vector<Path> paths = PathsIn(*filled);
  for (const FillStats& use : filled->uses) {
    EXPECT_NEAR(use.plastic_mm3, VolumeOf(paths, use.feature), 1e-6);
    EXPECT_EQ(use.paths, std::ranges::count(paths, use.feature, &Path::feature));
    EXPECT_GT(use.longest_mm, 50);
    EXPECT_LE(use.longest_mm, use.length_mm);
  }
}

TEST(FillSection, UsesCountTheLayersThatAreCombined) {
  PlannedInfill plan;
  plan.left_out = P("(0 0, 10 0, 10 20, 0 20)");
  plan.combined = P("(10 0, 20 0, 20 20, 10 20)");
  plan.combined_height_nm = 400'000;
  const std::vector<FillStats> uses = SquareOf(Thin(), std::span(&plan, 1)).uses;
  ASSERT_EQ(uses.size(), 1u);
  EXPECT_NEAR(uses[0].area_mm2, 9 * 18, 1e-6);
  EXPECT_NEAR(uses[0].volume_mm3, 9 * 18 * 0.4, 1e-6);
  // The share includes the lines and the links of a small square.
  EXPECT_GE(uses[0].plastic_mm3 / uses[0].volume_mm3, 0.2);
  EXPECT_LE(uses[0].plastic_mm3 / uses[0].volume_mm3, 0.27);
}

TEST(FillSection, UsesOfFieldsAskForTheirMean) {
  InfillOptions options = Thin();
  options.pattern = FillPattern::kRectilinear;
  options.density_field =
      R"({"kind":"voxels","count":[2,1,1],"origin":[0,0,0],"spacing":[20,1,1],"values":[0.1,0.5]})";
  const std::vector<FillStats> uses = SquareOf(options, {}).uses;
  ASSERT_EQ(uses.size(), 1u);
  EXPECT_NEAR(uses[0].asked_mm3 / uses[0].volume_mm3, 0.3, 0.005);
  EXPECT_EQ(uses[0].pattern, FillPattern::kRectilinear);
  options.density_field.clear();
  options.stress_field = R"({"kind":"constant","stress":[1,0,0.5]})";
  const std::vector<FillStats> streams = SquareOf(options, {}).uses;
  ASSERT_EQ(streams.size(), 1u);
  EXPECT_EQ(streams[0].pattern, std::nullopt);
  EXPECT_NEAR(streams[0].asked_mm3 / streams[0].volume_mm3, 0.2, 1e-9);
}

// The plastic is correct for any number of cells that are on, and for any loss of lines at their
// edges. Links would add plastic, so that there are none.
TEST(FillSection, DitheredFieldsGetThePlasticThatTheyAskFor) {
  for (const FillPattern pattern : {FillPattern::kRectilinear, FillPattern::kGyroid})
    for (const std::string dither : {"blue_noise", "floyd_steinberg"}) {
      InfillOptions options = Thin();
      options.pattern = pattern;
      options.anchor_nm = options.anchor_max_nm = 0;
      options.density_field =
          R"({"kind":"voxels","count":[2,1,1],"origin":[0,0,0],"spacing":[20,1,1],)"
          R"("values":[0.1,0.5],"dither":")" +
          dither + R"("})";
      double asked = 0, got = 0;
      for (const int32_t layer : {4, 5, 6})
        for (const FillStats& use : SquareOf(options, {}, layer).uses)
          asked += use.asked_mm3, got += use.plastic_mm3;
      // Lines end before the edge of the square.
      EXPECT_GT(got / asked, 0.95) << dither << ' ' << static_cast<int>(pattern);
      EXPECT_LT(got / asked, 1.005) << dither << ' ' << static_cast<int>(pattern);
    }
}

TEST(FillSection, NothingAskedForIsNoUse) {
  InfillOptions options = Thin();
  options.density = 0;
  EXPECT_TRUE(SquareOf(options, {}).uses.empty());
}

TEST(FillSection, ATemplateSaysWhichWayLinesRun) {
  InfillOptions options = Thin();
  options.pattern = FillPattern::kRectilinear;
  options.anchor_nm = options.anchor_max_nm = 0;
  options.angle_template = "0,90#2";
  for (const int32_t layer : {3, 4, 5}) {
    const bool across = layer % 3 != 0;
    const std::vector<Path> paths = PathsOf(options, {}, layer);
    ASSERT_FALSE(paths.empty()) << layer;
    for (const Path& path : paths) {
      const Point route = EndOf(path) - StartOf(path);
      EXPECT_EQ(across ? route.x : route.y, 0) << layer;
    }
  }
  options.solid_angle_template = "0";
  options.density = 1;
  for (const int32_t layer : {3, 4}) {
    const std::vector<Path> paths = PathsOf(options, {}, layer);
    ASSERT_FALSE(paths.empty()) << layer;
    for (const Path& path : paths) {
      const Point route = path.points[1] - path.points[0];
      EXPECT_EQ(route.y, 0) << layer;
    }
  }
}

TEST(FillSection, LinesMayKeepTheirDirectionFromLayerToLayer) {
  InfillOptions options = Thin();
  options.pattern = options.solid_pattern = FillPattern::kRectilinear;
  options.anchor_nm = options.anchor_max_nm = 0;
  for (const double density : {0.2, 1.0}) {
    options.density = density;
    const auto direction = [&](int32_t layer) {
      const Path path = PathsOf(options, {}, layer).front();
      const Point step = path.points[1] - path.points[0];
      return std::atan2(static_cast<double>(step.y), static_cast<double>(step.x));
    };
    const auto turn = [&] { return std::abs(std::sin(direction(4) - direction(5))); };
    options.same_direction = false;
    EXPECT_NEAR(turn(), 1, 1e-3) << density;
    options.same_direction = true;
    EXPECT_NEAR(turn(), 0, 1e-3) << density;
  }
}

TEST(FillSection, IroningGoesOverWhatIsAskedFor) {
  InfillOptions options = Thin();
  options.ironing.enabled = true;
  const auto irons = [&](IroningType type, int32_t layer) {
    options.ironing.type = type;
    return VolumeOf(PathsOf(options, {}, layer), Feature::kIroning) > 0;
  };
  using enum IroningType;
  EXPECT_TRUE(irons(kTop, 9));
  EXPECT_TRUE(irons(kTopmost, 9));
  EXPECT_TRUE(irons(kSolid, 9));
  for (const IroningType type : {kTop, kTopmost, kSolid}) EXPECT_FALSE(irons(type, 5));
  EXPECT_FALSE(irons(kTop, 0));
  EXPECT_TRUE(irons(kSolid, 0));
}

// The tops of walls are visible too: ironing ends half a nozzle from the part's edge, or by the
// inset of the settings.
TEST(FillSection, IroningGoesOverWallsToo) {
  InfillOptions options = Thin();
  options.ironing.enabled = true;
  options.walls_nm = 1'000'000;
  options.nozzle_nm = 400'000;
  for (const auto& [inset_nm, want_nm] :
       {std::pair<Coord, Coord>{0, 200'000}, {700'000, 700'000}}) {
    options.ironing.inset_nm = inset_nm;
    Box reach;
    for (const Path& path : PathsOf(options, {}, 9))
      if (path.feature == Feature::kIroning)
        for (const Point point : path.points) reach.Add(point);
    const Coord edge_nm = want_nm + options.ironing.spacing_nm / 2;
    EXPECT_NEAR(reach.min.x, edge_nm, 100'000);
    EXPECT_NEAR(reach.max.y, 20'000'000 - edge_nm, 100'000);
    EXPECT_GE(reach.min.x, want_nm);
    EXPECT_LE(reach.max.y, 20'000'000 - want_nm);
  }
}

/// Returns the direction of the longest ironing line of a layer, in degrees from 0 to 180.
double IroningDirection(const InfillOptions& options, int32_t layer) {
  double longest = 0, degrees = 0;
  for (const Path& path : PathsOf(options, {}, layer)) {
    if (path.feature != Feature::kIroning) continue;
    for (size_t i = 1; i < path.points.size(); ++i) {
      const Point step = path.points[i] - path.points[i - 1];
      if (Norm(step) <= longest) continue;
      longest = Norm(step);
      degrees = std::atan2(static_cast<double>(step.y), static_cast<double>(step.x)) * 180 /
                std::numbers::pi;
    }
  }
  return degrees < -1e-6 ? degrees + 180 : degrees;
}

TEST(FillSection, IroningHasItsAngle) {
  InfillOptions options = Thin();
  options.ironing = {.enabled = true, .type = IroningType::kSolid};
  const auto directions = [&](double angle_deg, bool fixed) {
    options.ironing.angle_rad = angle_deg * std::numbers::pi / 180;
    options.ironing.fixed_angle = fixed;
    options.bottom_solid_layers = 2;
    return std::pair(IroningDirection(options, 0), IroningDirection(options, 1));
  };
  const auto [first, second] = directions(0, false);
  EXPECT_NEAR(std::abs(first - second), 90, 0.1) << "turns with the layers";
  const auto [turned, turned_second] = directions(20, false);
  EXPECT_NEAR(std::remainder(turned - first - 20, 180), 0, 0.1);
  EXPECT_NEAR(std::remainder(turned_second - second - 20, 180), 0, 0.1);
  const auto [fixed, fixed_second] = directions(20, true);
  EXPECT_NEAR(fixed, 20, 0.1);
  EXPECT_NEAR(fixed_second, 20, 0.1);
}

// The next layer covers the left half of the square.
TEST(FillSection, IroningExpandsOverCoveredPlasticButNotTowardsTheEdge) {
  auto layers = Prism();
  layers[6].sections[0].regions[0].outlines = P("(0 0, 10 0, 10 20, 0 20)");
  const ObjectLayers objects(layers);
  InfillOptions options = Thin();
  options.ironing.enabled = true;
  options.top_solid_layers = 1;
  const auto reach = [&](Coord expansion_nm) {
    options.ironing.expansion_nm = expansion_nm;
    Box box;
    WalledSection walled = Halves(5);
    walled.islands[0].fill_areas = {{Role::kPart, 0, 0, P("(1 1, 19 1, 19 19, 1 19)")}};
    const auto filled = FillPlain(std::move(walled), false, objects, {options});
    EXPECT_TRUE(filled.ok()) << filled.status();
    if (filled.ok())
      for (const Path& path : PathsOf(*filled))
        if (path.feature == Feature::kIroning) box.Add(Bounds(path.points));
    return box;
  };
  const Box usual = reach(0), wide = reach(2'000'000), narrow = reach(-2'000'000);
  ASSERT_FALSE(usual.Empty());
  EXPECT_NEAR(static_cast<double>(wide.min.x), static_cast<double>(usual.min.x) - 2e6, 1e5);
  EXPECT_NEAR(static_cast<double>(narrow.min.x), static_cast<double>(usual.min.x) + 2e6, 1e5);
  EXPECT_LE(wide.max.x, 20'000'000 - options.nozzle_nm / 2);
  EXPECT_GT(wide.max.x, usual.max.x);
}

// Supports that stand on different parts of an object have layers with gaps between them.
TEST(FillSection, ALayerFartherUpIsNoCover) {
  auto layers = Prism();
  for (SlicedLayer& layer : layers) {
    layer.sections[0].z_nm = layer.frame.print_z_nm;
    layer.sections[0].regions[0].role = Role::kSupportInterface;
  }
  InfillOptions options = Thin();
  options.density = 1;
  options.top_solid_layers = 1;
  options.ironing.enabled = true;
  const auto irons = [&] {
    const ObjectLayers objects(layers);
    WalledSection walled = Halves(5);
    for (FillArea& area : walled.islands[0].fill_areas) area.role = Role::kSupportInterface;
    const auto filled = FillPlain(std::move(walled), false, objects, {options, options});
    EXPECT_TRUE(filled.ok()) << filled.status();
    return filled.ok() && FeaturesOf(*filled, 0).contains(Feature::kIroning);
  };
  EXPECT_FALSE(irons());
  layers[6].sections[0].z_nm += 200'000;
  EXPECT_TRUE(irons());
}

TEST(FillSection, IroningIsAUse) {
  InfillOptions options = Thin();
  options.ironing.enabled = true;
  const FilledSection filled = SquareOf(options, {}, 9);
  const auto use = std::ranges::find(filled.uses, Feature::kIroning, &FillStats::feature);
  ASSERT_NE(use, filled.uses.end());
  EXPECT_EQ(use->pattern, FillPattern::kMonotonic);
  EXPECT_NEAR(use->asked_mm3 / use->volume_mm3, options.ironing.flow, 1e-9);
  EXPECT_NEAR(use->plastic_mm3, VolumeOf(PathsIn(filled), Feature::kIroning), 1e-6);
  EXPECT_GT(use->plastic_mm3, 0.8 * use->asked_mm3);
}

// Short lines of skins, including links, have less plastic; sparse infill has all of it.
TEST(FillSection, ShortSolidLinesGetThePlasticThatTheTableSays) {
  InfillOptions options = Thin();
  const auto volumes = [&](int32_t layer) {
    const std::vector<Path> paths = PathsIn(SquareOf(options, {}, layer));
    return std::array{VolumeOf(paths, Feature::kTopSolidInfill),
                      VolumeOf(paths, Feature::kSolidInfill),
                      VolumeOf(paths, Feature::kInternalInfill)};
  };
  const auto top = volumes(9), bottom = volumes(0), sparse = volumes(5);
  options.small_area_flow = true;
  options.small_area_flow_table = "0,0.5;999,0.5;1000,1";
  EXPECT_NEAR(volumes(9)[0], top[0] / 2, 0.001 * top[0]);
  EXPECT_NEAR(volumes(0)[1], bottom[1] / 2, 0.001 * bottom[1]);
  EXPECT_EQ(volumes(5), sparse);
  options.small_area_flow_table = "0,0;0.1,1";
  EXPECT_NEAR(volumes(9)[0], top[0], 0.01 * top[0]);
}

TEST(FillSection, SurfacesGetTheirOwnFlow) {
  InfillOptions options = Thin();
  const auto volume = [&](int32_t layer, Feature feature) {
    return VolumeOf(PathsIn(SquareOf(options, {}, layer)), feature);
  };
  const double top = volume(9, Feature::kTopSolidInfill);
  const double bottom = volume(0, Feature::kSolidInfill);
  ASSERT_GT(top, 0);
  ASSERT_GT(bottom, 0);
  options.top_flow = 1.2;
  EXPECT_NEAR(volume(9, Feature::kTopSolidInfill), 1.2 * top, 0.001 * top);
  EXPECT_EQ(volume(0, Feature::kSolidInfill), bottom);
  options.bottom_flow = 1.1;
  EXPECT_NEAR(volume(9, Feature::kTopSolidInfill), 1.2 * top, 0.001 * top);
  EXPECT_NEAR(volume(0, Feature::kSolidInfill), 1.1 * bottom, 0.001 * bottom);
}

TEST(FillSection, RefusesATableOfFlowsThatIsNone) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(2);
  regions[1].small_area_flow = true;
  regions[1].small_area_flow_table = "0,0;1,0.5";
  const auto filled = FillPlain(Halves(5), false, objects, regions);
  ASSERT_FALSE(filled.ok());
  EXPECT_EQ(DetailOf(filled.status()).metadata.at("setting"),
            "small_area_infill_flow_compensation_model");
}

/// Returns a block of 20 mm. In layers 4 to 6 its right half has its own settings.
std::vector<SlicedLayer> BlockWithAModifier() {
  auto layers = Prism();
  for (int i = 4; i < 7; ++i) {
    ObjectSection& section = layers[static_cast<size_t>(i)].sections[0];
    section.whole = section.regions[0].outlines;
    section.regions = {{Role::kPart, 0, 0, P("(0 0, 10 0, 10 20, 0 20)")},
                       {Role::kPart, 1, 0, P("(10 0, 20 0, 20 20, 10 20)")}};
  }
  return layers;
}

TEST(FillSection, InterfaceShellsLieWhereAnotherRegionBegins) {
  const auto layers = BlockWithAModifier();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(2, Thin());
  for (InfillOptions& options : regions) options.top_solid_layers = options.bottom_solid_layers = 1;
  const auto of_modifier = [&](int32_t layer) {
    const auto filled = FillPlain(Halves(layer), false, objects, regions);
    EXPECT_TRUE(filled.ok()) << filled.status();
    return FeaturesOf(*filled, 1);
  };
  for (const int32_t layer : {4, 5, 6})
    EXPECT_EQ(of_modifier(layer), std::set{Feature::kInternalInfill}) << layer;
  regions[1].interface_shells = true;
  EXPECT_EQ(of_modifier(4), std::set{Feature::kSolidInfill});  // no bridge
  EXPECT_EQ(of_modifier(5), std::set{Feature::kInternalInfill});
  EXPECT_EQ(of_modifier(6), std::set{Feature::kTopSolidInfill});
  // The part around the modifier ends there too, if the part has interface shells.
  const auto below = [&] {
    WalledIsland island;
    island.fill_areas = {{Role::kPart, 0, 0, P("(1 1, 19 1, 19 19, 1 19)")}};
    const auto filled = FillPlain({0, 3, 200'000, {island}}, false, objects, regions);
    EXPECT_TRUE(filled.ok()) << filled.status();
    return FeaturesOf(*filled, 0);
  };
  EXPECT_EQ(below(), std::set{Feature::kInternalInfill});
  regions[0].interface_shells = true;
  EXPECT_EQ(below(),
            (std::set{Feature::kInternalInfill, Feature::kSolidInfill, Feature::kTopSolidInfill}));
}

// Thick bridges have round threads with a known section, which do not touch.
TEST(FillSection, ThickBridgesAreRoundThreads) {
  for (const double flow : {0.8, 1.0}) {
    InfillOptions options = Thin();
    options.bridge_flow = flow;
    options.nozzle_nm = 600'000;
    int lines = 0;
    for (const Path& path : PathsIn(BridgeBy(options))) {
      if (path.feature != Feature::kBridgeInfill) continue;
      ++lines;
      const double want = std::numbers::pi / 4 * 0.36 * flow;
      // Widths follow the spacing that fits the bridge: 15 % less to 20 % more.
      EXPECT_GT(SectionMm2(path.WidthAt(0), 200'000), 0.84 * want) << flow;
      EXPECT_LT(SectionMm2(path.WidthAt(0), 200'000), 1.21 * want) << flow;
    }
    EXPECT_GT(lines, 0);
    const auto share = [](const FilledSection& section) {
      for (const FillStats& use : section.uses)
        if (use.feature == Feature::kBridgeInfill) return use.plastic_mm3 / use.volume_mm3;
      return 0.0;
    };
    // At either end, the threads are half a spacing longer than the bridge.
    const double thread_mm = 0.6 * std::sqrt(flow);
    const double of_room = std::numbers::pi / 4 * thread_mm * thread_mm / (thread_mm + 0.05) / 0.2;
    EXPECT_GT(share(BridgeBy(options)), of_room);
    EXPECT_LT(share(BridgeBy(options)), 1.06 * of_room);
  }
}

// Threads hang below their layer. Directly over a support, lines are therefore as high as the
// layer.
TEST(FillSection, BridgesOverSupportsAreNoThreads) {
  const InfillOptions options = Thin();
  InfillOptions flat = options;
  flat.thick_bridges = false;
  const auto plan_above = [](int32_t stack) {
    LayerPlan plan;
    plan.sections.emplace_back().stack = stack;
    plan.sections[0].above_supports = P("(8 8, 9 8, 9 9, 8 9)");
    return plan;
  };
  const LayerPlan beside = plan_above(1), above_supports = plan_above(0);
  EXPECT_EQ(PathsIn(BridgeBy(options, 5, beside)), PathsIn(BridgeBy(options)));
  EXPECT_NE(PathsIn(BridgeBy(options, 5, above_supports)), PathsIn(BridgeBy(options)));
  EXPECT_EQ(PathsIn(BridgeBy(options, 5, above_supports)), PathsIn(BridgeBy(flat)));
}

// The feature exists if it has its own speed. Otherwise it is normal solid infill.
TEST(FillSection, WhatLiesOverABridgeIsAFeatureIfAsked) {
  InfillOptions options = Thin();
  options.density = 1;
  const auto features = [&](int32_t layer) { return FeaturesOf(BridgeBy(options, layer), 0); };
  EXPECT_EQ(features(6), std::set{Feature::kSolidInfill});
  options.over_bridges = true;
  EXPECT_EQ(features(5), (std::set{Feature::kBridgeInfill, Feature::kSolidInfill}));
  EXPECT_EQ(features(6), (std::set{Feature::kSolidInfill, Feature::kSolidOverBridge}));
  EXPECT_EQ(features(7), std::set{Feature::kSolidInfill});
  EXPECT_EQ(features(9), std::set{Feature::kTopSolidInfill});
}

TEST(FillSection, BridgesHaveTheFlowThatIsAskedFor) {
  const auto plastic = [&](double flow) {
    InfillOptions options = Thin();
    options.thick_bridges = false;
    options.bridge_flow = flow;
    const FilledSection filled = BridgeBy(options);
    for (const FillStats& use : filled.uses) {
      const double want = use.feature == Feature::kBridgeInfill ? flow : options.density;
      EXPECT_NEAR(use.asked_mm3 / use.volume_mm3, want, 1e-9);
    }
    const std::vector<Path> paths = PathsIn(filled);
    return std::pair(VolumeOf(paths, Feature::kBridgeInfill),
                     VolumeOf(paths, Feature::kInternalInfill));
  };
  const auto [bridge, sparse] = plastic(1);
  ASSERT_GT(bridge, 0);
  for (const double flow : {0.3, 0.8, 1.2}) {
    const auto [thin, other] = plastic(flow);
    EXPECT_NEAR(thin / bridge, flow, 0.01) << flow;
    EXPECT_EQ(other, sparse);
  }
}

// Only the lowest of the skins is over sparse infill.
TEST(FillSection, SkinsOverSparseInfillAreBridges) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(1);
  regions[0].top_solid_layers = 3;
  regions[0].bottom_solid_layers = 0;
  WalledIsland island;
  island.fill_areas = {{Role::kPart, 0, 0, P("(1 1, 19 1, 19 19, 1 19)")}};
  const struct {
    double density;
    int32_t layer;
    std::set<Feature> features;
  } cases[] = {{.2, 6, {Feature::kInternalInfill}}, {.2, 7, {Feature::kBridgeInfill}},
               {.2, 8, {Feature::kSolidInfill}},    {.2, 9, {Feature::kTopSolidInfill}},
               {0, 7, {Feature::kBridgeInfill}},    {.5, 7, {Feature::kSolidInfill}}};
  for (const auto& [density, layer, features] : cases) {
    regions[0].density = density;
    const auto filled = FillPlain({0, layer, 200'000, {island}}, false, objects, regions);
    ASSERT_TRUE(filled.ok()) << filled.status();
    EXPECT_EQ(FeaturesOf(*filled, 0), features) << density << " in layer " << layer;
    // The threads are 0.45 mm apart.
    if (features.contains(Feature::kBridgeInfill)) {
      EXPECT_NEAR(LengthOf(*filled, Feature::kBridgeInfill), 18 * 18 / .45, 60);
    }
  }
}

TEST(FillSection, BridgesOverSparseInfillHaveTheirOwnFlow) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(1);
  regions[0].top_solid_layers = 3;
  regions[0].bottom_solid_layers = 0;
  WalledIsland island;
  island.fill_areas = {{Role::kPart, 0, 0, P("(1 1, 19 1, 19 19, 1 19)")}};
  const auto volume = [&](Feature feature) {
    return VolumeOf(PathsIn(*FillPlain({0, 7, 200'000, {island}}, false, objects, regions)),
                    feature);
  };
  const double thick = volume(Feature::kBridgeInfill);
  ASSERT_GT(thick, 0);
  regions[0].internal_bridges = true;
  EXPECT_EQ(volume(Feature::kBridgeInfill), 0);
  EXPECT_EQ(volume(Feature::kInternalBridge), thick);
  // Plastic per area is flow * pi / 4 * d^2 / (d * sqrt(flow) + 0.05) with threads of 0.4 mm.
  regions[0].internal_bridge_flow = 0.64;
  EXPECT_NEAR(volume(Feature::kInternalBridge) / thick, 0.64 * 0.45 / 0.37, 0.03);
  // Lines of 0.45 mm in a layer of 0.2 mm, fill the layer by their flow.
  regions[0].thick_internal_bridges = false;
  EXPECT_NEAR(volume(Feature::kInternalBridge), 0.64 * 18 * 18 * 0.2, 0.05 * 18 * 18 * 0.2);
}

/// Returns the bounds of the beads of a feature in the left half of a layer of the prism.
Box BoundsOf(int32_t layer, Feature feature, const InfillOptions& options) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  const auto filled = FillPlain(Halves(layer), false, objects, {options, options});
  EXPECT_TRUE(filled.ok()) << filled.status();
  Box box;
  for (const Path& path : PathsOf(*filled))
    if (path.settings == 0 && path.feature == feature) box.Add(Bounds(path.points));
  return box;
}

TEST(FillSection, TopAndBottomSurfacesHaveTheirOverlap) {
  InfillOptions options;
  options.overlap_nm = 100'000;
  InfillOptions more = options;
  more.surface_overlap_nm = 300'000;
  const auto grown = [&](int32_t layer, Feature feature) {
    return BoundsOf(layer, feature, options).min.x - BoundsOf(layer, feature, more).min.x;
  };
  EXPECT_GT(grown(9, Feature::kTopSolidInfill), 30'000);
  EXPECT_GT(grown(0, Feature::kSolidInfill), 30'000);
  EXPECT_EQ(grown(8, Feature::kSolidInfill), 0) << "inside the part";
}

TEST(FillSection, SolidLinesHaveTheirDirection) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  InfillOptions options;
  options.top_pattern = FillPattern::kMonotonicLines;
  options.solid_angle_rad = 0;
  const auto filled = FillPlain(Halves(9), false, objects, {options, options});
  ASSERT_TRUE(filled.ok()) << filled.status();
  int lines = 0;
  for (const Path& path : PathsOf(*filled)) {
    if (path.feature != Feature::kTopSolidInfill) continue;
    const Point along = path.points[1] - path.points[0];
    EXPECT_LT(std::min(std::abs(along.x), std::abs(along.y)), 10'000) << "along an axis";
    ++lines;
  }
  EXPECT_GT(lines, 10);
}

// Lines of a surface with half the density are twice as far apart, each with its full plastic.
TEST(FillSection, SurfacesHaveTheirDensity) {
  InfillOptions options;
  const auto plastic = [&](int32_t layer, Feature feature) {
    return VolumeOf(PathsIn(OneLayer(options, layer)), feature);
  };
  const double top = plastic(9, Feature::kTopSolidInfill),
               inner = plastic(8, Feature::kSolidInfill),
               bottom = plastic(0, Feature::kSolidInfill);
  ASSERT_GT(top, 0);
  options.solid.top_density = 0.5;
  options.solid.bottom_density = 0.8;
  EXPECT_NEAR(plastic(9, Feature::kTopSolidInfill), 0.5 * top, 0.03 * top);
  EXPECT_NEAR(plastic(0, Feature::kSolidInfill), 0.8 * bottom, 0.03 * bottom);
  EXPECT_EQ(plastic(8, Feature::kSolidInfill), inner);
  EXPECT_NEAR(LengthOf(OneLayer(options, 9), Feature::kTopSolidInfill) /
                  LengthOf(OneLayer({}, 9), Feature::kTopSolidInfill),
              0.5, 0.1);
  options.solid.top_density = 0;
  EXPECT_EQ(plastic(9, Feature::kTopSolidInfill), 0);
}

TEST(FillSection, ListedLayersAreSolid) {
  InfillOptions options;
  options.top_solid_layers = options.bottom_solid_layers = 0;
  options.solid.extra_layers = "4#2,8";
  std::set<int32_t> solid;
  for (int32_t layer = 1; layer < 9; ++layer)
    if (!FeaturesOf(OneLayer(options, layer), 0).contains(Feature::kInternalInfill))
      solid.insert(layer + 1);
  EXPECT_EQ(solid, (std::set{4, 5, 8}));
}

// A strip of 3 mm inside the object has loops if its lines would run across. A wide area has lines.
TEST(FillSection, NarrowSolidPartsHaveLoopsIfAskedFor) {
  InfillOptions options;
  options.density = 1;
  const auto loops = [&](std::string_view area) {
    const auto paths = PathsOf(OneLayer(options, 5, area));
    return std::ranges::count_if(paths, &Path::closed);
  };
  constexpr std::string_view kStrip = "(1 1, 19 1, 19 4, 1 4)", kWide = "(1 1, 19 1, 19 19, 1 19)";
  options.solid_angle_rad = 0;  // in layer 5, lines run along y
  EXPECT_EQ(loops(kStrip), 0);
  options.solid.narrow_loops = true;
  EXPECT_GE(loops(kStrip), 3);
  EXPECT_EQ(loops(kWide), 0);
  options.solid_angle_rad = std::numbers::pi / 4;
  EXPECT_EQ(loops(kWide), 0) << "short lines in its corners";
  options.solid_angle_rad = std::numbers::pi / 2;
  EXPECT_EQ(loops(kStrip), 0);
}

// Lines at 20 % are 2 mm apart: a skin of 1.5 mm rests on them.
TEST(FillSection, NarrowSkinsAreBridgedIfAskedFor) {
  InfillOptions options;
  options.top_solid_layers = 3;
  options.bottom_solid_layers = 0;
  const auto bridged = [&](std::string_view area) {
    return FeaturesOf(OneLayer(options, 7, area), 0).contains(Feature::kBridgeInfill);
  };
  constexpr std::string_view kNarrow = "(1 1, 19 1, 19 2.7, 1 2.7)",
                             kThin = "(1 1, 19 1, 19 1.8, 1 1.8)", kWide = "(1 1, 19 1, 19 9, 1 9)";
  EXPECT_FALSE(bridged(kNarrow));
  EXPECT_TRUE(bridged(kWide));
  options.solid.bridges = SparseBridgeFilter::kMedium;
  EXPECT_TRUE(bridged(kNarrow));
  EXPECT_FALSE(bridged(kThin));
  options.solid.bridges = SparseBridgeFilter::kAll;
  EXPECT_TRUE(bridged(kThin));
}

// With the middles of bodies in the plan, equal islands have equal infill, as if each were alone.
TEST(FillSection, SeparatedBodiesHaveThePatternAroundTheirMiddle) {
  InfillOptions options;
  options.top_solid_layers = options.bottom_solid_layers = 0;
  for (const FillPattern pattern :
       {FillPattern::kHoneycomb, FillPattern::kGyroid, FillPattern::kCubic, FillPattern::kGrid}) {
    options.pattern = pattern;
    const auto island_at = [&](Coord x, std::vector<Point> middles) {
      const MultiPolygon outline = Moved(P("(-10 -10, 10 -10, 10 10, -10 10)"), {x, 0});
      std::vector<SlicedLayer> layers = Prism();
      for (SlicedLayer& layer : layers) layer.sections[0].regions[0].outlines = outline;
      const ObjectLayers objects(layers);
      LayerPlan plan;
      PlannedInfill& infill = plan.infill.emplace_back();
      infill.pattern = pattern;
      infill.body_middles = std::move(middles);
      WalledIsland island;
      island.fill_areas = {{Role::kPart, 0, 0, Moved(P("(-9 -9, 9 -9, 9 9, -9 9)"), {x, 0})}};
      const std::vector<InfillOptions> regions = {options};
      const auto rows = ParseFields(regions);
      RegionFields none(*rows, {});
      std::vector<Path> paths =
          PathsOf(*FillSection({0, 5, 200'000, {island}}, false, objects, plan, regions, none));
      for (Path& path : paths)
        for (Point& p : path.points) p = p - Point{x, 0};
      return paths;
    };
    options.shape.separated = false;
    const auto alone = island_at(0, {});
    EXPECT_NE(island_at(31'300'000, {}), alone);
    options.shape.separated = true;
    EXPECT_EQ(island_at(31'300'000, {{31'300'000, 0}}), alone);
  }
}

// Skin and skeleton have the widths and densities of the settings, and the report has both.
TEST(FillSection, LockedZagHasASkinAndASkeleton) {
  InfillOptions options;
  options.top_solid_layers = options.bottom_solid_layers = 0;
  options.pattern = FillPattern::kLockedZag;
  options.zones = {.skin_density = 0.4,
                   .skeleton_density = 0.1,
                   .skin_width_nm = 400'000,
                   .skeleton_width_nm = 600'000,
                   .skin_depth_nm = 3'000'000,
                   .lock_depth_nm = 1'000'000};
  const FilledSection filled = OneLayer(options, 5);
  std::set<Coord> widths;
  for (const Path& path : PathsOf(filled)) widths.insert(path.widths_nm[0]);
  EXPECT_EQ(widths, (std::set<Coord>{400'000, 600'000}));
  double asked = 0;
  for (const FillStats& use : filled.uses) asked += use.asked_mm3;
  EXPECT_NEAR(asked, 0.2 * (0.4 * (324 - 144) + 0.1 * 196), 0.01);
}

}  // namespace
}  // namespace slicefarm::infill::section_fill_test
