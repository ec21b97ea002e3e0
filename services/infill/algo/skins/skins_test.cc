#include "services/infill/algo/skins/skins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::skins_test {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }
double Mm2(const MultiPolygon& polygons) { return Area(polygons) / 1e12; }

const MultiPolygon kWhole = P("(0 0, 20 0, 20 20, 0 20)");
const MultiPolygon kFill = P("(1 1, 19 1, 19 19, 1 19)");
const MultiPolygon kLeftHalf = P("(0 0, 10 0, 10 20, 0 20)");

void ExpectPartition(const Skins& skins, const MultiPolygon& fill) {
  const MultiPolygon* parts[] = {&skins.top,         &skins.bridge, &skins.bottom,
                                 &skins.over_bridge, &skins.solid,  &skins.sparse};
  double sum = 0;
  MultiPolygon all;
  for (const MultiPolygon* part : parts) sum += Mm2(*part), all = Union(all, *part);
  EXPECT_NEAR(sum, Mm2(fill), 1e-4);
  EXPECT_NEAR(Mm2(all), Mm2(fill), 1e-4);
  EXPECT_LT(Mm2(Difference(all, fill)), 1e-4);
}

TEST(Skins, PrismIsSparseThroughout) {
  const Skins skins = PartFillArea(kFill, kWhole, {{&kWhole, &kWhole}, {&kWhole}, false}, {});
  EXPECT_EQ(skins.sparse, kFill);
  EXPECT_TRUE(skins.solid.empty());
}

TEST(Skins, NothingAboveIsTop) {
  const Skins skins = PartFillArea(kFill, kWhole, {{nullptr, nullptr}, {&kWhole}, false}, {});
  EXPECT_EQ(skins.top, kFill);
  EXPECT_TRUE(skins.sparse.empty());
}

TEST(Skins, AirTwoLayersUpIsSolidButNotTop) {
  const Skins skins = PartFillArea(kFill, kWhole, {{&kWhole, nullptr}, {&kWhole}, false}, {});
  EXPECT_EQ(skins.solid, kFill);
}

TEST(Skins, NothingBelowIsABridgeUnlessOnTheBed) {
  EXPECT_EQ(PartFillArea(kFill, kWhole, {{&kWhole}, {nullptr}, false}, {}).bridge, kFill);
  EXPECT_EQ(PartFillArea(kFill, kWhole, {{&kWhole}, {nullptr}, true}, {}).solid, kFill);
}

TEST(Skins, StepHasTopSolidAndSparse) {
  const Skins skins = PartFillArea(kFill, kWhole, {{&kLeftHalf, &kLeftHalf}, {&kWhole}, false}, {});
  EXPECT_NEAR(Mm2(skins.top), 9 * 18, 0.01);
  EXPECT_NEAR(Mm2(skins.solid), 0.9 * 18, 0.01);  // the anchor of two beads
  EXPECT_NEAR(Mm2(skins.sparse), 8.1 * 18, 0.01);
  ExpectPartition(skins, kFill);
}

TEST(Skins, SliversJoinTheSparseRegion) {
  const MultiPolygon almost = P("(0 0, 18.9 0, 18.9 20, 0 20)");
  const Skins skins = PartFillArea(kFill, kWhole, {{&almost}, {&kWhole}, false}, {});
  EXPECT_EQ(skins.sparse, kFill);
}

TEST(Skins, ThinSparseRemaindersBecomeSolid) {
  const MultiPolygon ledge = P("(0 0, 2.5 0, 2.5 20, 0 20)");
  const Skins skins = PartFillArea(kFill, kWhole, {{&ledge}, {&kWhole}, false}, {});
  EXPECT_TRUE(skins.sparse.empty());
  ExpectPartition(skins, kFill);
}

TEST(Skins, NarrowSparsePlacesBetweenSkinsBecomeSolid) {
  // The layer is bare from 6 to 8 and from 11 to 13: 1.2 mm remain between the skins that grow from
  // there.
  const MultiPolygon bars =
      P("(0 0, 6 0, 6 20, 0 20) ; (8 0, 11 0, 11 20, 8 20) ; (13 0, 20 0, 20 20, 13 20)");
  const Skins skins = PartFillArea(kFill, kWhole, {{&bars}, {&kWhole}, false}, {});
  EXPECT_NEAR(Mm2(skins.sparse), (4.1 + 5.1) * 18, 0.01);
  ExpectPartition(skins, kFill);
}

