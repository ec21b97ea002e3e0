#include "services/planning/algo/supports/generator/support_planner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "common/geometry/moved.h"
#include "common/geometry/offset/offset.h"
#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::support_planner_test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

MultiPolygon Disc(double x, double y, double radius) {
  Polygon ring;
  for (int i = 0; i < 48; ++i)
    ring.push_back({FromMm(x + radius * std::cos(i * std::numbers::pi / 24)),
                    FromMm(y + radius * std::sin(i * std::numbers::pi / 24))});
  return radius > 0 ? MultiPolygon{{ring, {}}} : MultiPolygon();
}

MultiPolygon FourLegs() {
  return Union(Union(BoxOf(0, 0, 3, 3), BoxOf(27, 0, 30, 3)),
               Union(BoxOf(0, 17, 3, 20), BoxOf(27, 17, 30, 20)));
}

struct Shape {
  std::string name;
  int layers;
  MultiPolygon (*outline)(double z);
};

const Shape kShapes[] = {
    {"T", 60, [](double z) { return z < 10 ? BoxOf(8, 8, 12, 12) : BoxOf(0, 0, 20, 20); }},
    {"Arch", 60,
     [](double z) {
       const double half = z < 8 ? std::sqrt(64 - z * z) : 0;
       return half > 0.1 ? Difference(BoxOf(-12, 0, 12, 6), BoxOf(-half, -1, half, 7))
                         : BoxOf(-12, 0, 12, 6);
     }},
    {"Table", 60, [](double z) { return z < 9 ? FourLegs() : BoxOf(0, 0, 30, 20); }},
    {"InvertedCone", 50, [](double z) { return Disc(0, 0, 2 + 1.6 * z); }},
    {"Sphere", 75,
     [](double z) { return Disc(0, 0, std::sqrt(std::max(0.0, 56.25 - (z - 7.5) * (z - 7.5)))); }},
    {"PartOverPart", 60,
     [](double z) {
       if (z < 3) return BoxOf(-3, -3, 23, 23);
       return z < 9 ? BoxOf(-3, -3, 3, 23) : BoxOf(-3, -3, 15, 23);
     }},
    {"LowPlate", 40, [](double z) { return z < 6 ? BoxOf(0, 0, 4, 4) : BoxOf(-20, -14, 24, 18); }},
    {"FromLayerTwo", 20,
     [](double z) { return z < 0.4 ? BoxOf(0, 0, 10, 10) : BoxOf(-8, 0, 18, 10); }},
    {"FromLayerOne", 20,
     [](double z) { return z < 0.2 ? BoxOf(0, 0, 10, 10) : BoxOf(-8, 0, 18, 10); }},
    {"SlantedSlab", 75, [](double z) { return BoxOf(2.4 * z, 0, 2.4 * z + 8, 10); }},
    {"HangingPoint", 60,
     [](double z) {
       const MultiPolygon arm = BoxOf(0, 0, 20, 4), post = BoxOf(0, 0, 4, 4);
       if (z > 10) return arm;
       return z > 6 ? Union(post, Disc(17, 2, (z - 6) * 0.5)) : post;
     }},
};

constexpr SupportStyle kStyles[] = {SupportStyle::kGrid, SupportStyle::kSnug, SupportStyle::kTree};
constexpr const char* kStyleNames[] = {"Grid", "Snug", "Tree"};

SupportPlan Plan(const SupportProblem& problem, const SupportOptions& options, int threads = 1) {
  auto plan = PlanSupports(problem, options, threads, CancelToken());
  EXPECT_TRUE(plan.ok());
  return *std::move(plan);
}

MultiPolygon All(const SupportLayer& layer) {
  MultiPolygon all;
  for (const SupportRegion& region : layer.regions) all = Union(all, region.outlines);
  return all;
}

