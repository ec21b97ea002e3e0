#include "services/infill/algo/skins/sparse_bridges.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::sparse_bridges_test {
namespace {

constexpr Coord kWidth = 450'000;

double Mm2(const MultiPolygon& region) { return Area(region) / 1e12; }

/// Returns lines along y in [-20, 20]^2, every `pitch_mm`, beginning at x = -20.
SparseBelow LinesBelow(double pitch_mm) {
  SparseBelow below{.region = MakePolygonsOrDie("(-20 -20, 20 -20, 20 20, -20 20)"),
                    .beads = {},
                    .pitch_nm = pitch_mm * kNmPerMm,
                    .least_gap_nm = pitch_mm * kNmPerMm};
  std::vector<Polyline> lines;
  for (double x = -20; x <= 20; x += pitch_mm)
    lines.push_back({{FromMm(x), FromMm(-20)}, {FromMm(x), FromMm(20)}});
  below.beads = OffsetLines(lines, kWidth / 2, Cap::kButt);
  return below;
}

Skins SkinsOf(std::string_view solid, std::string_view all) {
  Skins skins;
  skins.solid = MakePolygonsOrDie(solid);
  skins.sparse = Difference(MakePolygonsOrDie(all), skins.solid);
  return skins;
}

SparseBridges TakeUnheld(const SparseBelow& below, Skins& skins) {
  MultiPolygon unheld = UnheldParts(below, kWidth, skins);
  return unheld.empty() ? SparseBridges{}
                        : TakeSparseBridges(std::move(unheld), below, kWidth, skins);
}

constexpr std::string_view kAll = "(-20 -20, 20 -20, 20 20, -20 20)";

TEST(TakeSparseBridges, GoesOnToTheLinesOnEitherSide) {
  Skins skins = SkinsOf("(-7 -5, 7 -5, 7 5, -7 5)", kAll);
  const double before = Mm2(skins.solid) + Mm2(skins.sparse);
  const SparseBridges bridges = TakeUnheld(LinesBelow(4), skins);
  ASSERT_EQ(bridges.regions.size(), 1U);
  // Lines are at x = -8 and 8, at least half a millimetre outside.
  const Box box = Bounds(bridges.regions);
  EXPECT_GE(box.max.x, FromMm(8));
  EXPECT_LE(box.max.x, FromMm(8.3));
  EXPECT_LE(box.min.x, FromMm(-8));
  EXPECT_GE(box.min.x, FromMm(-8.3));
  EXPECT_NEAR(Mm2(skins.solid) + Mm2(skins.sparse) + Mm2(bridges.regions), before, 1e-6);
  EXPECT_TRUE(skins.solid.empty());
}

TEST(TakeSparseBridges, NothingNarrowerThanACell) {
  Skins skins = SkinsOf("(-20 -20, -16 -20, -16 20, -20 20)", kAll);
  const Skins before = skins;
  EXPECT_TRUE(TakeUnheld(LinesBelow(4), skins).regions.empty());
  EXPECT_EQ(skins.solid, before.solid);
  EXPECT_EQ(skins.sparse, before.sparse);
}

TEST(TakeSparseBridges, NothingOverWhatIsSolid) {
  Skins skins = SkinsOf("(-7 -5, 7 -5, 7 5, -7 5)", kAll);
  SparseBelow below = LinesBelow(4);
  below.region = MakePolygonsOrDie("(10 -20, 20 -20, 20 20, 10 20)");
  EXPECT_TRUE(TakeUnheld(below, skins).regions.empty());
}

TEST(TakeSparseBridges, WhereLinesAreNotKnownTheSkinsAreTakenAsTheyAre) {
  Skins skins = SkinsOf("(-7 -5, 7 -5, 7 5, -7 5)", kAll);
  SparseBelow below = LinesBelow(4);
  below.beads.clear();
  const SparseBridges bridges = TakeUnheld(below, skins);
  EXPECT_NEAR(Mm2(bridges.regions), 140, 1e-3);
}

TEST(TakeSparseBridges, LinesMayLieOnBeadsAndOnWhatIsSolidAround) {
  Skins skins = SkinsOf("(-20 -20, 20 -20, 20 20, -20 20)", kAll);
  const SparseBridges bridges = TakeUnheld(LinesBelow(4), skins);
  EXPECT_NEAR(Mm2(bridges.regions), 1600, 1e-3);
  EXPECT_NEAR(Mm2(Intersection(bridges.bearers, bridges.regions)), 10 * 40 * .45, 1);
  EXPECT_TRUE(Intersection(Difference(bridges.bearers, bridges.regions),
                           MakePolygonsOrDie("(20.1 -1, 20.3 -1, 20.3 1, 20.1 1)"))
                  .size() == 1);
}

}  // namespace
}  // namespace slicefarm::infill::sparse_bridges_test