TEST(Skins, NarrowPlacesBesideWallsStaySparse) {
  const MultiPolygon fill = P("(1 1, 12 1, 12 -3, 13.2 -3, 13.2 1, 19 1, 19 19, 1 19)");
  const MultiPolygon whole = P("(0 -5, 20 -5, 20 20, 0 20)");
  const MultiPolygon right = P("(5 -5, 20 -5, 20 20, 5 20)");
  const Skins skins = PartFillArea(fill, whole, {{&right}, {&whole}, false}, {});
  EXPECT_NEAR(Mm2(skins.sparse), 13.1 * 18 + 1.2 * 4, 0.01);
  ExpectPartition(skins, fill);
}

TEST(Skins, SmallSparseRegionsBecomeSolidIfAsked) {
  const Skins skins =
      PartFillArea(kFill, kWhole, {{&kLeftHalf}, {&kWhole}, false}, {.solid_below_area_mm2 = 200});
  EXPECT_TRUE(skins.sparse.empty());
  ExpectPartition(skins, kFill);
}

TEST(Skins, OverhangingStepHasABridge) {
  const Skins skins = PartFillArea(kFill, kWhole, {{&kWhole}, {&kLeftHalf}, false}, {});
  EXPECT_NEAR(Mm2(skins.bridge), (9 + 0.9) * 18, 0.01);  // with two beads of the support
  ExpectPartition(skins, kFill);
}

// One layer is over a hole, with nothing above it: this is the recess of a screw, where the hole is
// drilled after the print.
TEST(Skins, AMembraneOverAirIsABridgeNotATop) {
  const MultiPolygon area = P("(0 0, 20 0, 20 20, 0 20)");
  const MultiPolygon holed = P("(0 0, 20 0, 20 20, 0 20) (7 7, 7 13, 13 13, 13 7)");
  const MultiPolygon above = P("(0 0, 20 0, 20 20, 0 20) (5 5, 5 15, 15 15, 15 5)");
  Cover cover;
  cover.above = {&above};
  cover.below = {&holed};
  const Skins skins = PartFillArea(area, area, cover, {});
  EXPECT_NEAR(Mm2(skins.bridge), 7.8 * 7.8, 0.3) << "the hole, and two beads around it";
  EXPECT_NEAR(Mm2(skins.top), 10 * 10 - 7.8 * 7.8, 0.5);
  // A floor that is over air from its first layer has a top of its own.
  cover.below = {&area, &holed};
  const Skins second = PartFillArea(area, area, cover, {});
  EXPECT_TRUE(second.bridge.empty());
  EXPECT_NEAR(Mm2(second.top), 10 * 10, 0.1);
  cover.on_bed = true;
  cover.below = {};
  EXPECT_NEAR(Mm2(PartFillArea(area, area, cover, {}).top), 10 * 10, 0.1);
}

// Each layer of a recess that widens upwards is bare by itself. The bare parts of farther layers
// contain the bare part of the nearest layer, with a margin smaller than bridges need.
TEST(Skins, BridgesOverAWideningRecessHaveWholeAnchors) {
  const auto recess = [](double half_mm) {
    const double a = 10 - half_mm, b = 10 + half_mm;
    return MultiPolygon{{P("(0 0, 20 0, 20 20, 0 20)")[0].outer,
                         {{{FromMm(a), FromMm(a)},
                           {FromMm(a), FromMm(b)},
                           {FromMm(b), FromMm(b)},
                           {FromMm(b), FromMm(a)}}}}};
  };
  const MultiPolygon near = recess(5), far = recess(4.7), farther = recess(4.4);
  const std::vector<const MultiPolygon*> roof = {&kWhole, &kWhole, &kWhole};
  for (const auto& [name, cover] :
       {std::pair<std::string, Cover>("widens", {roof, {&near, &far, &farther}, false}),
        {"is straight", {roof, {&near, &near, &near}, false}},
        {"with a smaller one above", {{&kWhole, &far}, {&near, &near}, false}}}) {
    const Skins skins = PartFillArea(kFill, kWhole, cover, {});
    ASSERT_EQ(skins.bridge.size(), 1U) << name;
    EXPECT_NEAR(Mm2(skins.bridge), 11.8 * 11.8, 0.1) << name << ": two beads of 0.45 mm around it";
    ExpectPartition(skins, kFill);
  }
}

