#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "common/config/plate.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/convex.h"
#include "common/model/bead_section.h"
#include "common/stage/object_layers.h"
#include "common/stage/ordering_job.h"
#include "common/stage/print_layers.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/task/layer_chain.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/planning/algo/local_planning_stage.h"

namespace slicefarm::adhesion_plates_test {
namespace {

// Tests skirt, brim and raft of plates of random parts, from settings to printed paths. Distances
// are measured in the paths by plain geometry.

constexpr double kOffNm = 20'000;
/// Tolerance for a single line in a place less than two lines wide. The line has the volume of the
/// place. Its round edges extend by 0.022 mm for a layer of 0.2 mm, and by more where the place
/// becomes narrower.
constexpr double kSingleLineOffNm = 50'000;
/// Width below which a bead counts as such a single line. A loop is this narrow only where it turns
/// in the tip of a place.
constexpr Coord kNarrowNm = 250'000;

bool IsSingleAt(const Path& path, size_t point) {
  return !path.closed || path.WidthAt(point) < kNarrowNm;
}

double Off(const Path& path) { return path.closed ? kOffNm : kSingleLineOffNm; }

using Settings = std::vector<std::pair<std::string, std::string>>;

config::ResolvedPlate Resolved(const Settings& given) {
  std::vector<Setting> job;
  for (const auto& [key, value] : given) job.push_back({key, value, Source::kRequest});
  SceneObject object;
  object.name = "part";
  object.parts.resize(1);
  object.instances.resize(1);
  auto plate = config::ResolvePlate(job, std::span(&object, 1), Process::kFdm);
  EXPECT_TRUE(plate.ok()) << plate.status();
  return plate.ok() ? *std::move(plate) : config::ResolvedPlate{};
}

/// Plate of copies of one object, with the same outline on all layers.
struct Plate {
  std::vector<SlicedLayer> layers;
  std::vector<PlacedCopy> copies;
  MultiPolygon parts;  ///< outlines of the copies on the plate
};

Plate PlateOf(const MultiPolygon& outline, const std::vector<Point>& places, int32_t layer_count,
              const JobSettings& settings) {
  Plate plate;
  const Coord height_nm = settings.slicing.objects[0].layer_height_nm;
  for (int32_t i = 0; i < layer_count; ++i) {
    const Coord top_nm = (i + 1) * height_nm;
    ObjectSection section{0,  i,      layer_count, height_nm, {{Role::kPart, 0, 0, outline}},
                          {}, top_nm, {}};
    plate.layers.push_back({{i, top_nm, height_nm}, {section}});
  }
  for (const Point place : places) {
    plate.copies.push_back({0, place, {}});
    const MultiPolygon placed = Moved(outline, place);
    plate.parts.insert(plate.parts.end(), placed.begin(), placed.end());
  }
  return plate;
}

/// Computes the layers of the print, and the skirt in its plans, as the pipeline does. Copies on
/// random plates may overlap.
PlanningOptions MayOverlap(const JobSettings& settings) {
  PlanningOptions options = PlanningOf(FdmOf(settings));
  options.objects_may_overlap = true;
  return options;
}

void TakePlan(JobPlan& plan, std::vector<SlicedLayer>& layers) {
  layers = PrintLayers(std::move(layers), plan.lifts_nm, plan.stacks);
  for (int32_t i = 0; i < plan.skirt.layers; ++i)
    plan.layers[static_cast<size_t>(i)].paths = plan.skirt.loops;
}

class Stages {
 public:
  /// Returns the paths on the plate besides the parts, in the order of printing, by layer.
  std::vector<std::vector<Path>> OnPlate(Plate& plate, const JobSettings& settings) const {
    auto plan = planning_->Plan({}, {plate.layers, plate.copies}, MayOverlap(settings));
    EXPECT_TRUE(plan.ok()) << plan.status();
    TakePlan(*plan, plate.layers);
    // Only the plate's paths are computed, because this test does not check the parts' own beads.
    for (SlicedLayer& layer : plate.layers)
      std::erase_if(layer.sections, [](const auto& section) { return section.stack.IsPart(); });
    const LayerRange range{0, static_cast<int32_t>(plate.layers.size())};
    auto walled = beading_->Bead({}, {range, plate.layers}, BeadingOf(FdmOf(settings)));
    EXPECT_TRUE(walled.ok()) << walled.status();
    auto filled = infill_->Fill({}, *std::move(walled), {range, plate.layers}, plan->layers,
                                InfillOf(FdmOf(settings)));
    EXPECT_TRUE(filled.ok()) << filled.status();
    auto ordered = ordering_->Order({}, *std::move(filled), plan->layers,
                                    OrderingJob{OrderingOf(FdmOf(settings)), plan->copies});
    EXPECT_TRUE(ordered.ok()) << ordered.status();
    std::vector<std::vector<Path>> layers;
    for (const OrderedLayer& layer : *ordered) {
      std::vector<Path>& paths = layers.emplace_back();
      for (const BlockVisit& visit : layer.visits) {
        for (Path path : layer.blocks[static_cast<size_t>(visit.block)].paths) {
          for (Point& point : path.points) point = point + visit.shift;
          paths.push_back(std::move(path));
        }
      }
    }
    return layers;
  }

