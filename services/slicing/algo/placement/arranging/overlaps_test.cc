#include "services/slicing/algo/placement/arranging/overlaps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "common/geometry/convex.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::slicing::overlaps_test {
namespace {

using testing::ElementsAre;

constexpr Coord kMm = 1'000'000;

Point At(double x_mm, double y_mm) { return {FromMm(x_mm), FromMm(y_mm)}; }

/// Outlines of an object from its bottom up, in layers of one height.
struct Tower {
  std::vector<const char*> outlines;
  Coord height_nm = kMm;
  Coord lift_nm = 0;  ///< height of a raft below the object
};

/// Returns the layers of a job. A layer ends at each height where a layer of some tower ends.
std::vector<SlicedLayer> LayersOf(const std::vector<Tower>& towers) {
  std::map<Coord, std::vector<ObjectSection>> by_top;
  for (size_t object = 0; object < towers.size(); ++object) {
    const Tower& tower = towers[object];
    for (size_t i = 0; i < tower.outlines.size(); ++i) {
      ObjectSection section;
      section.stack = static_cast<int32_t>(object);
      section.layer = static_cast<int32_t>(i);
      section.height_nm = tower.height_nm;
      section.regions.resize(1);
      section.regions[0].outlines = MakePolygonsOrDie(tower.outlines[i]);
      by_top[tower.lift_nm + static_cast<Coord>(i + 1) * tower.height_nm].push_back(section);
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

/// Counts overlapping copies of the towers at the given positions. The footprint of a tower covers
/// all of its outlines.
std::vector<int64_t> Count(const std::vector<Tower>& towers,
                           const std::vector<std::vector<Point>>& places) {
  std::vector<Polygon> hulls;
  for (const Tower& tower : towers) {
    std::vector<Point> points;
    for (const char* outline : tower.outlines)
      for (const PolygonWithHoles& island : MakePolygonsOrDie(outline))
        points.insert(points.end(), island.outer.begin(), island.outer.end());
    hulls.push_back(ConvexHull(std::move(points)));
  }
  std::vector<Copies> copies;
  for (size_t i = 0; i < towers.size(); ++i) copies.push_back({&hulls[i], places[i]});
  return *CountOverlapping(LayersOf(towers), copies, CancelToken());
}

constexpr const char* kSquare = "(0 0, 10 0, 10 10, 0 10)";
constexpr const char* kAngle = "(0 0, 10 0, 10 2, 2 2, 2 10, 0 10)";

TEST(CountOverlapping, OfCopiesOfOneObject) {
  struct Case {
    const char* name;
    Tower tower;
    std::vector<Point> places;
    int64_t count;
  };
  const Case cases[] = {
      {"Apart", {{kSquare}}, {At(0, 0), At(20, 0)}, 0},
      {"Touching", {{kSquare}}, {At(0, 0), At(10, 0)}, 0},
      {"TwoOfThree", {{kSquare}}, {At(0, 0), At(20, 0), At(29, 9)}, 2},
      {"OneInTheCornerOfTheOther", {{kAngle}}, {At(0, 0), At(3, 3)}, 0},
      {"OneInTheWallOfTheOther", {{kAngle}}, {At(0, 0), At(1, 3)}, 2},
      {"RowInCorners", {{kAngle}}, {At(0, 0), At(3, 3), At(6, 6), At(9, 9)}, 0},
      {"OnlyOnTop", {{kAngle, kAngle, kSquare}}, {At(0, 0), At(3, 3)}, 2},
      {"AtTheSamePlace", {{kSquare}}, {At(0, 0), At(0, 0), At(0, 0)}, 3},
  };
  for (const Case& c : cases)
    EXPECT_THAT(Count({c.tower}, {c.places}), ElementsAre(c.count)) << c.name;
}

TEST(CountOverlapping, OfTwoObjects) {
  const Tower arch = {{"(0 0, 2 0, 2 10, 0 10) (8 0, 10 0, 10 10, 8 10)", kSquare}};
  const Tower block = {{"(3 3, 7 3, 7 7, 3 7)"}};
  const Tower pillar = {{"(3 3, 7 3, 7 7, 3 7)", "(3 3, 7 3, 7 7, 3 7)"}};
  const std::vector<std::vector<Point>> here = {{At(0, 0)}, {At(0, 0)}};
  EXPECT_THAT(Count({arch, block}, here), ElementsAre(0, 0)) << "one above the other";
  EXPECT_THAT(Count({arch, pillar}, here), ElementsAre(1, 1));
  const Tower on_raft = {block.outlines, kMm, kMm};
  EXPECT_THAT(Count({arch, on_raft}, here), ElementsAre(1, 1)) << "lifted into the arch";
}

TEST(CountOverlapping, OfLayersOfDifferentHeights) {
  // The second object's layer is thinner. No layer of the job ends at the top of both.
  const Tower thick = {{"(0 0, 2 0, 2 10, 0 10)", kSquare}, 3 * kMm};
  const Tower low = {{"(3 3, 7 3, 7 7, 3 7)"}, 2 * kMm};
  const Tower high = {{low.outlines[0], low.outlines[0]}, 2 * kMm};
  const std::vector<std::vector<Point>> here = {{At(0, 0)}, {At(0, 0)}};
  EXPECT_THAT(Count({thick, low}, here), ElementsAre(0, 0));
  EXPECT_THAT(Count({thick, high}, here), ElementsAre(1, 1));
  EXPECT_THAT(Count({high, thick}, here), ElementsAre(1, 1));
}

TEST(CountOverlapping, CanBeCancelled) {
  const std::vector<SlicedLayer> layers = LayersOf({{{kSquare}}});
  const Polygon hull = MakePolygonsOrDie(kSquare)[0].outer;
  const std::vector<Point> places = {At(0, 0), At(1, 1)};
  const CancelToken cancelled([] { return true; });
  EXPECT_TRUE(absl::IsCancelled(
      CountOverlapping(layers, std::vector<Copies>{{&hull, places}}, cancelled).status()));
}

}  // namespace
}  // namespace slicefarm::slicing::overlaps_test