// The cover has only layers of one region. Its upper half is on another region.
TEST(Skins, OverAnotherRegionIsABottomAndNoBridge) {
  Cover cover{.above = {&kWhole}, .below = {&kLeftHalf}, .bearers = {&kWhole}};
  Skins skins = PartFillArea(kFill, kWhole, cover, {});
  EXPECT_TRUE(skins.bridge.empty());
  EXPECT_NEAR(Mm2(skins.bottom), 9 * 18, 0.01);
  EXPECT_NEAR(Mm2(skins.solid), 0.9 * 18, 0.01);
  ExpectPartition(skins, kFill);
  cover.below = {nullptr};
  skins = PartFillArea(kFill, kWhole, cover, {});
  EXPECT_EQ(skins.bottom, kFill);
  cover.bearers = {&kLeftHalf};
  skins = PartFillArea(kFill, kWhole, cover, {});
  EXPECT_NEAR(Mm2(skins.bridge), 9.9 * 18, 0.01);
  EXPECT_NEAR(Mm2(skins.bottom), 8.1 * 18, 0.01);
  ExpectPartition(skins, kFill);
}

TEST(Skins, WhatLiesOverABridgeIsToldApartIfAsked) {
  const Cover cover{
      .above = {&kWhole}, .below = {&kWhole, &kLeftHalf}, .bearers = {&kWhole, &kLeftHalf}};
  Skins skins = PartFillArea(kFill, kWhole, cover, {.over_bridges = true});
  EXPECT_TRUE(skins.bridge.empty());
  EXPECT_TRUE(skins.bottom.empty());
  // The area reaches as far as the bridge below, and contains all solid infill here.
  EXPECT_NEAR(Mm2(skins.over_bridge), 9.9 * 18, 0.01);
  EXPECT_TRUE(skins.solid.empty());
  ExpectPartition(skins, kFill);
  skins = PartFillArea(kFill, kWhole, cover, {.all_solid = true, .over_bridges = true});
  EXPECT_NEAR(Mm2(skins.over_bridge), 9.9 * 18, 0.01);
  EXPECT_NEAR(Mm2(skins.solid), 8.1 * 18, 0.01);
  skins = PartFillArea(kFill, kWhole, cover, {});
  EXPECT_TRUE(skins.over_bridge.empty());
  EXPECT_NEAR(Mm2(skins.solid), 9.9 * 18, 0.01);
}

// A slope over five layers: the bare part of the farthest layer is solid, independent of the nearer
// layers.
TEST(Skins, SlopeTakesTheFarthestLayer) {
  std::vector<MultiPolygon> slope;
  for (int i = 1; i <= 5; ++i) {
    const Coord x = FromMm(20 - 2.5 * i);
    slope.push_back({{{{0, 0}, {x, 0}, {x, FromMm(20)}, {0, FromMm(20)}}, {}}});
  }
  Cover cover;
  for (const MultiPolygon& layer : slope) cover.above.push_back(&layer);
  cover.below = {&kWhole};
  const Skins skins = PartFillArea(kFill, kWhole, cover, {});
  EXPECT_NEAR(Mm2(skins.top), 1.5 * 18, 0.01);                 // beyond 17.5
  EXPECT_NEAR(Mm2(skins.sparse), (7.5 - 1 - 0.9) * 18, 0.01);  // up to 7.5, minus the anchor
  ExpectPartition(skins, kFill);
}

struct SlopeCase {
  double step_mm;  ///< step from layer to layer
  ShellThickness shells;
  bool solid;
};

