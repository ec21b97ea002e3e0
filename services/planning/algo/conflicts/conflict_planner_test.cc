#include "services/planning/algo/conflicts/conflict_planner.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/moved.h"
#include "common/geometry/text_format_test.h"
#include "common/model/options/planning_options.h"

namespace slicefarm::planning::conflict_planner_test {
namespace {

constexpr Coord kMm = kNmPerMm;
constexpr const char* kSquare = "(-5 -5, 5 -5, 5 5, -5 5)";
const std::vector<std::string> kNames = {"cup", "lid"};

Point At(double x_mm, double y_mm = 0) { return {FromMm(x_mm), FromMm(y_mm)}; }

/// Stack of layers that all have the same outline.
struct Tower {
  Stack stack;
  const char* outline = kSquare;
  double bottom_mm = 0;
  double top_mm = 1;
  double height_mm = 1;
};

/// Returns layers that end wherever a layer of some tower ends.
std::vector<SlicedLayer> LayersOf(const std::vector<Tower>& towers) {
  std::map<Coord, std::vector<ObjectSection>> by_top;
  for (const Tower& tower : towers) {
    for (double top = tower.bottom_mm + tower.height_mm; top <= tower.top_mm + 1e-9;
         top += tower.height_mm) {
      ObjectSection section;
      section.stack = tower.stack;
      section.height_nm = FromMm(tower.height_mm);
      section.z_nm = FromMm(top);
      section.regions.push_back({Role::kPart, 0, 0, MakePolygonsOrDie(tower.outline)});
      by_top[section.z_nm].push_back(section);
    }
  }
  std::vector<SlicedLayer> layers;
  Coord below = 0;
  for (auto& [top, sections] : by_top) {
    layers.push_back(
        {{static_cast<int32_t>(layers.size()), top, top - below}, std::move(sections)});
    below = top;
  }
  return layers;
}

absl::Status Conflict(const std::vector<Tower>& towers, std::vector<PlacedCopy> copies,
                      JobPlan plan = {}, PlanningOptions options = {}) {
  for (PlacedCopy& copy : copies)
    copy.footprint = Moved(MakePolygonsOrDie(kSquare), copy.shift)[0].outer;
  ConflictPlanner planner(options, copies, kNames);
  OpenLayers layers;
  for (const SlicedLayer& layer : LayersOf(towers)) planner.Look(layer, layers.Add());
  return planner.Finish({}, layers, plan);
}

/// Returns "first | second" of the error, or an empty string.
std::string Met(const absl::Status& status) {
  if (status.ok()) return "";
  const ErrorDetail detail = DetailOf(status);
  EXPECT_EQ(detail.reason, Reason::kPathsConflict);
  return detail.metadata.at("first") + " | " + detail.metadata.at("second");
}

constexpr Stack kSupportOfCup(2, 0, StackKind::kSupport);
constexpr Stack kSupportOfLid(3, 1, StackKind::kSupport);
constexpr Stack kRaft(4, kPlateObject, StackKind::kRaft);
constexpr Stack kOtherRaft(5, kPlateObject, StackKind::kRaft);

TEST(ConflictPlanner, NamesWhatMeets) {
  struct Case {
    const char* name;
    std::vector<Tower> towers;
    std::vector<PlacedCopy> copies;
    const char* met;
  };
  const std::vector<PlacedCopy> apart = {{0, At(0), {}}, {1, At(20), {}}};
  const std::vector<PlacedCopy> close = {{0, At(0), {}}, {1, At(9), {}}};
  const char* wide = "(-18 -1, -6 -1, -6 1, -18 1)";
  const char* ring = "(-20 -20, 20 -20, 20 20, -20 20) (-10 -10, 10 -10, 10 10, -10 10)";
  const Case cases[] = {
      {"Apart", {{0}, {1}}, apart, ""},
      {"Touching", {{0}, {1}}, {{0, At(0), {}}, {1, At(10), {}}}, ""},
      {"Parts", {{0}, {1}}, close, "cup | lid"},
      {"Copies", {{0}}, {{0, At(0), {}}, {0, At(9), {}}}, "cup (copy 1) | cup (copy 2)"},
      {"AtTheSamePlace", {{0}}, {{0, At(0), {}}, {0, At(0), {}}}, "cup (copy 1) | cup (copy 2)"},
      {"OneInTheOthersRing", {{0}, {1, ring}}, {{0, At(0), {}}, {1, At(1), {}}}, ""},
      {"OneAboveTheOther", {{0, kSquare, 0, 2}, {1, kSquare, 2, 4}}, close, ""},
      {"LayersOfOtherHeights",
       {{0, kSquare, 0, 3, 1.5}, {1, kSquare, 2.8, 3.2, 0.4}},
       close,
       "cup | lid"},
      {"ThickLayerOverThinOnes",
       {{0, kSquare, 0, 0.6, 0.1}, {1, kSquare, 0.5, 2.5, 2}},
       close,
       "cup | lid"},
      {"SupportInTheOtherPart",
       {{0}, {1}, {kSupportOfLid, wide}},
       apart,
       "cup | the supports of lid"},
      {"SupportsOfBoth",
       {{0, kSquare, 2, 3}, {1, kSquare, 2, 3}, {kSupportOfCup}, {kSupportOfLid, wide}},
       apart,
       "the supports of cup | the supports of lid"},
      {"ItsOwnSupport", {{0}, {kSupportOfCup}}, {{0, At(0), {}}}, ""},
      {"SupportInTheNextCopy",
       {{0}, {kSupportOfCup, wide}},
       {{0, At(0), {}}, {0, At(20), {}}},
       "cup (copy 1) | the supports of cup (copy 2)"},
      {"RaftBelowItsPart", {{kRaft, ring}, {0, kSquare, 1, 2}}, {{0, At(12), {}}}, ""},
      {"RaftInAPartWithoutOne", {{kRaft, ring}, {0}}, {{0, At(12), {}}}, "a raft | cup"},
      {"Rafts", {{kRaft, ring}, {kOtherRaft, kSquare}}, apart, ""},
      {"RaftsThatMeet", {{kRaft}, {kOtherRaft}}, apart, "a raft | a raft"},
  };
  PlanningOptions options;
  options.objects.resize(2);
  options.objects[0].raft.heights.layers = 1;
  for (const Case& c : cases)
    EXPECT_EQ(Met(Conflict(c.towers, c.copies, {}, options)), c.met) << c.name;
}

TEST(ConflictPlanner, SaysWhere) {
  const ErrorDetail detail = DetailOf(Conflict({{0, kSquare, 0, 3}, {1, kSquare, 1, 3}},
                                               {{0, At(100, 50), {}}, {1, At(109, 50), {}}}));
  EXPECT_EQ(detail.metadata.at("z_mm"), "2.00");
  EXPECT_NEAR(std::stod(detail.metadata.at("x_mm")), 104.5, 0.51);
  EXPECT_NEAR(std::stod(detail.metadata.at("y_mm")), 50, 5.01);
}

JobPlan WithBrim(int32_t object, const char* outline) {
  JobPlan plan;
  AddedStack& added = plan.stacks.emplace_back();
  added.stack = Stack(4, object, StackKind::kBrim);
  ObjectSection& section = added.sections.emplace_back();
  section.stack = added.stack;
  section.height_nm = section.z_nm = kMm;
  section.regions.push_back({Role::kBrim, 0, 0, MakePolygonsOrDie(outline)});
  return plan;
}

TEST(ConflictPlanner, LooksAtBrims) {
  const std::vector<Tower> towers = {{0}, {1}};
  const std::vector<PlacedCopy> copies = {{0, At(0), {}}, {1, At(20), {}}};
  const char* fits = "(-8 -8, 8 -8, 8 8, -8 8) (-5 -5, 5 -5, 5 5, -5 5)";
  const char* reaches = "(-16 -8, 16 -8, 16 8, -16 8) (-5 -5, 5 -5, 5 5, -5 5)";
  EXPECT_EQ(Met(Conflict(towers, copies, WithBrim(kPlateObject, fits))), "");
  EXPECT_EQ(Met(Conflict(towers, copies, WithBrim(kPlateObject, reaches))), "a brim | lid");
  EXPECT_EQ(Met(Conflict(towers, copies, WithBrim(0, fits))), "");
  EXPECT_EQ(Met(Conflict(towers, copies, WithBrim(0, reaches))), "the brim of cup | lid");
}

TEST(ConflictPlanner, LooksAtTheSkirt) {
  const std::vector<PlacedCopy> copies = {{0, At(0), {}}};
  const auto with_skirt = [&](const char* loop, bool closed, std::vector<Tower> towers) {
    JobPlan plan;
    Path& line = plan.skirt.loops.emplace_back();
    line.points = MakeLineOrDie(loop);
    line.widths_nm = {FromMm(0.4)};
    line.closed = closed;
    plan.skirt.layers = 1;
    PlanningOptions options;
    options.skirt.loops = 1;
    options.skirt.height_layers = 1;
    return Met(Conflict(towers, copies, plan, options));
  };
  EXPECT_EQ(with_skirt("(-7 -7, 7 -7, 7 7, -7 7)", true, {{0}}), "");
  EXPECT_EQ(with_skirt("(-7 -7, 4 -7, 4 7, -7 7)", true, {{0}}), "the skirt | cup");
  EXPECT_EQ(with_skirt("(4 -7, 4 7)", false, {{0}}), "the skirt | cup");
  EXPECT_EQ(with_skirt("(4 -7, 4 7)", false, {{1}, {0, kSquare, 1, 2}}), "") << "it is lower";
}

TEST(ConflictPlanner, CanBeCancelled) {
  const std::vector<PlacedCopy> copies = {{0, At(0), {}}};
  const PlanningOptions options;
  ConflictPlanner planner(options, copies, kNames);
  OpenLayers layers;
  JobPlan plan = WithBrim(kPlateObject, kSquare);
  EXPECT_TRUE(absl::IsCancelled(planner.Finish(CancelToken([] { return true; }), layers, plan)));
}

}  // namespace
}  // namespace slicefarm::planning::conflict_planner_test
