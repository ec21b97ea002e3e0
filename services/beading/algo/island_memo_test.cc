#include "services/beading/algo/island_memo.h"

#include <gtest/gtest.h>

#include <memory>

#include "common/geometry/text_format_test.h"
#include "common/model/options/beading_options.h"
#include "services/beading/algo/section_walls.h"

namespace slicefarm::beading::island_memo_test {
namespace {

const BeadingOptions kOptions;

IslandKey KeyOf(std::string_view text) {
  return {&kOptions, WallPlan::Make(3, 450'000, 450'000, 200'000), 200'000,
          MakePolygonsOrDie(text)[0]};
}

constexpr std::string_view kSquare = "(0 0, 9 0, 9 9, 0 9)";

double Twice(double, double, double radius_nm) { return 2 * radius_nm; }

/// Returns a memo with the square, made with one question to `Twice`.
std::unique_ptr<IslandMemo> MemoWithSquare() {
  auto memo = std::make_unique<IslandMemo>();
  EXPECT_EQ(memo->Find(KeyOf(kSquare), Twice), nullptr);
  EXPECT_EQ(memo->Noting(Twice)(1, 2, 3), 6);
  KnownIsland island;
  island.beads.fill_area = MakePolygonsOrDie("(1 1, 8 1, 8 8, 1 8)");
  island.plain_islands = 1;
  memo->Keep(KeyOf(kSquare), island);
  return memo;
}

TEST(IslandMemo, KnowsAnIslandAgain) {
  const auto memo = MemoWithSquare();
  const KnownIsland* known = memo->Find(KeyOf(kSquare), Twice);
  ASSERT_NE(known, nullptr);
  EXPECT_EQ(known->beads.fill_area, MakePolygonsOrDie("(1 1, 8 1, 8 8, 1 8)"));
  EXPECT_EQ(known->plain_islands, 1);
}

TEST(IslandMemo, OtherKeysAreOtherIslands) {
  const auto memo = MemoWithSquare();
  EXPECT_EQ(memo->Find(KeyOf("(0 0, 9 0, 9 9.000001, 0 9)"), Twice), nullptr);
  EXPECT_EQ(memo->Find(KeyOf("(0 0, 9 0, 9 9, 0 9) (3 3, 3 6, 6 6, 6 3)"), Twice), nullptr);
  IslandKey key = KeyOf(kSquare);
  key.plan.perimeters = 2;
  EXPECT_EQ(memo->Find(key, Twice), nullptr);
  key = KeyOf(kSquare);
  key.layer_height_nm = 100'000;
  EXPECT_EQ(memo->Find(key, Twice), nullptr);
  const BeadingOptions others;
  key = KeyOf(kSquare);
  key.options = &others;
  EXPECT_EQ(memo->Find(key, Twice), nullptr);
}

TEST(IslandMemo, AsksAgain) {
  const auto memo = MemoWithSquare();
  int questions = 0;
  const auto ask = [&](double x, double y, double radius_nm) {
    ++questions;
    return x == 1 && y == 2 && radius_nm == 3 ? 6.0 : 0.0;
  };
  EXPECT_NE(memo->Find(KeyOf(kSquare), ask), nullptr);
  EXPECT_EQ(questions, 1);
  EXPECT_EQ(memo->Find(KeyOf(kSquare), [](double, double, double) { return 7.0; }), nullptr);
}

TEST(IslandMemo, ForgetsIslandsThatALayerDidNotHave) {
  const auto memo = MemoWithSquare();
  for (int layer = 0; layer < 3; ++layer) {
    memo->NextLayer();
    EXPECT_NE(memo->Find(KeyOf(kSquare), Twice), nullptr);
  }
  memo->NextLayer();
  memo->NextLayer();
  EXPECT_EQ(memo->Find(KeyOf(kSquare), Twice), nullptr);
}

ObjectSection SectionOf(std::string_view text, int32_t layer) {
  ObjectSection section{0, layer, 9, 200'000, {}, {}, 0, {}};
  section.regions = {{Role::kPart, 0, 0, MakePolygonsOrDie(text)}};
  return section;
}

// The wedge is between two and three beads wide, so that its walls depend on other layers. The
// third layer is equal to the second one, but has another neighbour.
TEST(IslandMemo, WallsAreTheSameWithAndWithout) {
  constexpr std::string_view kWedge = "(0 0, 20 0, 20 1.4, 0 0.9) (15 0.4, 15 0.9, 16 0.9, 16 0.4)";
  constexpr std::string_view kWider = "(0 0, 20 0, 20 1.45, 0 0.95)";
  std::vector<ObjectSection> sections;
  std::vector<const MultiPolygon*> outlines;
  for (const std::string_view text : {kWedge, kWedge, kWedge, kWider, kWedge, kWedge})
    sections.push_back(SectionOf(text, static_cast<int32_t>(sections.size()) + 1));
  for (const ObjectSection& section : sections) outlines.push_back(&OutlineOf(section));
  const NeighbourOutlines neighbours(outlines);
  for (const WallGenerator generator : {WallGenerator::kArachne, WallGenerator::kClassic}) {
    std::vector<BeadingOptions> regions(1);
    regions[0].generator = generator;
    IslandMemo memo;
    for (size_t i = 0; i < sections.size(); ++i) {
      const auto with = WallSection({sections[i], false, neighbours, i, &memo}, regions, {});
      const auto without = WallSection({sections[i], false, neighbours, i}, regions, {});
      ASSERT_TRUE(with.ok());
      ASSERT_TRUE(without.ok());
      ASSERT_FALSE(without->walled.islands.empty());
      EXPECT_EQ(with->walled.islands[0].walls, without->walled.islands[0].walls) << i;
      EXPECT_EQ(with->plain_islands, without->plain_islands);
      memo.NextLayer();
    }
  }
}

}  // namespace
}  // namespace slicefarm::beading::island_memo_test
