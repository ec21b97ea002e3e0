#include "services/motion/algo/toolpath/toolpath_builder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "common/gcode/gcode_text.h"
#include "common/model/bead_section.h"
#include "common/model/options/motion_options.h"
#include "common/model/options/region_motion.h"
#include "common/model/options/tool_row.h"
#include "common/model/paths_test.h"

namespace slicefarm::motion::toolpath_builder_test {
namespace {

using ::testing::ElementsAre;

constexpr LayerFrame kFrame{1, 400'000, 200'000};

Path Line(std::string_view points, std::vector<Coord> widths_nm = {450'000}) {
  Path path = MakePathOrDie(points);
  path.widths_nm = std::move(widths_nm);
  return path;
}

struct Built {
  Toolpath path;
  ProgramStats stats;
};

Built Build(const std::vector<Path>& paths, const MotionOptions& options = {},
            Coord bead_height_nm = kFrame.height_nm) {
  ToolpathBuilder builder(options, kFrame, bead_height_nm);
  for (const Path& path : paths) builder.Add(path);
  Toolpath toolpath = builder.Finish();
  return {std::move(toolpath), builder.stats()};
}

std::vector<MoveKind> Kinds(const Toolpath& path) {
  std::vector<MoveKind> kinds;
  for (const Move& move : path.moves) kinds.push_back(move.kind);
  return kinds;
}

int64_t Printed(const Toolpath& path) {
  int64_t units = 0;
  for (const Move& move : path.moves) units += move.kind == MoveKind::kPrint ? move.filament : 0;
  return units;
}

double FilamentArea(const MotionOptions& options) {
  return std::numbers::pi / 4 * options.tool().filament_diameter_mm *
         options.tool().filament_diameter_mm;
}

TEST(ToolpathBuilder, NothingToPrint) {
  EXPECT_TRUE(Build({}).path.moves.empty());
  EXPECT_EQ(Build({}).path.approach, Toolpath::kNone);
}

TEST(ToolpathBuilder, OneLineFromAndToTheCanonicalState) {
  const Built built = Build({Line("(10 10, 20 10)")});
  EXPECT_THAT(Kinds(built.path), ElementsAre(MoveKind::kLift, MoveKind::kTravel, MoveKind::kRestart,
                                             MoveKind::kPrint, MoveKind::kRetract));
  EXPECT_EQ(built.path.approach, 1);
  EXPECT_EQ(built.path.start_z_um, 200);
  EXPECT_EQ(built.path.moves[0].z_um, 400);
  EXPECT_EQ(built.path.moves[2].filament, 80'000);
  EXPECT_EQ(built.path.moves[4].filament, -80'000);
  EXPECT_EQ(built.stats.travels, 1);
  EXPECT_EQ(built.stats.retractions, 1);
  EXPECT_EQ(built.stats.travel_mm, 0);
}

TEST(ToolpathBuilder, TheFirstRestartFeedsWhatTheLayerBelowRetracted) {
  const MotionOptions options;
  for (const double pulled_mm : {0.0, 0.3, 2.0}) {
    ToolpathBuilder builder(options, kFrame, kFrame.height_nm);
    builder.BeginRetracted(pulled_mm);
    builder.Add(Line("(10 10, 20 10)"));
    builder.Add(Line("(50 10, 60 10)"));
    std::vector<int32_t> restarts, retractions;
    for (const Move& move : builder.Finish().moves) {
      if (move.kind == MoveKind::kRestart) restarts.push_back(move.filament);
      if (move.kind == MoveKind::kRetract) retractions.push_back(move.filament);
    }
    std::vector<int32_t> fed = {80'000};
    if (pulled_mm > 0) fed.insert(fed.begin(), static_cast<int32_t>(pulled_mm * 1e5));
    EXPECT_EQ(restarts, fed) << pulled_mm;
    EXPECT_THAT(retractions, ElementsAre(-80'000, -80'000)) << pulled_mm;
  }
}

std::vector<MoveKind> KindsAsLeft(const Travel& entry,
                                  const std::optional<ExitTravel>& exit_travel) {
  MotionOptions options;
  options.tool().retraction.lift_mm = 0.3;
  ToolpathBuilder builder(options, kFrame, kFrame.height_nm);
  builder.BeginAsLeft();
  builder.Add(Line("(10 10, 20 10)"), entry);
  return Kinds(builder.FinishAt(exit_travel));
}

TEST(ToolpathBuilder, WhereLayersMeetTheFilamentGoesBackForWaysInSightAlone) {
  using enum MoveKind;
  const Travel hidden{true, {}}, in_sight{};
  const Point far{FromMm(30), FromMm(10)};
  EXPECT_THAT(KindsAsLeft(hidden, {}), ElementsAre(kLift, kTravel, kRestart, kPrint));
  EXPECT_THAT(KindsAsLeft(in_sight, {}),
              ElementsAre(kRetract, kLift, kTravel, kLift, kRestart, kPrint));
  EXPECT_THAT(KindsAsLeft(hidden, ExitTravel{far, hidden}),
              ElementsAre(kLift, kTravel, kRestart, kPrint, kTravel));
  EXPECT_THAT(KindsAsLeft(hidden, ExitTravel{far, in_sight}),
              ElementsAre(kLift, kTravel, kRestart, kPrint, kRetract, kLift, kTravel, kLift));
}

TEST(ToolpathBuilder, WhatTheLayerBelowMayHaveDoneIsDoneIfNeeded) {
  for (const bool hidden : {true, false}) {
    const MotionOptions options;
    ToolpathBuilder builder(options, kFrame, kFrame.height_nm);
    builder.BeginAsLeft();
    builder.Add(Line("(10 10, 20 10)"), {hidden, {}});
    builder.Add(Line("(30 10, 40 10)"));
    std::vector<MoveKind> if_needed;
    for (const Move& move : builder.Finish().moves)
      if (move.if_needed) if_needed.push_back(move.kind);
    EXPECT_THAT(if_needed, ElementsAre(hidden ? MoveKind::kRestart : MoveKind::kRetract));
  }
}

TEST(ToolpathBuilder, AShortWayRetractsOverAnOuterWallAlone) {
  for (const bool over_wall : {true, false}) {
    const MotionOptions options;
    ToolpathBuilder builder(options, kFrame, kFrame.height_nm);
    builder.Add(Line("(10 10, 20 10)"));
    builder.Add(Line("(21 10, 31 10)"), {.hidden = false, .corners = {}, .over_wall = over_wall});
    EXPECT_EQ(std::ranges::count(Kinds(builder.Finish()), MoveKind::kRetract), over_wall ? 2 : 1);
  }
}

TEST(ToolpathBuilder, NothingToPrintHandsTheFilamentOnAsItShould) {
  const auto kinds = [](bool begins, bool ends) {
    const MotionOptions options;
    ToolpathBuilder builder(options, kFrame, kFrame.height_nm);
    if (begins) builder.BeginAsLeft();
    return Kinds(ends ? builder.FinishAt({}) : builder.Finish());
  };
  EXPECT_THAT(kinds(false, false), ElementsAre());
  EXPECT_THAT(kinds(true, true), ElementsAre(MoveKind::kLift, MoveKind::kRestart)) << "if needed";
  EXPECT_THAT(kinds(true, false), ElementsAre(MoveKind::kRetract));
  EXPECT_THAT(kinds(false, true), ElementsAre(MoveKind::kLift, MoveKind::kRestart));
}

TEST(ToolpathBuilder, RisesAlongItsWay) {
  MotionOptions options;
  options.tool().retraction.ramping = true;
  options.tool().retraction.ramp_lift_mm = 1;
  options.tool().retraction.ramp_slope_deg = 45;
  using enum MoveKind;
  // The travel to the first path rises straight up.
  const Built far = Build({Line("(0 0, 10 0)"), Line("(20 0, 30 0)")}, options);
  EXPECT_THAT(Kinds(far.path), ElementsAre(kLift, kTravel, kLift, kRestart, kPrint, kRetract,
                                           kTravel, kTravel, kLift, kRestart, kPrint, kRetract));
  EXPECT_EQ(far.path.moves[6].x_um, 11'000);
  EXPECT_EQ(far.path.moves[6].z_um, 1'400);
  EXPECT_EQ(far.path.moves[7].z_um, 1'400);
  EXPECT_EQ(far.path.moves[8].z_um, 400);
  EXPECT_EQ(far.stats.travel_mm, 10);
  // The path is too near for a retraction.
  const Built near = Build({Line("(0 0, 10 0)"), Line("(11 0, 30 0)")}, options);
  EXPECT_THAT(Kinds(near.path),
              ElementsAre(kLift, kTravel, kLift, kRestart, kPrint, kTravel, kPrint, kRetract));
  options.tool().retraction.ramp_slope_deg = 90;
  const Built up = Build({Line("(0 0, 10 0)"), Line("(20 0, 30 0)")}, options);
  EXPECT_THAT(Kinds(up.path), ElementsAre(kLift, kTravel, kLift, kRestart, kPrint, kRetract, kLift,
                                          kTravel, kLift, kRestart, kPrint, kRetract));
}

TEST(ToolpathBuilder, LoopsOfWallsEndAtTheirGap) {
  MotionOptions options;
  options.seam_gap_mm = 0.06;
  Path loop = Line("(0 0, 10 0, 10 10, 0 10)");
  loop.closed = true;
  loop.feature = Feature::kExternalPerimeter;
  const Built closed = Build({loop}), open = Build({loop}, options);
  const auto last_print = [](const Built& built) { return built.path.moves.end()[-2]; };
  EXPECT_EQ(last_print(closed).y_um, 0);
  EXPECT_EQ(last_print(open).y_um, 60);
  EXPECT_NEAR(static_cast<double>(Printed(open.path)) / static_cast<double>(Printed(closed.path)),
              1 - 0.06 / 40, 1e-4);
  loop.feature = Feature::kInternalInfill;
  EXPECT_EQ(last_print(Build({loop}, options)).y_um, 0);
}

TEST(ToolpathBuilder, WallsOverNothingAreBridges) {
  MotionOptions options;
  options.speeds[0].bridging_walls = true;
  options.speeds[0].bridge_flow = 0.81;
  options.acceleration_mm_s2[static_cast<size_t>(Feature::kOverhangPerimeter)] = 700;
  options.default_acceleration_mm_s2 = 1000;
  const LayerBelow below(
      {{{{0, FromMm(-5)}, {FromMm(10), FromMm(-5)}, {FromMm(10), FromMm(5)}, {0, FromMm(5)}}, {}}});
  const auto build = [&](const Path& path) {
    ToolpathBuilder builder(options, kFrame, kFrame.height_nm, Ground::kLayers, &below);
    builder.Add(path);
    Toolpath toolpath = builder.Finish();
    return Built{std::move(toolpath), builder.stats()};
  };
  Path wall = Line("(1 0, 30 0)");
  wall.feature = Feature::kPerimeter;
  const Built built = build(wall);
  const Move& bridge = built.path.moves.end()[-2];
  EXPECT_EQ(bridge.feature, Feature::kOverhangPerimeter);
  EXPECT_EQ(bridge.feed_rate, 60 * 30) << "bridge_speed";
  EXPECT_EQ(bridge.acceleration_mm_s2, 700);
  EXPECT_EQ(bridge.width_um, 360);
  EXPECT_EQ(bridge.height_um, 360);
  EXPECT_EQ(built.path.moves[3].feature, Feature::kPerimeter);
  const auto use = [&](Feature feature) {
    return built.stats.features[static_cast<size_t>(feature)];
  };
  const FeatureUse over_air = use(Feature::kOverhangPerimeter), rests = use(Feature::kPerimeter);
  EXPECT_NEAR(over_air.length_mm + rests.length_mm, 29, 1e-9);
  EXPECT_NEAR(over_air.length_mm, 20, 1);
  EXPECT_NEAR(over_air.volume_mm3, over_air.length_mm * std::numbers::pi / 4 * 0.16 * 0.81, 0.01);
  options.speeds[0].thick_bridges = false;
  const Built flat = build(wall);
  EXPECT_EQ(flat.path.moves.end()[-2].width_um, 450);
  options.speeds[0].bridging_walls = false;
  EXPECT_EQ(build(wall).path.moves.end()[-2].feature, Feature::kPerimeter);
}

// Bridges are counted separately from the wall that they are pieces of. For a wall that is
// completely a bridge, rounding made the rest negative, which the wire format does not accept.
TEST(ToolpathBuilder, WhatIsNoBridgeOfAWallIsNeverLessThanNothing) {
  MotionOptions options;
  options.speeds[0].bridging_walls = true;
  const LayerBelow below({{{{0, 0}, {FromMm(1), 0}, {FromMm(1), FromMm(1)}, {0, FromMm(1)}}, {}}});
  for (int corners = 3; corners < 40; ++corners) {
    Path wall = Line("(1 0, 30 0)");
    wall.feature = Feature::kPerimeter;
    wall.closed = true;
    wall.points.clear();
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      wall.points.push_back({FromMm(60 + 7.3 * std::cos(angle)), FromMm(7.3 * std::sin(angle))});
    }
    ToolpathBuilder builder(options, kFrame, kFrame.height_nm, Ground::kLayers, &below);
    builder.Add(wall);
    builder.Finish();
    const FeatureUse& rest = builder.stats().features[static_cast<size_t>(Feature::kPerimeter)];
    EXPECT_GE(rest.length_mm, 0) << corners;
    EXPECT_GE(rest.filament_mm, 0) << corners;
    EXPECT_GE(rest.volume_mm3, 0) << corners;
    EXPECT_LT(rest.length_mm, 0.2) << corners << ": all of it hangs in the air";
  }
}

// Over a support a wall is as slow as a bridge, but it is no thread, which would sag into the
// support.
TEST(ToolpathBuilder, WallsOverSupportsAreNoThreads) {
  MotionOptions options;
  options.speeds[0].bridging_walls = true;
  const auto square = [](double from_mm, double to_mm) {
    return LayerBelow({{{{FromMm(from_mm), FromMm(-5)},
                         {FromMm(to_mm), FromMm(-5)},
                         {FromMm(to_mm), FromMm(5)},
                         {FromMm(from_mm), FromMm(5)}},
                        {}}});
  };
  const LayerBelow below = square(0, 10), above_supports = square(10, 20);
  ToolpathBuilder builder(options, kFrame, kFrame.height_nm, Ground::kLayers, &below,
                          &above_supports);
  Path wall = Line("(1 0, 30 0)");
  wall.feature = Feature::kPerimeter;
  builder.Add(wall);
  const Toolpath toolpath = builder.Finish();
  int flat = 0, threads = 0;
  int32_t from_um = 0;
  for (const Move& move : toolpath.moves) {
    if (move.kind == MoveKind::kPrint && move.feature == Feature::kOverhangPerimeter) {
      EXPECT_EQ(move.feed_rate, 60 * 30) << "bridge_speed";
      const int32_t middle_um = (from_um + move.x_um) / 2;
      ++(middle_um < 20'000 ? flat : threads);
      EXPECT_EQ(move.height_um, middle_um < 20'000 ? 200 : 400) << middle_um;
    }
    from_um = move.x_um;
  }
  EXPECT_GT(flat, 0);
  EXPECT_GT(threads, 0);
}

// Only a few of many points near a curve are printed, with the filament of all. 0 prints all of
// them.
TEST(ToolpathBuilder, SimplifiesWithinTheResolution) {
  Path curve = Line("(0 0)");
  curve.points.clear();
  for (int i = 0; i <= 100; ++i) curve.points.push_back({FromMm(0.1 * i), FromMm(0.0005 * i * i)});
  MotionOptions whole;
  whole.resolution_nm = 0;
  const Built all = Build({curve}, whole), few = Build({curve});
  EXPECT_EQ(std::ranges::count(Kinds(all.path), MoveKind::kPrint), 100);
  EXPECT_LE(std::ranges::count(Kinds(few.path), MoveKind::kPrint), 20);
  EXPECT_NEAR(static_cast<double>(Printed(few.path)), static_cast<double>(Printed(all.path)), 1);
  EXPECT_EQ(few.path.moves.back().x_um, all.path.moves.back().x_um);
}

// An arc is printed from its own points.
TEST(ToolpathBuilder, ArcsKeepTheirPointsIfAskedFor) {
  Path circle = Line("(0 0)");
  circle.points.clear();
  circle.closed = true;
  for (int i = 0; i < 90; ++i) {
    const double angle = 2 * std::numbers::pi * i / 90;
    circle.points.push_back({FromMm(9 + 5 * std::cos(angle)), FromMm(9 + 5 * std::sin(angle))});
  }
  MotionOptions arcs;
  arcs.arc_fitting = ArcFitting::kEmitCenter;
  const Built with = Build({circle}, arcs);
  EXPECT_GE(std::ranges::count(with.path.moves, true, &Move::on_arc), 85);
  const Built without = Build({circle});
  EXPECT_EQ(std::ranges::count(without.path.moves, true, &Move::on_arc), 0);
  EXPECT_LE(std::ranges::count(Kinds(without.path), MoveKind::kPrint), 40);
}

TEST(ToolpathBuilder, FilamentIsTheBeadsVolume) {
  MotionOptions options;
  options.tool().extrusion_multiplier = 0.95;
  const Built built = Build({Line("(0 0, 30 40)")}, options);
  const double volume = 50 * SectionMm2(450'000, 200'000) * 0.95;
  EXPECT_NEAR(static_cast<double>(Printed(built.path)), volume / FilamentArea(options) * 1e5, 0.5);
  const FeatureUse& use = built.stats.features[static_cast<size_t>(Feature::kPerimeter)];
  EXPECT_NEAR(use.volume_mm3, volume, 3e-5);
  EXPECT_DOUBLE_EQ(use.length_mm, 50);
}

// A wall that tapers over 60 mm. Its beads are as wide as the wall at their places, and no more
// beads than needed.
TEST(ToolpathBuilder, BeadsFollowAWidthThatChanges) {
  for (const Coord resolution_nm : {0, 12'500}) {
    MotionOptions options;
    options.resolution_nm = resolution_nm;
    const Built built = Build({Line("(0 0, 60 0)", {350'000, 550'000})}, options);
    int beads = 0;
    double from_mm = 0;
    for (const Move& move : built.path.moves) {
      if (move.kind != MoveKind::kPrint) continue;
      const double to_mm = ToMm(FromUm(move.x_um));
      for (const double at_mm : {from_mm, to_mm})
        EXPECT_NEAR(move.width_um, 350 + at_mm * 200 / 60, 6) << at_mm;
      const double section = move.filament / 1e5 * FilamentArea(options) / (to_mm - from_mm);
      EXPECT_NEAR(section, SectionMm2(FromUm(move.width_um), kFrame.height_nm), 2e-4);
      from_mm = to_mm;
      ++beads;
    }
    EXPECT_EQ(beads, 20) << resolution_nm;
    EXPECT_EQ(from_mm, 60);
  }
}

TEST(ToolpathBuilder, SumIsExactOverManySmallSegments) {
  std::mt19937 random(3);
  Path path;
  Point at{0, 0};
  for (int i = 0; i < 5'000; ++i) {
    path.points.push_back(at);
    path.widths_nm.push_back(300'000 + static_cast<Coord>(random() % 300'000));
    // Some segments round to zero length.
    at = at + Point{static_cast<Coord>(random() % 30'000), static_cast<Coord>(random() % 900)};
  }
  const MotionOptions options;
  double volume = 0;
  for (size_t i = 1; i < path.points.size(); ++i) {
    volume += ToMm(Distance(path.points[i - 1], path.points[i])) *
              SectionMm2((path.widths_nm[i - 1] + path.widths_nm[i]) / 2, kFrame.height_nm);
  }
  const Built built = Build({path}, options);
  EXPECT_NEAR(static_cast<double>(Printed(built.path)), volume / FilamentArea(options) * 1e5, 1);
  for (size_t i = 0; i < built.path.moves.size(); ++i) {
    const Move& move = built.path.moves[i];
    if (move.kind != MoveKind::kPrint) continue;
    EXPECT_GT(move.filament, 0);
    const Move& before = built.path.moves[i - 1];
    EXPECT_TRUE(move.x_um != before.x_um || move.y_um != before.y_um);
  }
}

/// Returns two lines 10 mm apart, with the given travel to the second one.
Built WithTravel(const Travel& travel, const MotionOptions& options = {}) {
  ToolpathBuilder builder(options, kFrame, kFrame.height_nm);
  builder.Add(Line("(10 10, 20 10)"), travel);
  builder.Add(Line("(20 20, 10 20)"), travel);
  Toolpath toolpath = builder.Finish();
  return {std::move(toolpath), builder.stats()};
}

TEST(ToolpathBuilder, AHiddenTravelKeepsTheFilament) {
  const Built built = WithTravel({true, {}});
  EXPECT_THAT(Kinds(built.path),
              ElementsAre(MoveKind::kLift, MoveKind::kTravel, MoveKind::kRestart, MoveKind::kPrint,
                          MoveKind::kTravel, MoveKind::kPrint, MoveKind::kRetract));
  EXPECT_EQ(built.stats.retractions, 1);
}

TEST(ToolpathBuilder, AHiddenTravelDoesNotLift) {
  MotionOptions options;
  options.tool().retraction.lift_mm = 0.6;
  for (const Move& move : WithTravel({true, {}}, options).path.moves)
    EXPECT_TRUE(move.z_um == 1'000 || move.kind != MoveKind::kTravel || move.x_um == 20'000);
  EXPECT_EQ(WithTravel({true, {}}, options).path.moves[4].z_um, 400);
  EXPECT_EQ(WithTravel({}, options).path.moves[6].z_um, 1'000);
}

TEST(ToolpathBuilder, ATravelGoesByItsCorners) {
  const Travel travel{false, MakeLineOrDie("(20 10, 23 14, 23 14.0001, 23 20)")};
  const Built built = WithTravel(travel);
  std::vector<std::pair<int32_t, int32_t>> places;
  for (const Move& move : built.path.moves)
    if (move.kind == MoveKind::kTravel) places.emplace_back(move.x_um, move.y_um);
  EXPECT_THAT(places, ElementsAre(std::pair(10'000, 10'000), std::pair(23'000, 14'000),
                                  std::pair(23'000, 20'000), std::pair(20'000, 20'000)))
      << "the first path's travel is not known; corners that round to one are one";
  EXPECT_DOUBLE_EQ(built.stats.travel_mm, 5 + 6 + 3);
  EXPECT_EQ(built.stats.travels, 2);
  EXPECT_EQ(built.stats.retractions, 2);
}

TEST(ToolpathBuilder, AWayRoundRetractsByItsWholeLength) {
  MotionOptions options;
  options.tool().retraction.min_travel_mm = 11;
  EXPECT_EQ(WithTravel({}, options).stats.retractions, 1);
  const Travel around{false, MakeLineOrDie("(23 14, 23 20)")};
  EXPECT_EQ(WithTravel(around, options).stats.retractions, 2);
}

TEST(ToolpathBuilder, LoopsCloseWhereTheyStart) {
  Path loop = Line("(0 0, 10 0, 10 10, 0 10)");
  loop.closed = true;
  const Built built = Build({loop});
  const Move& last = built.path.moves[built.path.moves.size() - 2];
  EXPECT_EQ(last.kind, MoveKind::kPrint);
  EXPECT_EQ(last.x_um, 0);
  EXPECT_EQ(last.y_um, 0);
  EXPECT_DOUBLE_EQ(built.stats.ExtrudedMm(), 40);
}

TEST(ToolpathBuilder, ShortTravelsDoNotRetract) {
  const Built built = Build({Line("(0 0, 10 0)"), Line("(10 1.9, 0 1.9)"), Line("(0 4, 10 4)")});
  EXPECT_EQ(built.stats.retractions, 2);  // before the third path and at the end
  EXPECT_EQ(built.stats.travels, 3);
  EXPECT_NEAR(built.stats.travel_mm, 1.9 + 2.1, 1e-9);
}

TEST(ToolpathBuilder, NoTravelWherePathsMeet) {
  const Built built = Build({Line("(0 0, 10 0)"), Line("(10 0, 10 10)")});
  EXPECT_EQ(built.stats.travels, 1);
  EXPECT_EQ(built.stats.retractions, 1);
}

TEST(ToolpathBuilder, LiftsAroundTravels) {
  MotionOptions options;
  options.tool().retraction.lift_mm = 0.3;
  const Built built = Build({Line("(0 0, 10 0)"), Line("(50 0, 60 0)")}, options);
  EXPECT_THAT(
      Kinds(built.path),
      ElementsAre(MoveKind::kLift, MoveKind::kTravel, MoveKind::kLift, MoveKind::kRestart,
                  MoveKind::kPrint, MoveKind::kRetract, MoveKind::kLift, MoveKind::kTravel,
                  MoveKind::kLift, MoveKind::kRestart, MoveKind::kPrint, MoveKind::kRetract));
  EXPECT_EQ(built.path.moves[0].z_um, 700);
  EXPECT_EQ(built.path.moves[2].z_um, 400);
}

/// Counts the rising travels: to a wall, from there to a top, from there to a wall over gap fill.
int RisesOf(LiftAfter after, int32_t layer) {
  MotionOptions options;
  options.tool().retraction.lift_mm = 0.3;
  options.tool().retraction.lift_after = after;
  const LayerFrame frame{layer, (layer + 1) * 200'000, 200'000};
  ToolpathBuilder builder(options, frame, frame.height_nm);
  Coord x = 0;
  for (const Feature feature : {Feature::kExternalPerimeter, Feature::kTopSolidInfill,
                                Feature::kGapFill, Feature::kExternalPerimeter}) {
    Path path = Line("(0 0, 10 0)");
    for (Point& p : path.points) p.x += x;
    x += FromMm(30);
    path.feature = feature;
    builder.Add(path);
  }
  const Toolpath path = builder.Finish();
  return static_cast<int>(std::ranges::count_if(path.moves, [&](const Move& move) {
    return move.kind == MoveKind::kLift && move.z_um > ToUm(frame.print_z_nm);
  }));
}

TEST(ToolpathBuilder, LiftsAfterWhatTheSettingsSay) {
  EXPECT_EQ(RisesOf(LiftAfter::kAll, 1), 4);
  EXPECT_EQ(RisesOf(LiftAfter::kTop, 1), 2) << "from the top, and over the gap";
  EXPECT_EQ(RisesOf(LiftAfter::kTop, 0), 2);
  EXPECT_EQ(RisesOf(LiftAfter::kBottom, 1), 0);
  EXPECT_EQ(RisesOf(LiftAfter::kBottom, 0), 4);
  EXPECT_EQ(RisesOf(LiftAfter::kTopAndBottom, 1), 2);
  EXPECT_EQ(RisesOf(LiftAfter::kTopAndBottom, 0), 4);
}

TEST(ToolpathBuilder, WithoutRetractionNothingIsPulledOrLifted) {
  MotionOptions options;
  options.tool().retraction.length_mm = 0;
  options.tool().retraction.lift_mm = 0.3;
  const Built built = Build({Line("(0 0, 10 0)"), Line("(50 0, 60 0)")}, options);
  EXPECT_THAT(Kinds(built.path), ElementsAre(MoveKind::kLift, MoveKind::kTravel, MoveKind::kPrint,
                                             MoveKind::kTravel, MoveKind::kPrint));
}

TEST(ToolpathBuilder, ExtraOnRestartIsPrinted) {
  MotionOptions options;
  options.tool().retraction.restart_extra_mm = 0.05;
  const Built with = Build({Line("(0 0, 10 0)")}, options);
  const Built without = Build({Line("(0 0, 10 0)")});
  EXPECT_EQ(with.path.moves[2].filament, 85'000);
  EXPECT_NEAR(with.stats.FilamentMm() - without.stats.FilamentMm(), 0.05, 1e-9);
}

MotionOptions Wiping() {
  MotionOptions options;
  options.travel_speed_mm_s = 150;
  options.tool().retraction = {
      .length_mm = 0.7, .speed_mm_s = 35, .wipe = true, .before_wipe = 0.5};
  return options;
}

TEST(ToolpathBuilder, RetractsInPlaceThenOnTheWay) {
  const Built built = Build({Line("(0 0, 10 0)"), Line("(10 50, 20 50)")}, Wiping());
  EXPECT_THAT(
      Kinds(built.path),
      ElementsAre(MoveKind::kLift, MoveKind::kTravel, MoveKind::kRestart, MoveKind::kPrint,
                  MoveKind::kRetract, MoveKind::kWipe, MoveKind::kTravel, MoveKind::kRestart,
                  MoveKind::kPrint, MoveKind::kRetract, MoveKind::kWipe));
  EXPECT_EQ(built.path.moves[4].filament, -35'000);
  EXPECT_EQ(built.path.moves[5].filament, -35'000);
  // 1.2 mm: 0.01 s at 120 mm/s, the time of 0.35 mm at 35 mm/s.
  EXPECT_EQ(built.path.moves[5].x_um, 8'800);
  EXPECT_EQ(built.path.moves[5].feed_rate, FeedRate(120));
  EXPECT_EQ(built.path.moves[7].filament, 70'000);
  EXPECT_EQ(built.stats.retractions, 2);
  EXPECT_NEAR(built.stats.travel_mm, std::hypot(1.2, 50), 1e-3);
}

// The rest of the retraction after a short path is made without a move.
TEST(ToolpathBuilder, PullsBackAsMuchWhateverTheWay) {
  for (const std::string_view line : {"(0 0, 0.1 0)", "(0 0, 0.5 0)", "(0 0, 1.1 0)", "(0 0, 9 0)"})
    for (const double before : {0.0, 0.31, 1.0}) {
      MotionOptions options = Wiping();
      options.tool().retraction.before_wipe = before;
      int64_t pulled = 0;
      for (const Move& move : Build({Line(line)}, options).path.moves) {
        if (move.kind != MoveKind::kRetract && move.kind != MoveKind::kWipe) continue;
        EXPECT_LT(move.filament, 0);
        pulled += move.filament;
      }
      EXPECT_EQ(pulled, -70'000) << line << before;
    }
}

// 2 mm at 120 mm/s take the time of 0.583 mm at 35 mm/s: the rest is retracted before.
TEST(ToolpathBuilder, WipesAsFarAsAskedFor) {
  MotionOptions options = Wiping();
  options.tool().retraction.before_wipe = 0;
  options.tool().retraction.wipe_distance_mm = 2;
  const auto moves = [&] { return Build({Line("(0 0, 10 0)")}, options).path.moves; };
  const auto pulls = moves();
  EXPECT_EQ(pulls.end()[-1].kind, MoveKind::kWipe);
  EXPECT_EQ(pulls.end()[-1].x_um, 8'000);
  EXPECT_EQ(pulls.end()[-1].filament, -58'333);
  EXPECT_EQ(pulls.end()[-2].filament, -11'667);
  options.wipe_as_printed = true;
  const auto slow = moves();
  EXPECT_EQ(slow.end()[-1].feed_rate, slow[3].feed_rate) << "the bead's";
  EXPECT_EQ(slow.end()[-1].filament, -70'000);
  options.tool().retraction.before_wipe = 1;
  EXPECT_EQ(moves().end()[-1].filament, 0);
  EXPECT_EQ(moves().end()[-1].x_um, 8'000);
}

// The fan needs the rest of a wall in steps, the speed of bridges only over air.
TEST(ToolpathBuilder, WallsHaveARestForTheFan) {
  MotionOptions options;
  const LayerBelow below(
      {{{{0, FromMm(-5)}, {FromMm(30), FromMm(-5)}, {FromMm(30), 0}, {0, 0}}, {}}});
  Path wall = Line("(1 0, 29 0)");
  wall.feature = Feature::kExternalPerimeter;
  const auto rest = [&] {
    ToolpathBuilder builder(options, kFrame, kFrame.height_nm, Ground::kLayers, &below);
    builder.Add(wall);
    return builder.Finish().moves[3].rest;
  };
  EXPECT_EQ(rest(), kFullRest);
  options.tool().cooling.overhang_fan_share = 0.5;
  EXPECT_EQ(rest(), 50);
  options.tool().cooling.overhang_fan_share = 0;
  EXPECT_EQ(rest(), kFullRest) << "all outer walls, whatever they rest on";
}

TEST(ToolpathBuilder, RisesBetweenTwoHeightsOnly) {
  MotionOptions options;
  options.tool().retraction.lift_mm = 0.3;
  const auto rises = [&](double above_mm, double below_mm) {
    options.tool().retraction.lift_above_mm = above_mm;
    options.tool().retraction.lift_below_mm = below_mm;
    return Build({Line("(0 0, 10 0)")}, options).path.moves[0].z_um > 400;
  };
  EXPECT_TRUE(rises(0, 0));
  EXPECT_TRUE(rises(0.4, 0.4));
  EXPECT_FALSE(rises(0.41, 0));
  EXPECT_FALSE(rises(0, 0.39));
}

TEST(ToolpathBuilder, ZOffsetShiftsEverything) {
  MotionOptions options;
  options.z_offset_mm = -0.05;
  EXPECT_EQ(Build({Line("(0 0, 10 0)")}, options).path.moves[0].z_um, 350);
}

TEST(ToolpathBuilder, OwnHeightAndWidthAreToldPerMove) {
  const Built built =
      Build({Line("(0 0, 10 0, 10 0, 20 0)", {450'000, 450'000, 550'000, 550'000})}, {}, 150'000);
  EXPECT_EQ(built.path.moves[3].width_um, 450);
  EXPECT_EQ(built.path.moves[4].width_um, 550);
  EXPECT_EQ(built.path.moves[4].height_um, 150);
}

// An object with its own layer height prints beads lower than the layer.
TEST(ToolpathBuilder, OwnHeightIsOfTheBeadsAlone) {
  const MotionOptions options;
  const Built built = Build({Line("(0 0, 30 40)")}, options, 150'000);
  EXPECT_NEAR(static_cast<double>(Printed(built.path)),
              50 * SectionMm2(450'000, 150'000) / FilamentArea(options) * 1e5, 0.5);
  EXPECT_EQ(built.path.start_z_um, 200);
  EXPECT_EQ(built.path.moves[0].z_um, 400);
}

TEST(ToolpathBuilder, EachPathHasTheSpeedOfItsRegion) {
  MotionOptions options;
  options.speeds.resize(2);
  options.speeds[1].speed_mm_s.fill(25);
  for (RegionMotion& region : options.speeds) region.small_perimeter_speed_mm_s = 0;
  Path other = Line("(10 0, 20 0)");
  other.settings = 1;
  const Built built = Build({Line("(0 0, 10 0)"), other}, options);
  EXPECT_EQ(built.path.moves[3].feed_rate, 60 * 60);
  EXPECT_EQ(built.path.moves[4].feed_rate, 25 * 60);
}

TEST(ToolpathBuilder, WideBeadsAreSlowerWhereVolumeIsLimited) {
  MotionOptions options;
  options.tool().max_volumetric_speed_mm3_s = 2;
  options.speeds[0].small_perimeter_speed_mm_s = 0;
  const Built built =
      Build({Line("(0 0, 10 0, 10 0, 20 0)", {400'000, 400'000, 800'000, 800'000})}, options);
  const Move& narrow = built.path.moves[3];
  const Move& wide = built.path.moves[4];
  EXPECT_LT(wide.feed_rate, narrow.feed_rate);
  for (const Move& move : {narrow, wide}) {
    const double mm3_s = move.filament / 1e5 * FilamentArea(options) / 10 * move.feed_rate / 60;
    EXPECT_NEAR(mm3_s, 2, 0.01);
  }
}

// Rounding to micrometres and to 1e-5 mm of filament makes short pieces thicker than their bead.
TEST(ToolpathBuilder, ShortPiecesKeepTheLimitOfVolume) {
  MotionOptions options;
  options.tool().max_volumetric_speed_mm3_s = 2;
  options.speeds[0].small_perimeter_speed_mm_s = 0;
  options.resolution_nm = 0;
  Path circle;
  circle.closed = true;
  circle.widths_nm = {450'000};
  for (int i = 0; i < 200; ++i)  // pieces of about 20 um
    circle.points.push_back({std::llround(637'000 * std::cos(i * std::numbers::pi / 100)),
                             std::llround(637'000 * std::sin(i * std::numbers::pi / 100))});
  const Toolpath path = Build({circle}, options).path;
  int pieces = 0;
  for (size_t i = 1; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    if (move.kind != MoveKind::kPrint) continue;
    const Move& from = path.moves[i - 1];
    const double mm = std::hypot(move.x_um - from.x_um, move.y_um - from.y_um) / 1000;
    EXPECT_LE(move.filament / 1e5 * FilamentArea(options) / mm * move.feed_rate / 60, 2.003);
    ++pieces;
  }
  EXPECT_GT(pieces, 150);
}

// The infill stage prints bridges as beads of their layer's height, with the plastic of a thread.
TEST(ToolpathBuilder, ThreadsOfBridgesAreToldAsRoundAsTheyAre) {
  const MotionOptions options;  // default nozzle of 0.4 mm
  const double disc_mm2 = std::numbers::pi / 4 * 0.4 * 0.4;
  const Coord width_nm = WidthForSpacing(FromMm(disc_mm2 / 0.2), 200'000);
  Path bridge = Line("(0 0, 10 0)", {width_nm});
  Path above_supports = Line("(0 1, 10 1)");
  bridge.feature = above_supports.feature = Feature::kBridgeInfill;
  const Toolpath path = Build({bridge, above_supports}, options).path;
  std::vector<Move> beads;
  for (const Move& move : path.moves)
    if (move.kind == MoveKind::kPrint) beads.push_back(move);
  ASSERT_EQ(beads.size(), 2u);
  EXPECT_EQ(beads[0].width_um, 400);
  EXPECT_EQ(beads[0].height_um, 400);
  EXPECT_NEAR(beads[0].filament / 1e5 * FilamentArea(options), 10 * disc_mm2, 1e-3);
  EXPECT_EQ(beads[1].width_um, 450) << "on a support it is a bead of its layer";
  EXPECT_EQ(beads[1].height_um, 200);
}

TEST(ToolpathBuilder, BoundsAreThoseOfTheBeads) {
  const Built built = Build({Line("(10 20, 30 25)", {600'000})});
  EXPECT_EQ(built.stats.bounds, (Box{{FromMm(9.7), FromMm(19.7)}, {FromMm(30.3), FromMm(25.3)}}));
}

TEST(ToolpathBuilder, AnAbsurdSegmentDoesNotOverflow) {
  MotionOptions options;
  options.tool().extrusion_multiplier = 1000;
  const Built built = Build({Line("(-2000 0, 2000 0)", {90'000'000})}, options, 90'000'000);
  EXPECT_GT(built.path.moves[3].filament, 0);
}

TEST(ToolpathBuilder, WallsOverAirAreCutAndSlowedDown) {
  MotionOptions options;
  options.speeds[0].dynamic_overhangs = true;
  options.speeds[0].overhang_speed_mm_s = {10, 15, 20, 25};
  options.speeds[0].small_perimeter_speed_mm_s = 0;
  const LayerBelow below(
      {{{{0, FromMm(-5)}, {FromMm(10), FromMm(-5)}, {FromMm(10), FromMm(5)}, {0, FromMm(5)}}, {}}});
  ToolpathBuilder builder(options, {2, 600'000, 200'000}, 200'000, Ground::kLayers, &below);
  Path wall;
  wall.feature = Feature::kExternalPerimeter;
  wall.points = {{FromMm(2), 0}, {FromMm(18), 0}};
  wall.widths_nm = {400'000};
  builder.Add(wall);
  Path fill = wall;
  fill.feature = Feature::kSolidInfill;
  fill.points = {{FromMm(18), FromMm(1)}, {FromMm(2), FromMm(1)}};
  builder.Add(fill);
  const Toolpath path = builder.Finish();
  std::vector<Move> walls;
  int fills = 0;
  int64_t filament = 0;
  for (const Move& move : path.moves) {
    if (move.kind != MoveKind::kPrint) continue;
    if (move.feature == Feature::kSolidInfill) {
      ++fills;
      EXPECT_EQ(move.rest, kFullRest);
    } else {
      walls.push_back(move);
      filament += move.filament;
    }
  }
  EXPECT_EQ(fills, 1);
  ASSERT_GE(walls.size(), 3);
  EXPECT_EQ(walls.front().x_um, 9'000);
  EXPECT_EQ(walls.front().feed_rate, FeedRate(30));
  EXPECT_EQ(walls.back().rest, 0);
  EXPECT_EQ(walls.back().feed_rate, FeedRate(10));
  const MotionOptions plain;
  ToolpathBuilder whole(plain, {2, 600'000, 200'000}, 200'000);
  whole.Add(wall);
  for (const Move& move : whole.Finish().moves)
    EXPECT_TRUE(move.kind != MoveKind::kPrint || std::abs(move.filament - filament) <= 1);
}

TEST(ToolpathBuilder, AScarfRisesOverItsLayerAndTakesTheSameFilament) {
  Path loop = Line("(15 0, 30 0, 30 20, 0 20, 0 0)");
  loop.closed = true;
  loop.feature = Feature::kExternalPerimeter;
  MotionOptions options;
  const Built plain = Build({loop}, options);
  options.speeds[0].scarf.placement = ScarfPlacement::kContours;
  const Built scarf = Build({loop}, options);
  EXPECT_NEAR(static_cast<double>(Printed(scarf.path)), static_cast<double>(Printed(plain.path)),
              25)
      << "rounding, once for each piece that would have none";
  int32_t z_um = 200;
  for (const Move& move : scarf.path.moves) {
    if (move.kind != MoveKind::kPrint) continue;
    EXPECT_GE(move.z_um, z_um);
    EXPECT_LE(move.height_um, 200);
    z_um = move.z_um;
  }
  EXPECT_EQ(z_um, 400);
  const Move& last = scarf.path.moves[scarf.path.moves.size() - 2];
  EXPECT_EQ(last.x_um, 30'000) << "20 mm beyond the start";
  EXPECT_EQ(last.y_um, 5'000);
}

Path OuterLoop() {
  Path loop = Line("(0 0, 10 0, 10 10, 0 10)");
  loop.closed = true;
  loop.feature = Feature::kExternalPerimeter;
  return loop;
}

TEST(ToolpathBuilder, FlowByFeatureAndFirstLayer) {
  MotionOptions options;
  const Path wall = Line("(0 0, 100 0)");
  const auto plain = static_cast<double>(Printed(Build({wall}).path));
  options.speeds[0].flow[static_cast<size_t>(wall.feature)] = 0.9;
  EXPECT_NEAR(static_cast<double>(Printed(Build({wall}, options).path)), 0.9 * plain, 1);
  options.speeds[0].first_layer_flow = 1.1;
  EXPECT_NEAR(static_cast<double>(Printed(Build({wall}, options).path)), 0.9 * plain, 1);
  ToolpathBuilder first(options, {0, 200'000, 200'000}, 200'000);
  first.Add(wall);
  EXPECT_NEAR(static_cast<double>(Printed(first.Finish())), 0.99 * plain, 1);
}

TEST(ToolpathBuilder, JerkOfEachMove) {
  MotionOptions options;
  options.jerk.default_mm_s = 8;
  options.jerk.feature_mm_s[static_cast<size_t>(Feature::kExternalPerimeter)] = 5;
  const auto jerks = [&] {
    std::vector<float> values;
    for (const Move& move : Build({OuterLoop(), Line("(30 10, 40 10)")}, options).path.moves)
      values.push_back(move.jerk_mm_s);
    return values;
  };
  const std::vector<float> kept = jerks();
  EXPECT_EQ(kept.front(), 5) << "the first bead's";
  EXPECT_EQ(kept.back(), 8);
  EXPECT_EQ(std::ranges::count(kept, 12.0F), 0);
  options.limits.max_jerk_mm_s = {20, 20, 1, 5};
  options.jerk.travel_mm_s = 12;
  EXPECT_GT(std::ranges::count(jerks(), 12.0F), 2);
  options.jerk.default_mm_s = 0;
  const std::vector<float> none = jerks();
  EXPECT_EQ(std::ranges::count(none, 0.0F), std::ssize(none));
}

TEST(ToolpathBuilder, WipesOnLoops) {
  MotionOptions options;
  options.speeds[0].wipe_on_loops = true;
  const Built plain = Build({OuterLoop()}), wiped = Build({OuterLoop()}, options);
  ASSERT_EQ(wiped.path.moves.size(), plain.path.moves.size() + 1);
  const Move& inwards = wiped.path.moves.end()[-2];
  EXPECT_EQ(inwards.kind, MoveKind::kTravel);
  EXPECT_EQ(inwards.filament, 0);
  EXPECT_NEAR(inwards.x_um, 141, 1) << "half a nozzle along the bisector";
  EXPECT_NEAR(inwards.y_um, 141, 1);
  options.clockwise = true;
  EXPECT_NEAR(Build({OuterLoop()}, options).path.moves.end()[-2].x_um, -141, 1);
  Path inner = OuterLoop();
  inner.feature = Feature::kPerimeter;
  EXPECT_EQ(Build({inner}, options).path.moves, Build({inner}).path.moves);
}

TEST(ToolpathBuilder, WipesBeforeOuterWalls) {
  MotionOptions options;
  options.speeds[0].wipe_before_outer = true;
  const Built built = Build({Line("(30 10, 40 10)"), OuterLoop()}, options);
  const auto restart = std::ranges::find(built.path.moves.begin() + 4, built.path.moves.end(),
                                         MoveKind::kRestart, &Move::kind);
  ASSERT_NE(restart, built.path.moves.end());
  EXPECT_NEAR(restart->x_um, 141, 1) << "the filament comes back inside";
  EXPECT_EQ(restart[1].kind, MoveKind::kTravel);
  EXPECT_EQ(restart[1].x_um, 0);
  EXPECT_EQ(restart[2].kind, MoveKind::kPrint);
}

TEST(ToolpathBuilder, ReversesWallsInEverySecondLayer) {
  MotionOptions options;
  options.speeds[0].reversal = {.on = true};
  const auto second_corner = [&](int32_t layer) {
    ToolpathBuilder builder(options, {layer, 400'000, 200'000}, 200'000);
    builder.Add(OuterLoop());
    const Toolpath path = builder.Finish();
    return std::ranges::find(path.moves, MoveKind::kPrint, &Move::kind)->x_um;
  };
  EXPECT_EQ(second_corner(2), 10'000);
  EXPECT_EQ(second_corner(3), 0);
}

TEST(ToolpathBuilder, ScarfsHaveTheirSpeedAndFlow) {
  MotionOptions options;
  Path loop = OuterLoop();
  loop.points.insert(loop.points.begin(), {FromMm(0), FromMm(5)});
  options.speeds[0].small_perimeter_radius_mm = 0;
  options.speeds[0].scarf.placement = ScarfPlacement::kEverywhere;
  options.speeds[0].scarf.length_mm = 8;
  const Built plain = Build({loop}, options);
  options.speeds[0].scarf.speed_mm_s = 10;
  options.speeds[0].scarf.flow = 0.5;
  const Built slow = Build({loop}, options);
  const auto at_speed = [](const Built& built, int32_t mm_s) {
    return std::ranges::count_if(built.path.moves, [&](const Move& move) {
      return move.kind == MoveKind::kPrint && move.feed_rate == mm_s * 60;
    });
  };
  EXPECT_EQ(at_speed(plain, 10), 0);
  EXPECT_GE(at_speed(slow, 10), 14);
  EXPECT_GT(at_speed(slow, 30), 0) << "the rest of the loop";
  EXPECT_NEAR(static_cast<double>(Printed(plain.path) - Printed(slow.path)),
              0.5 * 8 / 40 * static_cast<double>(Printed(plain.path)), 20);
}

}  // namespace
}  // namespace slicefarm::motion::toolpath_builder_test
