#include "services/slicing/algo/section/section_regions.h"

#include <gtest/gtest.h>

#include <random>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::slicing::section_regions_test {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }
double Mm2(const MultiPolygon& area) { return Area(area) * 1e-12; }

PartSection Solid(std::string_view text, int32_t row = 0) {
  return {PartRole::kSolid, row, nullptr, P(text)};
}

PartSection Modifier(std::string_view text, const std::map<int32_t, int32_t>& changes) {
  return {PartRole::kModifier, 0, &changes, P(text)};
}

std::map<int32_t, double> Areas(const PartitionedSection& section) {
  std::map<int32_t, double> areas;
  for (const Region& region : section.regions) areas[region.settings] = Mm2(region.outlines);
  return areas;
}

/// Checks that the regions are disjoint and tile the whole.
void ExpectTiles(const PartitionedSection& section) {
  MultiPolygon all;
  double sum = 0;
  for (const Region& region : section.regions) {
    EXPECT_FALSE(region.outlines.empty());
    all.insert(all.end(), region.outlines.begin(), region.outlines.end());
    sum += Mm2(region.outlines);
  }
  const MultiPolygon united = Union(Rings(all), FillRule::kNonZero);
  EXPECT_NEAR(sum, Mm2(united), 1e-6) << "disjoint";
  if (section.regions.size() < 2) return;
  EXPECT_NEAR(Mm2(Difference(section.whole, united)), 0, 1e-6) << "no gap";
  EXPECT_NEAR(Mm2(Difference(united, section.whole)), 0, 1e-6) << "nothing outside";
}

constexpr std::string_view kSquare = "(0 0, 20 0, 20 20, 0 20)";

TEST(Partition, OnePartIsItself) {
  const auto section = Partition({Solid(kSquare, 3)}, {}, 0);
  ASSERT_EQ(section.regions.size(), 1u);
  EXPECT_EQ(section.regions[0].settings, 3);
  EXPECT_EQ(section.regions[0].outlines, P(kSquare));
  EXPECT_TRUE(section.whole.empty());
}

TEST(Partition, NothingIsNothing) {
  EXPECT_TRUE(Partition({Solid("")}, {}, 0).regions.empty());
  EXPECT_TRUE(Partition({}, {}, 0).regions.empty());
  const std::map<int32_t, int32_t> changes = {{0, 1}};
  EXPECT_TRUE(Partition({Solid(""), Modifier(kSquare, changes)}, {}, 0).regions.empty());
}

TEST(Partition, LaterPartsWin) {
  const auto section =
      Partition({Solid(kSquare, 0), Solid("(10 0, 30 0, 30 20, 10 20)", 1)}, {}, 0);
  EXPECT_EQ(Areas(section), (std::map<int32_t, double>{{0, 200}, {1, 400}}));
  ExpectTiles(section);
}

TEST(Partition, PartsOfOneRowAreOneRegion) {
  const auto section =
      Partition({Solid(kSquare, 2), Solid("(10 0, 30 0, 30 20, 10 20)", 2)}, {}, 0);
  EXPECT_EQ(Areas(section), (std::map<int32_t, double>{{2, 600}}));
}

TEST(Partition, ModifiersChangeWhatIsInsideOneAfterTheOther) {
  const std::map<int32_t, int32_t> first = {{0, 1}}, second = {{0, 2}, {1, 3}};
  const auto section = Partition({Solid(kSquare), Modifier("(0 0, 10 0, 10 20, 0 20)", first),
                                  Modifier("(-5 0, 30 0, 30 10, -5 10)", second)},
                                 {}, 0);
  EXPECT_EQ(Areas(section), (std::map<int32_t, double>{{0, 100}, {1, 100}, {2, 100}, {3, 100}}));
  ExpectTiles(section);
}

TEST(Partition, NegativesAreCutOutBeforeModifiers) {
  const std::map<int32_t, int32_t> changes = {{0, 1}};
  PartSection negative = Solid("(0 0, 10 0, 10 10, 0 10)");
  negative.role = PartRole::kNegative;
  const auto section =
      Partition({Solid(kSquare), negative, Modifier("(0 0, 20 0, 20 10, 0 10)", changes)}, {}, 0);
  EXPECT_EQ(Areas(section), (std::map<int32_t, double>{{0, 200}, {1, 100}}));
  ExpectTiles(section);
}

TEST(Partition, SeamPartsChangeNoRegion) {
  PartSection enforcer = Solid("(0 0, 5 0, 5 5, 0 5)");
  enforcer.role = PartRole::kSeamEnforcer;
  PartSection blocker = Solid("(15 15, 25 15, 25 25, 15 25)");
  blocker.role = PartRole::kSeamBlocker;
  const auto section = Partition({Solid(kSquare), enforcer, blocker}, {}, 0);
  EXPECT_EQ(Areas(section), (std::map<int32_t, double>{{0, 400}}));
  ASSERT_EQ(section.marks.size(), 2u);
  EXPECT_EQ(section.marks[0].role, PartRole::kSeamEnforcer);
  EXPECT_EQ(Mm2(section.marks[0].outlines), 25);
  EXPECT_EQ(section.marks[1].role, PartRole::kSeamBlocker);
  EXPECT_EQ(Mm2(section.marks[1].outlines), 100);
}

TEST(Partition, RegionsFollowTheOutlinesOfTheWhole) {
  const std::map<int32_t, int32_t> changes = {{0, 1}};
  for (const Coord grow : {500'000, -500'000}) {
    const auto section = Partition({Solid(kSquare), Modifier("(0 0, 10 0, 10 20, 0 20)", changes)},
                                   {.grow_nm = grow}, 0);
    const double side = 20 + 2 * ToMm(grow);
    EXPECT_NEAR(Mm2(section.whole), side * side, 1e-6);
    ExpectTiles(section);
    EXPECT_EQ(section.regions.size(), 2u);
  }
}

TEST(Partition, TilesWhateverTheParts) {
  std::mt19937 random(3);
  const auto box = [&] {
    const Coord x = random() % 30'000'000, y = random() % 30'000'000;
    const Coord w = 1 + random() % 20'000'000, h = 1 + random() % 20'000'000;
    return MultiPolygon{{{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, {}}};
  };
  const std::map<int32_t, int32_t> changes = {{0, 2}, {1, 3}, {2, 4}, {3, 4}};
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<PartSection> parts;
    for (size_t i = 0; i < 2 + random() % 4; ++i) {
      const auto role = i < 2 ? PartRole::kSolid : static_cast<PartRole>(random() % 3);
      parts.push_back({role, static_cast<int32_t>(i % 2), &changes, box()});
    }
    ExpectTiles(Partition(parts, {}, 0));
    ExpectTiles(Partition(parts, {.grow_nm = trial % 2 == 0 ? 100'000 : -100'000}, 0));
  }
}

}  // namespace
}  // namespace slicefarm::slicing::section_regions_test