TEST(Skins, SlopesAreAsThickAsAsked) {
  const MultiPolygon fill = P("(0.5 0.5, 19.5 0.5, 19.5 19.5, 0.5 19.5)");
  using enum ShellThickness;
  for (const SlopeCase& c : {SlopeCase{0.2, kEnabled, true}, SlopeCase{0.2, kPartial, false},
                             SlopeCase{0.2, kDisabled, false}, SlopeCase{0.4, kEnabled, true},
                             SlopeCase{0.4, kPartial, true}, SlopeCase{0.4, kDisabled, false},
                             SlopeCase{2, kEnabled, true}, SlopeCase{2, kPartial, true},
                             SlopeCase{2, kDisabled, true}}) {
    for (const bool above : {true, false}) {
      std::vector<MultiPolygon> slope;
      for (int i = 1; i <= 5; ++i) {
        const Coord x = FromMm(20 - i * c.step_mm);
        slope.push_back({{{{0, 0}, {x, 0}, {x, FromMm(20)}, {0, FromMm(20)}}, {}}});
      }
      Cover cover;
      for (const MultiPolygon& layer : slope) (above ? cover.above : cover.below).push_back(&layer);
      (above ? cover.below : cover.above) = {&kWhole};
      const Skins skins = PartFillArea(fill, kWhole, cover, {.shells = c.shells});
      EXPECT_EQ(skins.sparse != fill, c.solid)
          << c.step_mm << ' ' << static_cast<int>(c.shells) << ' ' << above;
      ExpectPartition(skins, fill);
    }
  }
}

// Without shells, the area directly under an open surface still has its full thickness.
TEST(Skins, SurfacesKeepTheirLayersWithoutShells) {
  for (const auto& above : {std::vector<const MultiPolygon*>{&kLeftHalf, &kLeftHalf},
                            std::vector<const MultiPolygon*>{&kWhole, &kWhole, &kLeftHalf},
                            std::vector<const MultiPolygon*>{&kWhole, nullptr},
                            std::vector<const MultiPolygon*>{&kLeftHalf, nullptr, nullptr}}) {
    const Cover cover{above, {&kWhole}, false};
    const Skins all = PartFillArea(kFill, kWhole, cover, {});
    const Skins exposed = PartFillArea(kFill, kWhole, cover, {.shells = ShellThickness::kDisabled});
    EXPECT_NEAR(Mm2(all.sparse), Mm2(exposed.sparse), 0.01);
    EXPECT_NEAR(Mm2(all.top), Mm2(exposed.top), 0.01);
  }
}

/// Returns the polygons with each corner moved by up to 20 nm, differently for each seed.
MultiPolygon Noisy(const MultiPolygon& polygons, uint32_t seed) {
  std::minstd_rand random(seed + 1);
  const auto move = [&random](Polygon& ring) {
    for (Point& p : ring) {
      p.x += static_cast<Coord>(random() % 41) - 20;
      p.y += static_cast<Coord>(random() % 41) - 20;
    }
  };
  MultiPolygon result = polygons;
  for (PolygonWithHoles& island : result) {
    move(island.outer);
    for (Polygon& hole : island.holes) move(hole);
  }
  return result;
}

MultiPolygon Turned(std::string_view text) {
  MultiPolygon result = P(text);
  const double c = std::cos(0.4), s = std::sin(0.4);
  for (PolygonWithHoles& island : result) {
    for (Point& p : island.outer) {
      const auto x = static_cast<double>(p.x), y = static_cast<double>(p.y);
      p = {std::llround(c * x - s * y), std::llround(s * x + c * y)};
    }
  }
  return result;
}

struct NoiseCase {
  const char* above;
  const char* below;
};