 private:
  const std::unique_ptr<PlanningStage> planning_ = planning::MakeLocalPlanning();
  const std::unique_ptr<BeadingStage> beading_ = beading::MakeLocalBeading();
  const std::unique_ptr<InfillStage> infill_ = infill::MakeLocalInfill();
  const std::unique_ptr<OrderingStage> ordering_ = ordering::MakeLocalOrdering();
};

/// Least and greatest distance of beads from a region, outside it.
struct Reach {
  double least = INFINITY, most = -INFINITY;

  void Add(const Path& path, const MultiPolygon& region) {
    for (size_t i = 0; i < path.points.size(); ++i) AddPoint(path, i, region);
  }

  void AddPoint(const Path& path, size_t i, const MultiPolygon& region) {
    const double half = static_cast<double>(path.WidthAt(i)) / 2;
    const double distance = DistanceToRegion(path.points[i], region);
    least = std::min(least, distance - half);
    if (distance + half > most) AddFarthest(path.points[i], half, region);
  }

 private:
  /// Adds the distances of the bead's edge around a point. They may all be less than the distance
  /// of the middle plus half a width.
  void AddFarthest(Point middle, double half, const MultiPolygon& region) {
    constexpr int kDirections = 32;
    for (int i = 0; i < kDirections; ++i) {
      const double t = 2 * std::numbers::pi * i / kDirections;
      const Point edge =
          middle + Point{std::llround(half * std::cos(t)), std::llround(half * std::sin(t))};
      most = std::max(most, DistanceToRegion(edge, region));
    }
  }
};

std::string Mm(double mm) { return fmt::format("{:.3f}", mm); }

MultiPolygon Filled(const MultiPolygon& region) {
  std::vector<Polygon> outers;
  for (const PolygonWithHoles& island : region) outers.push_back(island.outer);
  return Union(outers, FillRule::kNonZero);
}

std::vector<Point> RandomPlaces(std::mt19937& random) {
  std::vector<Point> places = {{100'000'000, 100'000'000}};
  const auto more = static_cast<int>(random() % 3);
  for (int i = 1; i <= more; ++i)  // parts of 12 mm radius do not overlap
    places.push_back(places.front() + Point{std::llround(Uniform(random, 25e6, 34e6)) * i, 0});
  return places;
}

TEST(AdhesionPlates, SkirtsAndBrimsAreWhereTheSettingsSay) {
  const Stages stages;
  std::mt19937 random(31);
  for (int trial = 0; trial < 500; ++trial) {
    SCOPED_TRACE(trial);
    // At least two lines: see kSingleLineOffNm.
    const double brim_mm = Uniform(random, 1.3, 5), separation_mm = Uniform(random, 0, 0.5);
    const double skirt_mm = Uniform(random, 0, 6), width_mm = Uniform(random, 0.4, 0.6);
    const int loops = 1 + trial % 3;
    const config::ResolvedPlate resolved =
        Resolved({{"brim_width", Mm(brim_mm)},
                  {"brim_separation", Mm(separation_mm)},
                  {"skirts", std::to_string(loops)},
                  {"skirt_distance", Mm(skirt_mm)},
                  {"first_layer_height", "0.2"},
                  {"first_layer_extrusion_width", Mm(width_mm)}});
    const MultiPolygon part = RandomIsland(random, {}, Uniform(random, 4, 12));
    Plate plate = PlateOf(part, RandomPlaces(random), 2, resolved.settings);
    const std::vector<std::vector<Path>> layers = stages.OnPlate(plate, resolved.settings);
    ASSERT_TRUE(layers[1].empty());
    ASSERT_GT(layers[0].size(), static_cast<size_t>(loops));

    const MultiPolygon outside = Filled(plate.parts);
    const double near = 1e6 * std::stod(Mm(separation_mm));
    const double far = near + 1e6 * std::stod(Mm(brim_mm));
    Reach brim, single_lines;
    MultiPolygon hull(1);
    for (const Path& path : std::span(layers[0]).subspan(static_cast<size_t>(loops))) {
      ASSERT_EQ(path.feature, Feature::kSkirt);
      for (size_t i = 0; i < path.points.size(); ++i)
        (IsSingleAt(path, i) ? single_lines : brim).AddPoint(path, i, outside);
    }
    EXPECT_NEAR(brim.least, near, kOffNm);
    EXPECT_NEAR(brim.most, far, kOffNm);
    EXPECT_GE(single_lines.least, near - kSingleLineOffNm);
    EXPECT_LE(single_lines.most, far + kSingleLineOffNm);

    // The skirt surrounds the hull of parts and brims. This is the parts' hull grown by the brim.
    std::vector<Point> corners;
    for (const PolygonWithHoles& island : plate.parts)
      corners.insert(corners.end(), island.outer.begin(), island.outer.end());
    hull[0].outer = ConvexHull(std::move(corners));
    const auto width = static_cast<double>(FromMm(std::stod(Mm(width_mm))));
    const auto spacing = static_cast<double>(Spacing(std::llround(width), 200'000));
    for (int i = 0; i < loops; ++i) {
      const Path& loop = layers[0][static_cast<size_t>(i)];
      EXPECT_TRUE(loop.closed);
      const double want =
          far + 1e6 * std::stod(Mm(skirt_mm)) + width / 2 + (loops - 1 - i) * spacing;
      for (const Point p : loop.points) ASSERT_NEAR(DistanceToRegion(p, hull), want, kOffNm);
    }
  }
}

// Tests brims in holes, around both, and at corners: none is closer or farther than the settings.
TEST(AdhesionPlates, BrimsOfAllKindsKeepTheirDistances) {
  const Stages stages;
  std::mt19937 random(32);
  const std::vector<std::string> types = {"inner_only", "outer_and_inner", "brim_ears"};
  int printed = 0;
  for (int trial = 0; trial < 250; ++trial) {
    SCOPED_TRACE(trial);
    const double brim_mm = Uniform(random, 0.9, 5), separation_mm = Uniform(random, 0, 0.5);
    const std::string& type = types[static_cast<size_t>(trial) % types.size()];
    const config::ResolvedPlate resolved = Resolved({{"brim_width", Mm(brim_mm)},
                                                     {"brim_separation", Mm(separation_mm)},
                                                     {"brim_type", type},
                                                     {"brim_ears_detection_length", "0.1"},
                                                     {"first_layer_height", "0.2"},
                                                     {"first_layer_extrusion_width", "0.45"}});
    Plate plate = PlateOf(RandomIsland(random, {}, Uniform(random, 4, 12)), RandomPlaces(random), 1,
                          resolved.settings);
    const std::vector<std::vector<Path>> layers = stages.OnPlate(plate, resolved.settings);
    const double near = 1e6 * std::stod(Mm(separation_mm));
    const double far = type == "brim_ears" ? 1e6 * std::stod(Mm(brim_mm)) + 0.1e6
                                           : near + 1e6 * std::stod(Mm(brim_mm));
    for (const Path& path : layers[0]) {
      Reach reach;
      reach.Add(path, plate.parts);
      EXPECT_GE(reach.least, near - Off(path)) << type;
      EXPECT_LE(reach.most, far + Off(path)) << type;
      ++printed;
    }
  }
  EXPECT_GT(printed, 1'000);
}

TEST(AdhesionPlates, RaftsReachAsFarAsTheSettingsSay) {
  const Stages stages;
  std::mt19937 random(33);
  for (int trial = 0; trial < 250; ++trial) {
    SCOPED_TRACE(trial);
    const int count = 1 + trial % 5;
    const double expansion_mm = Uniform(random, 0.5, 2), first_mm = Uniform(random, 0.6, 3);
    const config::ResolvedPlate resolved = Resolved({{"raft_layers", std::to_string(count)},
                                                     {"raft_expansion", Mm(expansion_mm)},
                                                     {"raft_first_layer_expansion", Mm(first_mm)},
                                                     {"layer_height", "0.2"},
                                                     {"first_layer_height", "0.2"},
                                                     {"first_layer_extrusion_width", "0.45"}});
    Plate plate = PlateOf(RandomIsland(random, {}, Uniform(random, 4, 8)), RandomPlaces(random), 2,
                          resolved.settings);
    const std::vector<std::vector<Path>> layers = stages.OnPlate(plate, resolved.settings);
    for (int i = 0; i < count; ++i) {
      Reach reach;
      const bool interface = i >= count / 2;
      for (const Path& path : layers[static_cast<size_t>(i)]) {
        ASSERT_EQ(path.feature, interface ? Feature::kSupportInterface : Feature::kSupport);
        reach.Add(path, plate.parts);
      }
      double want = 1e6 * std::stod(Mm(expansion_mm));
      if (i + 1 < count) want += i == 0 ? 1e6 * std::stod(Mm(first_mm)) : 0.5e6;
      // The line around the base marks its edge. The lines of an interface end somewhere near the
      // edge.
      EXPECT_NEAR(reach.most, want, interface ? 0.25e6 : kOffNm) << i;
      EXPECT_LE(reach.most, want + (interface ? 0.05e6 : kOffNm)) << i;
    }
    for (size_t i = static_cast<size_t>(count); i < layers.size(); ++i)
      EXPECT_TRUE(layers[i].empty());
  }
}

// Tests ranges as in a job: each range gets only its halo and has the same bytes as the whole.
TEST(AdhesionPlates, RangesDoNotMatter) {
  const config::ResolvedPlate resolved = Resolved(
      {{"raft_layers", "4"}, {"skirts", "2"}, {"skirt_height", "6"}, {"layer_height", "0.2"}});
  const JobSettings& settings = resolved.settings;
  std::mt19937 random(34);
  Plate plate = PlateOf(RandomIsland(random, {}, 9), RandomPlaces(random), 8, settings);
  auto plan =
      planning::MakeLocalPlanning()->Plan({}, {plate.layers, plate.copies}, MayOverlap(settings));
  ASSERT_TRUE(plan.ok()) << plan.status();
  TakePlan(*plan, plate.layers);
  const auto beading = beading::MakeLocalBeading();
  const auto infill = infill::MakeLocalInfill();
  const auto ordering = ordering::MakeLocalOrdering();
  const auto motion = motion::MakeLocalMotion();
  const LayerChain chain{*beading, *infill, *ordering, *motion};
  const auto count = static_cast<int32_t>(plate.layers.size());
  const JobFacts facts{count, {}, {}};
  const auto gcode_of = [&](int32_t size) {
    std::string gcode;
    for (int32_t first = 0; first < count; first += size) {
      const LayerRange range{first, std::min(count, first + size)};
      const LayerRange halo = WithHalo(plate.layers, range, HaloLayers(FdmOf(settings)));
      const FdmTask task{
          range,
          std::span(plate.layers)
              .subspan(static_cast<size_t>(halo.first), static_cast<size_t>(halo.size())),
          std::span(plan->layers)
              .subspan(static_cast<size_t>(range.first), static_cast<size_t>(range.size())),
          FdmShared{FdmOf(settings), plan->copies, facts}};
      const auto result = chain.Run({}, task);
      EXPECT_TRUE(result.ok()) << result.status();
      if (!result.ok()) return gcode;
      for (const LayerProgram& program : result->programs) gcode += program.gcode;
    }
    return gcode;
  };
  const std::string whole = gcode_of(count);
  for (const char* type : {"Skirt/Brim", "Support material\n", "Support material interface"})
    EXPECT_NE(whole.find(std::string(";TYPE:") + type), std::string::npos) << type;
  for (const int32_t size : {1, 3, 5}) EXPECT_EQ(gcode_of(size), whole) << size;
}

}  // namespace
}  // namespace slicefarm::adhesion_plates_test