double DistanceTo(const MultiPolygon& region, Point p) {
  double distance = 1e18;
  for (const PolygonWithHoles& island : region) {
    if (Locate(p, island) != Side::kOutside) return 0;
    ForEachRing({island}, [&](const Polygon& ring) {
      for (size_t i = 0; i < ring.size(); ++i)
        distance = std::min(distance, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
    });
  }
  return distance;
}

class SupportsTest : public testing::TestWithParam<std::tuple<Shape, SupportStyle>> {
 protected:
  SupportsTest() : stack_(shape().layers, shape().outline) {
    options_.style = std::get<1>(GetParam());
  }
  static const Shape& shape() { return std::get<0>(GetParam()); }
  /// A part with its overhang one layer above the bed leaves no height for supports.
  static bool has_room() { return shape().name != "FromLayerOne"; }

  TestStack stack_;
  SupportOptions options_;
};

TEST_P(SupportsTest, KeepTheirDistance) {
  const SupportProblem problem = stack_.Problem();
  const SupportPlan plan = Plan(problem, options_);
  ASSERT_EQ(plan.layers.empty(), !has_room());
  for (const SupportLayer& layer : plan.layers) {
    const MultiPolygon all = All(layer);
    const Coord bottom = layer.top_nm - layer.height_nm;
    for (const PartLayer& part : problem.part) {
      const bool beside = part.bottom_nm() < layer.top_nm && part.top_nm > bottom;
      const bool above = !beside && part.bottom_nm() >= layer.top_nm &&
                         part.bottom_nm() < layer.top_nm + options_.top_gap_nm;
      const bool below =
          !beside && part.top_nm <= bottom && part.top_nm > bottom - options_.bottom_gap_nm;
      if (!beside && !above && !below) continue;
      const MultiPolygon kept = beside ? Offset(*part.outlines, options_.xy_gap_nm - 15'000,
                                                {.join = Join::kRound, .arc_tolerance_nm = 20'000})
                                       : Offset(*part.outlines, -10'000);
      EXPECT_LT(AreaMm2(Intersection(all, kept)), 1e-3) << "at " << ToMm(layer.top_nm);
    }
  }
}

TEST_P(SupportsTest, RestOnSomething) {
  const SupportProblem problem = stack_.Problem();
  const SupportPlan plan = Plan(problem, options_);
  ASSERT_EQ(plan.layers.empty(), !has_room());
  for (size_t i = 0; i < plan.layers.size(); ++i) {
    const SupportLayer& layer = plan.layers[i];
    if (layer.first) continue;
    const Coord bottom = layer.top_nm - layer.height_nm;
    MultiPolygon rest;
    if (i > 0 && plan.layers[i - 1].top_nm == bottom) rest = All(plan.layers[i - 1]);
    for (const PartLayer& part : problem.part)
      if (part.top_nm <= bottom && part.top_nm > bottom - 450'000)
        rest = Union(rest, *part.outlines);
    // Sheets span from tip to tip: gaps up to 3.2 mm are closed.
    const OffsetOptions round = {.join = Join::kRound, .arc_tolerance_nm = 20'000};
    const MultiPolygon near = options_.style == SupportStyle::kTree
                                  ? Offset(Offset(rest, 1'600'000, round), -450'000, round)
                                  : Offset(rest, 1'150'000, round);
    for (const PolygonWithHoles& island : All(layer)) {
      EXPECT_FALSE(Intersection({island}, rest).empty()) << "at " << ToMm(layer.top_nm);
      const MultiPolygon beyond = Difference({island}, near);
      EXPECT_LT(AreaMm2(beyond), 0.01) << "at " << ToMm(layer.top_nm);
    }
  }
}

/// Returns the loops of hollow branches, along the middle of their beads. For filled regions it
/// returns the outlines.
std::vector<Polygon> Beads(const SupportLayer& layer, Coord width_nm) {
  std::vector<Polygon> beads;
  for (const SupportRegion& region : layer.regions) {
    const bool thick = region.role == SupportRole::kThickBranch;
    for (Coord i = 0; i < (thick ? 2 : 1); ++i)
      for (Polygon& ring : Rings(Offset(region.outlines, -width_nm / 2 - i * width_nm)))
        beads.push_back(std::move(ring));
  }
  return beads;
}

/// Returns the area that the beads of a layer cover. Branches are hollow, except on the bed.
MultiPolygon Covered(const SupportLayer& layer, Coord width_nm) {
  MultiPolygon covered;
  for (const SupportRegion& region : layer.regions) {
    const Coord loops = region.role == SupportRole::kThickBranch ? 2 : 1;
    const bool hollow = !layer.first && (loops == 2 || region.role == SupportRole::kBranch);
    covered = Union(covered,
                    hollow ? Difference(region.outlines, Offset(region.outlines, -loops * width_nm))
                           : region.outlines);
  }
  return covered;
}

/// Returns the longest run of a ring that is farther than a millimetre from a region.
double LongestOff(const Polygon& ring, const MultiPolygon& region) {
  double run = 0, longest = 0;
  for (int turn = 0; turn < 2; ++turn) {  // two turns: the run may cross the ring's start
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      run = DistanceTo(region, a) <= 1e6 ? 0 : run + Distance(a, b);
      longest = std::max(longest, run);
    }
  }
  return longest;
}

/// Tests that each bead rests on beads. The outlines alone do not show this.
TEST_P(SupportsTest, BeadsLieOnBeads) {
  const SupportProblem problem = stack_.Problem();
  const SupportPlan plan = Plan(problem, options_);
  ASSERT_EQ(plan.layers.empty(), !has_room());
  for (size_t i = 1; i < plan.layers.size(); ++i) {
    const SupportLayer& layer = plan.layers[i];
    const Coord bottom = layer.top_nm - layer.height_nm;
    MultiPolygon supporters;
    if (plan.layers[i - 1].top_nm == bottom)
      supporters = Covered(plan.layers[i - 1], options_.width_nm);
    for (const PartLayer& part : problem.part)
      if (part.top_nm <= bottom && part.top_nm > bottom - 450'000)
        supporters = Union(supporters, *part.outlines);
    for (const Polygon& bead : Beads(layer, options_.width_nm))
      EXPECT_LE(LongestOff(bead, supporters), 2'500'000) << "at " << ToMm(layer.top_nm);
  }
}

/// Checks on points that every steep place has support, or the layer below, near it.
TEST_P(SupportsTest, CarryAllThatIsSteep) {
  options_.skip_bridges = false;
  const SupportProblem problem = stack_.Problem();
  const SupportPlan plan = Plan(problem, options_);
  for (const SupportFinding& finding : plan.findings) {
    EXPECT_EQ(finding.kind, SupportFinding::Kind::kStartsInAir);
    EXPECT_TRUE(finding.above_supports);
  }
  const double reach = options_.style == SupportStyle::kTree ? 1e6 : 0.5e6;
  for (size_t i = 3; i < problem.part.size(); ++i) {
    const Coord top = problem.part[i].bottom_nm() - options_.top_gap_nm;
    MultiPolygon supporters = *problem.part[i - 1].outlines;
    const MultiPolygon support = SupportAt(plan, top);
    supporters.insert(supporters.end(), support.begin(), support.end());
    const Box box = Bounds(*problem.part[i].outlines);
    for (Coord x = box.min.x + 50'000; x < box.max.x; x += 370'000) {
      for (Coord y = box.min.y + 50'000; y < box.max.y; y += 370'000) {
        const Point p{x, y};
        if (DistanceTo(*problem.part[i].outlines, p) > 0) continue;
        if (DistanceTo(*problem.part[i - 1].outlines, p) < 300'000) continue;
        EXPECT_LE(DistanceTo(supporters, p), reach) << ToText(p) << " at " << ToMm(top);
      }
    }
  }
}

TEST_P(SupportsTest, AreTheSameForAnyThreads) {
  const SupportProblem problem = stack_.Problem();
  const SupportPlan plan = Plan(problem, options_);
  EXPECT_EQ(plan, Plan(problem, options_, 5));
}

/// Moves, rotates and mirrors the part: the volume stays the same except for the effect of pixels
/// and cells.
TEST_P(SupportsTest, DoNotCareWhereAndHowThePartStands) {
  const double volume = VolumeMm3(Plan(stack_.Problem(), options_));
  const auto changed = [&](auto change) {
    TestStack other = stack_;
    for (MultiPolygon& outline : other.outlines()) {
      MultiPolygon moved;
      for (const PolygonWithHoles& island : outline) {
        std::vector<Polygon> rings;
        ForEachRing({island}, [&](Polygon ring) {
          for (Point& p : ring) p = change(p);
          rings.push_back(std::move(ring));
        });
        const MultiPolygon one = Union(rings, FillRule::kEvenOdd);
        moved.insert(moved.end(), one.begin(), one.end());
      }
      outline = std::move(moved);
    }
    return VolumeMm3(Plan(other.Problem(), options_));
  };
  const double exact = 1e-8 * volume;  // crossings of edges are rounded to whole nm
  const double near = (options_.style == SupportStyle::kSnug ? 0.12 : 0.4) * volume + 15;
  EXPECT_NEAR(changed([](Point p) { return p + Point{25'000'000, -50'000'000}; }), volume, exact);
  EXPECT_NEAR(changed([](Point p) { return p + Point{333'333, 1'111'111}; }), volume, near);
  EXPECT_NEAR(changed([](Point p) { return Point{-p.y, p.x}; }), volume, near);
  EXPECT_NEAR(changed([](Point p) { return Point{-p.x, p.y}; }), volume, near);
}

INSTANTIATE_TEST_SUITE_P(Shapes, SupportsTest,
                         testing::Combine(testing::ValuesIn(kShapes), testing::ValuesIn(kStyles)),
                         [](const auto& info) {
                           return std::get<0>(info.param).name +
                                  kStyleNames[static_cast<int>(std::get<1>(info.param))];
                         });

class StyleTest : public testing::TestWithParam<SupportStyle> {
 protected:
  StyleTest() { options_.style = GetParam(); }
  SupportOptions options_;
};

INSTANTIATE_TEST_SUITE_P(Styles, StyleTest, testing::ValuesIn(kStyles), [](const auto& info) {
  return std::string(kStyleNames[static_cast<int>(info.param)]);
});

TEST_P(StyleTest, UprightPartsNeedNone) {
  const TestStack box(50, [](double) { return BoxOf(0, 0, 10, 10); });
  const SupportPlan plan = Plan(box.Problem(), options_);
  EXPECT_THAT(plan.layers, IsEmpty());
  EXPECT_THAT(plan.findings, IsEmpty());
}

TEST_P(StyleTest, NothingAtAllIsNoProblem) {
  EXPECT_THAT(Plan(SupportProblem(), options_).layers, IsEmpty());
  const TestStack nothing(5, [](double) { return MultiPolygon(); });
  EXPECT_THAT(Plan(nothing.Problem(), options_).layers, IsEmpty());
}

TEST_P(StyleTest, TopsLieAtTheGap) {
  const TestStack stack(60, kShapes[0].outline);
  for (const Coord gap : {Coord{0}, Coord{100'000}, Coord{150'000}, Coord{250'000}}) {
    options_.top_gap_nm = gap;
    const SupportPlan plan = Plan(stack.Problem(), options_);
    // Branches end with a layer of the part if this layer is no more than half a layer lower.
    const bool down = options_.style == SupportStyle::kTree && gap > 0 && gap < 200'000;
    EXPECT_EQ(plan.layers.back().top_nm, 10'000'000 - (down ? 200'000 : gap));
    EXPECT_NEAR(AreaMm2(All(plan.layers.back())), 400 - 16, 40) << gap;
  }
}

TEST_P(StyleTest, OnBedOnlyLeavesWhatStandsOverThePart) {
  const TestStack stack(60, kShapes[5].outline);  // a shelf over a larger plate
  options_.bed_only = true;
  const SupportPlan plan = Plan(stack.Problem(), options_);
  ASSERT_THAT(plan.findings, SizeIs(1));
  EXPECT_EQ(plan.findings[0].kind, SupportFinding::Kind::kUnsupported);
  EXPECT_EQ(plan.findings[0].bottom_nm, 9'000'000);
  EXPECT_GT(plan.findings[0].area_mm2, 100);
}

// A marked area gets support even if all supports must rest on the bed. Branches still rest on the
// bed only.
TEST_P(StyleTest, OnBedOnlyWhatIsMarkedMayStandOnThePart) {
  const TestStack stack(60, kShapes[5].outline);
  options_.bed_only = true;
  SupportProblem problem = stack.Problem();
  const MultiPolygon left = BoxOf(-100, -100, 5, 100);
  problem.part[45].enforcers = &left;
  const SupportPlan plan = Plan(problem, options_);
  const double unsupported = plan.findings.empty() ? 0 : plan.findings[0].area_mm2;
  const SupportPlan without = Plan(stack.Problem(), options_);
  ASSERT_THAT(without.findings, SizeIs(1));
  if (options_.style == SupportStyle::kTree) {
    EXPECT_NEAR(unsupported, without.findings[0].area_mm2, 1);
  } else {
    EXPECT_LT(unsupported, 0.8 * without.findings[0].area_mm2);
    EXPECT_GT(unsupported, 0) << "the rest of it is not marked";
  }
}

TEST_P(StyleTest, IslandsInTheAirAreToldOf) {
  const TestStack stack(60, [](double z) {
    return z < 5 ? BoxOf(0, 0, 5, 5) : Union(BoxOf(0, 0, 5, 5), BoxOf(10, 0, 14, 4));
  });
  const SupportPlan plan = Plan(stack.Problem(), options_);
  ASSERT_THAT(plan.findings, SizeIs(1));
  EXPECT_EQ(plan.findings[0].kind, SupportFinding::Kind::kStartsInAir);
  EXPECT_EQ(plan.findings[0].layer, 25);
  EXPECT_EQ(plan.findings[0].place, (Point{12'000'000, 2'000'000}));
  EXPECT_NEAR(plan.findings[0].area_mm2, 16, 1e-9);
  EXPECT_TRUE(plan.findings[0].above_supports);
  EXPECT_EQ(IslandsInAir(stack.Problem(), 1, CancelToken()).size(), 1u);
}

/// The test plate: a wing of one object above a box of another.
TEST_P(StyleTest, KeepOffOtherObjects) {
  const TestStack wing(60,
                       [](double z) { return z < 10 ? BoxOf(0, 0, 5, 20) : BoxOf(0, 0, 30, 20); });
  const TestStack box(30, [](double) { return BoxOf(14, -2, 24, 22); });
  SupportProblem problem = wing.Problem();
  problem.others.push_back(box.Layers());
  const SupportPlan plan = Plan(problem, options_);
  EXPECT_THAT(plan.layers, testing::Not(IsEmpty()));
  for (const SupportLayer& layer : plan.layers) {
    if (layer.top_nm > 6'000'000) continue;
    EXPECT_LT(AreaMm2(Intersection(All(layer), BoxOf(13.8, -2.2, 24.2, 22.2))), 1e-6);
  }
  if (GetParam() != SupportStyle::kTree) {  // branches can bypass it
    EXPECT_FALSE(plan.findings.empty());
  }
}

TEST_P(StyleTest, StayOnTheBed) {
  const TestStack stack(60, kShapes[0].outline);
  SupportProblem problem = stack.Problem();
  problem.bed = BoxOf(-1, -1, 19, 21);
  const SupportPlan plan = Plan(problem, options_);
  ASSERT_FALSE(plan.layers.empty());
  for (const SupportLayer& layer : plan.layers)
    EXPECT_LT(AreaMm2(Difference(All(layer), problem.bed)), 1e-6);
}

TEST_P(StyleTest, BlockersAndEnforcers) {
  const TestStack stack(60, kShapes[0].outline);
  const MultiPolygon left = BoxOf(-5, -5, 8, 25);
  SupportProblem problem = stack.Problem();
  problem.part[50].blockers = &left;
  SupportPlan plan = Plan(problem, options_);
  EXPECT_LT(AreaMm2(Intersection(All(plan.layers.back()), BoxOf(0, 0, 6, 20))), 0.5);
  EXPECT_THAT(plan.findings, IsEmpty());
  problem.part[50].blockers = nullptr;
  problem.part[50].enforcers = &left;
  options_.automatic = false;
  plan = Plan(problem, options_);
  EXPECT_NEAR(AreaMm2(Intersection(All(plan.layers.back()), left)), 160, 8);
  EXPECT_LT(AreaMm2(Intersection(All(plan.layers.back()), BoxOf(11, 0, 20, 20))), 1);
}

TEST_P(StyleTest, LayersOfDifferentHeights) {
  TestStack stack(60, kShapes[4].outline);
  SupportProblem problem = stack.Problem();
  Coord top = 0;
  for (size_t i = 0; i < problem.part.size(); ++i) {
    problem.part[i].height_nm = i % 3 == 0 ? 100'000 : i % 3 == 1 ? 250'000 : 180'000;
    top += problem.part[i].height_nm;
    problem.part[i].top_nm = top;
  }
  const SupportPlan plan = Plan(problem, options_);
  EXPECT_THAT(plan.layers, testing::Not(IsEmpty()));
  for (const SupportFinding& finding : plan.findings)
    EXPECT_EQ(finding.kind, SupportFinding::Kind::kStartsInAir);
  for (size_t i = 1; i < plan.layers.size(); ++i)
    EXPECT_GE(plan.layers[i].height_nm, options_.min_layer_height_nm);
}

TEST_P(StyleTest, CanBeCancelled) {
  const TestStack stack(60, kShapes[0].outline);
  for (int polls = 0; polls < 200; polls = polls * 2 + 1) {
    int left = polls;
    const auto plan =
        PlanSupports(stack.Problem(), options_, 1, CancelToken([&left] { return --left < 0; }));
    EXPECT_EQ(plan.status().code(), absl::StatusCode::kCancelled) << polls;
  }
}

/// A fin of 0.3 mm, 20 mm long, 16 mm above the bed. A wall of one bead of this height would fall
/// over.
TEST(SupportPlanner, ColumnsUnderFinsAreClosedCells) {
  const TestStack stack(85, [](double z) {
    const MultiPolygon post = BoxOf(-6, 0, 0, 6);
    return z < 16 ? post : Union(post, BoxOf(0, 1.4, 20, 1.7));
  });
  for (const SupportStyle style : {SupportStyle::kGrid, SupportStyle::kSnug}) {
    SupportOptions options;
    options.style = style;
    const SupportPlan plan = Plan(stack.Problem(), options);
    ASSERT_GT(plan.layers.size(), 60u);
    for (const SupportLayer& layer : plan.layers) {
      if (layer.top_nm > FromMm(11)) continue;
      const MultiPolygon all = All(layer);
      ASSERT_FALSE(all.empty()) << layer.top_nm;
      for (const PolygonWithHoles& island : all)
        EXPECT_FALSE(Offset({island}, -650'000).empty()) << layer.top_nm;
    }
    EXPECT_TRUE(std::ranges::none_of(
        plan.findings, [](const SupportFinding& finding) { return !finding.above_supports; }));
  }
}

TEST(PlanSupports, ColumnsGrowByTheExpansion) {
  const TestStack stack(60, kShapes[0].outline);
  const auto area = [&](SupportStyle style, Coord expansion_nm) {
    SupportOptions options;
    options.on = true;
    options.style = style;
    options.expansion_nm = expansion_nm;
    const SupportPlan plan = Plan(stack.Problem(), options);
    EXPECT_FALSE(plan.layers.empty());
    return plan.layers.empty() ? 0 : AreaMm2(SupportAt(plan, plan.layers[20].top_nm));
  };
  EXPECT_GT(area(SupportStyle::kSnug, 1'000'000), area(SupportStyle::kSnug, 0) + 60);
  EXPECT_LT(area(SupportStyle::kSnug, -1'000'000), area(SupportStyle::kSnug, 0) - 40);
  EXPECT_EQ(area(SupportStyle::kTree, 1'000'000), area(SupportStyle::kTree, 0));
}

}  // namespace
}  // namespace slicefarm::planning::support_planner_test