// The result must not depend on a vertex that is on an edge of another operand except for rounding.
TEST(Skins, NoiseOfSomeNanometresMovesNoSkin) {
  const MultiPolygon fill = Turned("(1 1, 17 1, 19 3, 19 19, 2.5 19, 2.5 12, 1 12)");
  const MultiPolygon whole = Turned("(0 0, 20 0, 20 20, 0 20)");
  for (const NoiseCase& c :
       {NoiseCase{"(0 0, 10 0, 10 20, 0 20)", "(0 0, 20 0, 20 20, 0 20)"},
        NoiseCase{"(0 0, 20 0, 20 20, 0 20)", "(0 0, 12 0, 12 12, 0 12)"},
        NoiseCase{"(0 0, 18 0, 18 20, 0 20)", "(1 0, 20 0, 20 7, 1 7)"},
        NoiseCase{"(0 0, 6 0, 6 20, 0 20) ; (8 0, 11 0, 11 20, 8 20) ; (13 0, 20 0, 20 20, 13 20)",
                  "(0 0, 20 0, 20 18, 0 18)"}}) {
    const MultiPolygon above = Turned(c.above), below = Turned(c.below);
    const Skins plain =
        PartFillArea(fill, whole, {.above = {&above, &above}, .below = {&below, &below}}, {});
    for (uint32_t seed = 0; seed < 250; seed += 5) {
      MultiPolygon noisy[4];
      for (uint32_t i = 0; i < 4; ++i) noisy[i] = Noisy(i < 2 ? above : below, seed + i);
      const Cover cover{.above = {&noisy[0], &noisy[1]}, .below = {&noisy[2], &noisy[3]}};
      const Skins moved = PartFillArea(Noisy(fill, seed + 4), whole, cover, {});
      for (auto part : {&Skins::top, &Skins::bridge, &Skins::solid, &Skins::sparse})
        EXPECT_NEAR(Mm2(plain.*part), Mm2(moved.*part), 0.01) << c.above << ' ' << seed;
    }
  }
}

// A skin ends in a channel between walls: the channel is solid as far as lines would be short bits
// beside the skin.
TEST(Skins, NarrowPlacesAreSolidNoFartherThanTheirWidthFromASkin) {
  const MultiPolygon fill = P("(1 1, 19 1, 19 2.2, 1 2.2)");
  const MultiPolygon left = P("(0 0, 8 0, 8 5, 0 5)");
  const MultiPolygon whole = P("(0 0, 20 0, 20 5, 0 5)");
  const Skins skins = PartFillArea(fill, whole, {{&left}, {&whole}, false}, {});
  EXPECT_NEAR(Mm2(skins.sparse), (7 - 0.9 - 4 * 0.45) * 1.2, 0.01);
  ExpectPartition(skins, fill);
}

// A narrow part of a skin far from any bridge is not part of a bridge.
TEST(Skins, SliversOfSolidFarFromABridgeStaySolid) {
  const MultiPolygon fill = P("(1 1, 19 1, 19 10, 12 10, 12 19, 11.7 19, 11.7 10, 1 10)");
  const MultiPolygon below = P("(5 0, 20 0, 20 20, 5 20)");
  const Skins skins = PartFillArea(fill, kWhole, {{}, {&below}, false}, {.all_solid = true});
  EXPECT_NEAR(Mm2(skins.bridge), 4.9 * 9, 0.01);
  ExpectPartition(skins, fill);
}

TEST(Skins, IslandsNotUnderALayerAreBare) {
  const MultiPolygon fill = P("(1 1, 4 1, 4 4, 1 4) ; (6 1, 9 1, 9 4, 6 4)");
  const MultiPolygon outline = P("(0 0, 10 0, 10 5, 0 5)"), left = P("(0 0, 5 0, 5 5, 0 5)");
  const Skins skins = PartFillArea(fill, outline, {{&left}, {&outline}, false}, {});
  EXPECT_NEAR(Mm2(skins.sparse), 9, 1e-6);
  EXPECT_NEAR(Mm2(skins.top), 9, 1e-6);
}

TEST(Skins, NoSkinsAskedForIsAllSparse) {
  EXPECT_EQ(PartFillArea(kFill, kWhole, {{}, {}, false}, {}).sparse, kFill);
}

TEST(Skins, AllSolidStillShowsItsTop) {
  const Skins skins =
      PartFillArea(kFill, kWhole, {{&kLeftHalf}, {&kWhole}, false}, {.all_solid = true});
  EXPECT_TRUE(skins.sparse.empty());
  EXPECT_NEAR(Mm2(skins.top), 9 * 18, 0.01);
  ExpectPartition(skins, kFill);
}

}  // namespace
}  // namespace slicefarm::infill::skins_test
