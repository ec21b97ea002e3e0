#include "services/ordering/algo/unsupported_walls.h"

#include <gtest/gtest.h>

#include <string>

#include "common/geometry/text_format_test.h"

namespace slicefarm::ordering::unsupported_walls_test {
namespace {

/// Returns a square loop with its corner at (at, at).
Path Loop(double at, double size, int32_t inset, bool closed = true) {
  const Point low{FromMm(at), FromMm(at)}, high{FromMm(at + size), FromMm(at + size)};
  Path path;
  path.inset = inset;
  path.closed = closed;
  path.points = {low, {high.x, low.y}, high, {low.x, high.y}};
  path.widths_nm = {450'000};
  return path;
}

TEST(TakeUnsupported, TakesContoursOverAirAlone) {
  const struct {
    std::string name, air;
    bool closed;
    size_t taken;
  } cases[] = {
      {"Both", "(-1 -1, 11 -1, 11 11, -1 11)", true, 2},
      {"NoAir", "", true, 0},
      {"OneRests", "(-1 -1, 11 -1, 11 11, -1 11) (0.1 0.1, 0.1 9.9, 9.9 9.9, 9.9 0.1)", true, 0},
      {"OpenLine", "(-1 -1, 11 -1, 11 11, -1 11)", false, 0},
      {"PillarBetweenTheCorners", "(-1 -1, 11 -1, 11 11, -1 11) (4 -0.5, 4 0.8, 5 0.8, 5 -0.5)",
       true, 0},
  };
  for (const auto& c : cases) {
    Path outer = Loop(0, 10, 0, c.closed), inner = Loop(0.45, 9.1, 1, c.closed);
    std::vector<Path*> walls = {&inner, &outer};
    const MultiPolygon air = c.air.empty() ? MultiPolygon{} : MakePolygonsOrDie(c.air);
    AirBelow below(air);
    const std::vector<Path*> taken = TakeUnsupported(walls, below);
    EXPECT_EQ(taken.size(), c.taken) << c.name;
    EXPECT_EQ(walls.size(), 2 - c.taken) << c.name;
  }
}

TEST(TakeUnsupported, LeavesOtherContours) {
  Path over_air = Loop(0, 10, 0), resting = Loop(20, 10, 0);
  std::vector<Path*> walls = {&resting, &over_air};
  const MultiPolygon air = MakePolygonsOrDie("(-1 -1, 11 -1, 11 11, -1 11)");
  AirBelow below(air);
  const auto taken = TakeUnsupported(walls, below);
  EXPECT_EQ(taken, std::vector<Path*>{&over_air});
  EXPECT_EQ(walls, std::vector<Path*>{&resting});
}

// An offset of all air for each island would be quadratic.
TEST(TakeUnsupported, ManyIslandsAreFast) {
  constexpr Coord kSide = 150;
  MultiPolygon air;
  std::vector<Path> loops;
  for (Coord i = 0; i < kSide * kSide; ++i) {
    const Point low{FromMm(3) * (i % kSide), FromMm(3) * (i / kSide)};
    const Point high{low.x + FromMm(2), low.y + FromMm(2)};
    Path loop = Loop(0.5, 1, 0);
    for (Point& p : loop.points) p = p + low;
    loops.push_back(std::move(loop));
    air.push_back({{low, {high.x, low.y}, high, {low.x, high.y}}, {}});
  }
  AirBelow below(air);
  size_t taken = 0;
  for (Path& loop : loops) {
    std::vector<Path*> walls = {&loop};
    taken += TakeUnsupported(walls, below).size();
  }
  EXPECT_EQ(taken, loops.size());
}

}  // namespace
}  // namespace slicefarm::ordering::unsupported_walls_test
