#include "services/slicing/algo/placement/build_volume.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/model/scene/rotation.h"
#include "services/slicing/algo/placement/arranging/footprint.h"
#include "services/slicing/algo/placement/placement.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::build_volume_test {
namespace {

constexpr Coord kMm = kNmPerMm;

IndexedMesh Box(double x, double y, double z) { return *PlaceMesh(BoxMesh({0, 0, 0}, {x, y, z})); }

absl::Status Check(const IndexedMesh& mesh, std::string_view name,
                   const std::vector<Point>& centers, const SlicingOptions& options) {
  const IndexedMesh* const meshes[] = {&mesh};
  return CheckBuildVolume(
      {Footprint(meshes), ExtentOf(mesh).max.z, options.objects[0].xy_compensation_nm}, name,
      centers, options);
}

SlicingOptions Bed(double x, double y, double height = 0) {
  SlicingOptions options;
  options.bed = {{0, 0}, {FromMm(x), 0}, {FromMm(x), FromMm(y)}, {0, FromMm(y)}};
  options.max_print_height_nm = FromMm(height);
  return options;
}

TEST(BedCenter, IsTheMiddleOfTheBox) {
  EXPECT_EQ(BedCenter(Bed(250, 210).bed), (Point{125 * kMm, 105 * kMm}));
  EXPECT_EQ(BedCenter({{-100, -80}, {100, -80}, {0, 90}}), (Point{0, 5}));
  EXPECT_EQ(BedCenter({}), (Point{0, 0}));
}

TEST(CheckBuildVolume, AcceptsExactFits) {
  EXPECT_TRUE(Check(Box(100, 50, 30), "a", {{50 * kMm, 25 * kMm}}, Bed(100, 50, 30)).ok());
}

TEST(CheckBuildVolume, CountsWhatOutlinesAreGrownBy) {
  SlicingOptions options = Bed(100, 50, 30);
  const std::vector<Point> centre = {{50 * kMm, 25 * kMm}};
  options.objects[0].xy_compensation_nm = 2 * kMm;
  EXPECT_TRUE(Check(Box(96, 46, 30), "a", centre, options).ok());
  const ErrorDetail detail = DetailOf(Check(Box(98, 46, 30), "a", centre, options));
  EXPECT_EQ(detail.reason, Reason::kOutOfBuildVolume);
  options.objects[0].xy_compensation_nm = -2 * kMm;
  EXPECT_FALSE(Check(Box(102, 46, 30), "a", centre, options).ok());
}

TEST(CheckBuildVolume, SaysHowFarAPartReachesOut) {
  const absl::Status status = Check(Box(100, 50, 30), "a\n.stl",
                                    {{50 * kMm, 25 * kMm}, {53 * kMm, 25 * kMm}}, Bed(100, 50));
  const ErrorDetail detail = DetailOf(status);
  EXPECT_EQ(detail.reason, Reason::kOutOfBuildVolume);
  EXPECT_EQ(detail.metadata.at("excess_mm"), "3.000");
  EXPECT_EQ(detail.metadata.at("got"), "100.000 x 50.000 mm");
  EXPECT_EQ(status.message().find('\n'), absl::string_view::npos);
}

TEST(CheckBuildVolume, SaysHowMuchTooHighAPartIs) {
  const ErrorDetail detail =
      DetailOf(Check(Box(10, 10, 30.5), "a", {{50 * kMm, 25 * kMm}}, Bed(100, 50, 30)));
  EXPECT_EQ(detail.reason, Reason::kOutOfBuildVolume);
  EXPECT_EQ(detail.metadata.at("excess_mm"), "0.500");
}

TEST(CheckBuildVolume, ARoundPartFitsARoundBedThatItsBoxDoesNot) {
  Polygon round;
  for (int i = 0; i < 64; ++i) {
    const auto [sine, cosine] = SineCosineDegrees(360.0 * i / 64);
    round.push_back({FromMm(42 * cosine), FromMm(42 * sine)});
  }
  SlicingOptions options;
  options.bed = round;
  const IndexedMesh torus = *PlaceMesh(TorusMesh({}));
  EXPECT_TRUE(Check(torus, "ring", {{0, 0}}, options).ok());
  EXPECT_FALSE(Check(torus, "ring", {{5 * kMm, 0}}, options).ok());
  EXPECT_FALSE(Check(Box(80, 80, 20), "box", {{0, 0}}, options).ok());
}

TEST(CheckBuildVolume, NamesTheSettingOfTheAreaThatMustRemainFree) {
  SlicingOptions options = Bed(256, 256);
  options.wrapping = {{{0, 0}, {18 * kMm, 0}, {18 * kMm, 28 * kMm}, {0, 28 * kMm}}};
  const absl::Status status = Check(Box(20, 20, 9), "a", {{10 * kMm, 10 * kMm}}, options);
  EXPECT_EQ(DetailOf(status).metadata.at("setting"), "wrapping_exclude_area");
  EXPECT_TRUE(Check(Box(20, 20, 9), "a", {{128 * kMm, 128 * kMm}}, options).ok());
}

TEST(CheckBuildVolume, RefusesWhatReachesIntoAnExcludedArea) {
  SlicingOptions options = Bed(256, 256);
  options.excluded = {{{0, 0}, {18 * kMm, 0}, {18 * kMm, 28 * kMm}, {0, 28 * kMm}}};
  struct Case {
    const char* name;
    Point center;
    bool fits;
  };
  for (const Case& each :
       {Case{"far", {128 * kMm, 128 * kMm}, true}, Case{"at its side", {28 * kMm, 20 * kMm}, true},
        Case{"behind it", {10 * kMm, 38 * kMm}, true},
        Case{"over its corner", {27 * kMm, 37 * kMm}, false},
        Case{"within", {10 * kMm, 10 * kMm}, false}}) {
    const absl::Status status = Check(Box(20, 20, 9), "a", {each.center}, options);
    EXPECT_EQ(status.ok(), each.fits) << each.name << ": " << status;
    if (each.fits) continue;
    const ErrorDetail detail = DetailOf(status);
    EXPECT_EQ(detail.reason, Reason::kOutOfBuildVolume) << each.name;
    EXPECT_EQ(detail.metadata.at("setting"), "bed_exclude_area") << each.name;
    EXPECT_EQ(detail.metadata.at("object"), "a") << each.name;
  }
  options.objects[0].xy_compensation_nm = kMm / 2;
  EXPECT_FALSE(Check(Box(20, 20, 9), "a", {{28 * kMm, 20 * kMm}}, options).ok());
}

TEST(CheckBuildVolume, NoBedIsNoLimitButTheNumbersAre) {
  SlicingOptions options;
  options.bed = {};
  EXPECT_TRUE(Check(Box(1000, 1000, 10), "a", {{0, 0}}, options).ok());
  for (const Point center :
       {Point{2'099 * kMm, 0}, Point{0, -2'099 * kMm}, Point{INT64_MAX, INT64_MIN}}) {
    const absl::Status status = Check(Box(10, 10, 10), "a", {center}, options);
    EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfRange);
  }
}

}  // namespace
}  // namespace slicefarm::slicing::build_volume_test
