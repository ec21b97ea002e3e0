#include "services/beading/algo/fuzzy_skin.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/measure.h"
#include "common/model/options/beading_options.h"
#include "common/model/paths_test.h"

namespace slicefarm::beading::fuzzy_skin_test {
namespace {

Path Loop(std::string_view points, int32_t inset = 0) {
  Path path = MakePathOrDie(points);
  path.closed = true;
  path.inset = inset;
  path.feature = inset == 0 ? Feature::kExternalPerimeter : Feature::kPerimeter;
  path.widths_nm = {450'000};
  return path;
}

/// Returns an outer wall, a hole's wall and an inner wall.
std::vector<Path> Walls() {
  return {Loop("(0 0, 40 0, 40 40, 0 40)"), Loop("(10 10, 10 20, 20 20, 20 10)"),
          Loop("(1 1, 39 1, 39 39, 1 39)", 1)};
}

BeadingOptions Options(FuzzySkin skin) {
  BeadingOptions options;
  options.fuzzy = skin;
  return options;
}

std::vector<Path> Rough(FuzzySkin skin, SkinSeed seed = {0, 5}) {
  std::vector<Path> walls = Walls();
  Roughen(Options(skin), seed, walls);
  return walls;
}

TEST(Roughen, ChangesTheWallsThatAreAskedFor) {
  const std::vector<Path> plain = Walls();
  EXPECT_EQ(Rough(FuzzySkin::kNone), plain);
  const std::vector<Path> contours = Rough(FuzzySkin::kContours);
  EXPECT_NE(contours[0], plain[0]);
  EXPECT_EQ(contours[1], plain[1]);
  EXPECT_EQ(contours[2], plain[2]);
  const std::vector<Path> all = Rough(FuzzySkin::kAllWalls);
  EXPECT_EQ(all[0], contours[0]);
  EXPECT_NE(all[1], plain[1]);
  EXPECT_EQ(all[2], plain[2]);
}

TEST(Roughen, PointsLieWithinTheThicknessAtRandomDistances) {
  const Path plain = Walls()[0], rough = Rough(FuzzySkin::kContours)[0];
  EXPECT_TRUE(WellFormed(rough));
  // The wall is 160 mm long, with a point each 0.8 mm on average.
  EXPECT_NEAR(static_cast<double>(rough.points.size()), 200, 15);
  double most = 0;
  for (const Point p : rough.points) {
    double nearest = 1e12;
    for (size_t i = 0; i < plain.points.size(); ++i)
      nearest = std::min(nearest, DistanceToSegment(p, plain.points[i],
                                                    plain.points[(i + 1) % plain.points.size()]));
    most = std::max(most, nearest);
  }
  EXPECT_LE(most, 300'001);
  EXPECT_GE(most, 250'000);
}

TEST(Roughen, IsTheSameForTheSameSeedAlone) {
  EXPECT_EQ(Rough(FuzzySkin::kContours), Rough(FuzzySkin::kContours));
  EXPECT_NE(Rough(FuzzySkin::kContours), Rough(FuzzySkin::kContours, {0, 6}));
}

TEST(Roughen, ADotStays) {
  std::vector<Path> walls = {Loop("(0 0, 0.2 0, 0.2 0.2)")};
  const std::vector<Path> plain = walls;
  Roughen(Options(FuzzySkin::kAllWalls), {}, walls);
  EXPECT_EQ(walls, plain);
}

TEST(Roughen, KeepsVaryingWidths) {
  std::vector<Path> walls = {Loop("(0 0, 40 0, 40 40, 0 40)")};
  walls[0].widths_nm = {400'000, 450'000, 500'000, 550'000};
  Roughen(Options(FuzzySkin::kContours), {}, walls);
  EXPECT_TRUE(WellFormed(walls[0]));
  const auto [least, most] = std::ranges::minmax(walls[0].widths_nm);
  EXPECT_EQ(least, 400'000);
  EXPECT_EQ(most, 550'000);
}

}  // namespace
}  // namespace slicefarm::beading::fuzzy_skin_test
