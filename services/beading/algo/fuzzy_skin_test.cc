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

std::vector<Path> Rough(FuzzySkin skin, const SkinContext& context = {0, 5}) {
  std::vector<Path> walls = Walls();
  Roughen(Options(skin), context, walls);
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

TEST(Roughen, TheFirstLayerIsRoughOnlyIfItIsAskedFor) {
  EXPECT_EQ(Rough(FuzzySkin::kAllWalls, {0, 0}), Walls());
  BeadingOptions options = Options(FuzzySkin::kAllWalls);
  options.texture.first_layer = true;
  std::vector<Path> walls = Walls();
  Roughen(options, {0, 0}, walls);
  EXPECT_NE(walls[0], Walls()[0]);
}

TEST(Roughen, InnerWallsOnlyWithAllWalls) {
  const std::vector<Path> rough = Rough(FuzzySkin::kEveryWall);
  for (size_t i = 0; i < rough.size(); ++i) EXPECT_NE(rough[i], Walls()[i]) << i;
}

/// Returns the first wall, made rough with a texture.
Path Textured(const FuzzyTexture& texture) {
  BeadingOptions options = Options(FuzzySkin::kContours);
  options.texture = texture;
  std::vector<Path> walls = Walls();
  Roughen(options, {0, 5, 1'000'000, 200'000}, walls);
  return walls[0];
}

/// Returns the largest distance of a path's points from a wall.
double FarthestFrom(const Path& wall, const Path& path) {
  double most = 0;
  for (const Point p : path.points) {
    double nearest = 1e12;
    for (size_t i = 0; i < wall.points.size(); ++i)
      nearest = std::min(
          nearest, DistanceToSegment(p, wall.points[i], wall.points[(i + 1) % wall.points.size()]));
    most = std::max(most, nearest);
  }
  return most;
}

// The path does not change, its width does; corners stay.
TEST(Roughen, ExtrusionChangesWidthsOnly) {
  const Path plain = Walls()[0], rough = Textured({.mode = FuzzyMode::kExtrusion});
  EXPECT_TRUE(WellFormed(rough));
  EXPECT_LE(FarthestFrom(plain, rough), 2);
  for (const Point corner : plain.points) EXPECT_TRUE(std::ranges::count(rough.points, corner));
  const auto [least, most] = std::ranges::minmax(rough.widths_nm);
  EXPECT_LT(least, 250'000);
  EXPECT_GE(least, 50'000);
  EXPECT_GT(most, 700'000);
  EXPECT_LE(most, 750'000);
}

// The inner side of each bead stays in place.
TEST(Roughen, CombinedMovesTheOuterSideOnly) {
  const Path rough = Textured({.mode = FuzzyMode::kCombined});
  ASSERT_GT(rough.points.size(), 100u);
  int tested = 0;
  for (size_t i = 0; i < rough.points.size(); ++i) {
    const Point p = rough.points[i];
    if (p.x < 1'000'000 || p.x > 39'000'000 || p.y > 1'000'000) continue;
    // Along the lower edge, the inner side is above the path.
    EXPECT_NEAR(static_cast<double>(p.y) + static_cast<double>(rough.widths_nm[i]) / 2, 225'000, 2);
    ++tested;
  }
  EXPECT_GT(tested, 0);
}

// Points beside each other move alike if the noise is larger than their distance.
TEST(Roughen, CoherentNoiseIsSmootherThanClassic) {
  const auto roughness = [](const FuzzyTexture& texture) {
    const Path rough = Textured(texture);
    double sum = 0;
    for (size_t i = 1; i < rough.points.size(); ++i)
      if (rough.points[i].x > rough.points[i - 1].x && rough.points[i].y < 1'000'000)
        sum += static_cast<double>(std::abs(rough.points[i].y - rough.points[i - 1].y));
    return sum;
  };
  const double classic = roughness({});
  for (const FuzzyNoise noise : {FuzzyNoise::kPerlin, FuzzyNoise::kBillow, FuzzyNoise::kRidgedMulti,
                                 FuzzyNoise::kVoronoi, FuzzyNoise::kRipple}) {
    const double smooth = roughness({.noise = noise, .scale_mm = 8, .octaves = 1, .ripples = 8});
    EXPECT_GT(smooth, 0) << static_cast<int>(noise);
    EXPECT_LT(smooth, 0.5 * classic) << static_cast<int>(noise);
  }
}

TEST(Roughen, ADotStays) {
  std::vector<Path> walls = {Loop("(0 0, 0.2 0, 0.2 0.2)")};
  const std::vector<Path> plain = walls;
  Roughen(Options(FuzzySkin::kAllWalls), {0, 5}, walls);
  EXPECT_EQ(walls, plain);
}

TEST(Roughen, KeepsVaryingWidths) {
  std::vector<Path> walls = {Loop("(0 0, 40 0, 40 40, 0 40)")};
  walls[0].widths_nm = {400'000, 450'000, 500'000, 550'000};
  Roughen(Options(FuzzySkin::kContours), {0, 5}, walls);
  EXPECT_TRUE(WellFormed(walls[0]));
  const auto [least, most] = std::ranges::minmax(walls[0].widths_nm);
  EXPECT_EQ(least, 400'000);
  EXPECT_EQ(most, 550'000);
}

}  // namespace
}  // namespace slicefarm::beading::fuzzy_skin_test
