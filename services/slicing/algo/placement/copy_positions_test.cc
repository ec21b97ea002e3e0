#include "services/slicing/algo/placement/copy_positions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"

namespace slicefarm::slicing::copy_positions_test {
namespace {

using testing::ElementsAre;

constexpr Coord kMm = kNmPerMm;
constexpr CopyInput kAnywhere = {CopyInput::Place::kAnywhere, {}};

Polygon Rectangle(Coord width_mm, Coord depth_mm) {
  const Coord x = width_mm * kMm / 2, y = depth_mm * kMm / 2;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

CopyInput MiddleAt(Coord x_mm, Coord y_mm) {
  return {CopyInput::Place::kMiddleAt, {x_mm * kMm, y_mm * kMm}};
}

absl::StatusOr<std::vector<std::vector<Point>>> PlaceOne(const Polygon& footprint,
                                                         const std::vector<CopyInput>& copies,
                                                         Coord growth_nm = 0) {
  SlicingOptions options;
  options.objects[0].xy_compensation_nm = growth_nm;
  const ObjectToPlace object{"part", footprint, {}, copies};
  return PlaceCopies({&object, 1}, options, {});
}

TEST(PlaceCopies, ACopyAloneStandsInTheMiddle) {
  const auto places = PlaceOne(Rectangle(10, 10), {kAnywhere});
  ASSERT_TRUE(places.ok()) << places.status();
  EXPECT_THAT(places->at(0), ElementsAre(Point{125 * kMm, 105 * kMm}));
}

// If a single copy is too large for the bed, the later check gives a better error.
TEST(PlaceCopies, ACopyAloneIsNotChecked) {
  EXPECT_TRUE(PlaceOne(Rectangle(900, 900), {kAnywhere}).ok());
}

TEST(PlaceCopies, PlacesAreKeptToTheMicrometre) {
  const ObjectToPlace object{"part", Rectangle(10, 10), {2 * kMm + 400, 0}, {}};
  const std::vector<CopyInput> copies = {MiddleAt(50, 60),
                                         {CopyInput::Place::kOriginAt, {50 * kMm, 60 * kMm}}};
  const ObjectToPlace placed{"part", object.footprint, object.middle, copies};
  const auto places = PlaceCopies({&placed, 1}, {}, {});
  ASSERT_TRUE(places.ok()) << places.status();
  EXPECT_THAT(places->at(0), ElementsAre(Point{50 * kMm, 60 * kMm}, Point{52 * kMm, 60 * kMm}));
}

TEST(PlaceCopies, ManyStandApartAndOnTheBed) {
  const Polygon footprint = Rectangle(30, 20);
  std::vector<CopyInput> copies(20, kAnywhere);
  copies.push_back(MiddleAt(100, 100));
  const auto places = PlaceOne(footprint, copies);
  ASSERT_TRUE(places.ok()) << places.status();
  const std::vector<Point>& at = places->at(0);
  ASSERT_EQ(at.size(), 21u);
  EXPECT_EQ(at[20], (Point{100 * kMm, 100 * kMm}));
  const MultiPolygon bed = {{SlicingOptions().bed, {}}};
  for (size_t i = 0; i < at.size(); ++i) {
    const Polygon one = Moved(footprint, at[i]);
    EXPECT_EQ(Area(Difference({{one, {}}}, bed)), 0) << i;
    for (size_t j = 0; j < i; ++j)
      EXPECT_GE(ConvexDistance(ConvexHull(one), ConvexHull(Moved(footprint, at[j]))), 6.0 * kMm - 1)
          << i << " " << j;
  }
}

SlicingOptions BedWithoutCorner() {
  SlicingOptions options;
  options.bed = {{0, 0}, {256 * kMm, 0}, {256 * kMm, 256 * kMm}, {0, 256 * kMm}};
  options.excluded = {{{0, 0}, {18 * kMm, 0}, {18 * kMm, 28 * kMm}, {0, 28 * kMm}}};
  return options;
}

TEST(PlaceCopies, ACopyAloneMakesWayForAnExcludedArea) {
  const SlicingOptions options = BedWithoutCorner();
  const std::vector<CopyInput> copies = {kAnywhere};
  const auto place = [&](Coord width, Coord depth) {
    const Polygon footprint = Rectangle(width, depth);
    const ObjectToPlace object{"part", footprint, {}, copies};
    return PlaceCopies({&object, 1}, options, {});
  };
  const auto small = place(20, 20);
  ASSERT_TRUE(small.ok()) << small.status();
  EXPECT_THAT(small->at(0), ElementsAre(Point{128 * kMm, 128 * kMm}));
  const auto wide = place(230, 250);
  ASSERT_TRUE(wide.ok()) << wide.status();
  EXPECT_GE(wide->at(0).at(0).x, (18 + 115) * kMm);
  const auto large = place(250, 250);
  ASSERT_FALSE(large.ok());
  EXPECT_EQ(DetailOf(large.status()).reason, Reason::kOutOfBuildVolume);
  EXPECT_NE(large.status().message().find("outside of bed_exclude_area"), absl::string_view::npos);
}

TEST(PlaceCopies, KeepTheLargerOfDistanceAndClearance) {
  const Polygon footprint = Rectangle(30, 20);
  const std::vector<CopyInput> copies(4, kAnywhere);
  const ObjectToPlace object{"part", footprint, {}, copies};
  const auto least_distance = [&](Coord part_distance, Coord clearance) {
    SlicingOptions options;
    options.part_distance_nm = part_distance;
    options.clearance_radius_nm = clearance;
    const std::vector<Point> at = PlaceCopies({&object, 1}, options, {})->at(0);
    double least = 1e18;
    for (size_t i = 0; i < at.size(); ++i)
      for (size_t j = 0; j < i; ++j)
        least = std::min(least, ConvexDistance(ConvexHull(Moved(footprint, at[i])),
                                               ConvexHull(Moved(footprint, at[j]))));
    return least;
  };
  EXPECT_NEAR(least_distance(0, 0), 0, 1e3);
  EXPECT_NEAR(least_distance(9 * kMm, 0), 9 * kMm, 1e3);
  EXPECT_NEAR(least_distance(9 * kMm, 20 * kMm), 20 * kMm, 1e3);
  EXPECT_NEAR(least_distance(25 * kMm, 20 * kMm), 25 * kMm, 1e3);
}

TEST(PlaceCopies, SaysHowManyHaveNoRoom) {
  const auto places = PlaceOne(Rectangle(120, 100), std::vector<CopyInput>(9, kAnywhere));
  EXPECT_EQ(DetailOf(places.status()).reason, Reason::kOutOfBuildVolume);
  EXPECT_THAT(std::string(places.status().message()), testing::HasSubstr("of 9 copies do not fit"));
}

TEST(PlaceCopies, NamesTheObjectsWithoutRoom) {
  const Polygon small = Rectangle(10, 10), large = Rectangle(200, 200);
  const std::vector<CopyInput> one(1, kAnywhere), two(2, kAnywhere);
  const std::vector<ObjectToPlace> objects = {{"small", small, {}, one},
                                              {"lar\nge", large, {}, two}};
  const absl::Status status = PlaceCopies(objects, {}, {}).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfBuildVolume);
  EXPECT_EQ(status.message(), "1 of 3 copies do not fit on the bed: 1 of \"lar\\nge\"");
  const std::vector<ObjectToPlace> unnamed = {{"", small, {}, one}, {"", large, {}, two}};
  EXPECT_EQ(PlaceCopies(unnamed, {}, {}).status().message(),
            "1 of 3 copies do not fit on the bed: 1 of object 2 (without a name)");
}

TEST(PlaceCopies, OutlinesThatGrowStayOnTheBed) {
  const std::vector<CopyInput> two(2, kAnywhere);
  EXPECT_TRUE(PlaceOne(Rectangle(122, 210), two).ok());
  EXPECT_EQ(DetailOf(PlaceOne(Rectangle(122, 210), two, 1'000).status()).reason,
            Reason::kOutOfBuildVolume);
}

TEST(PlaceCopies, TheSettingsChooseThePlace) {
  SlicingOptions options;
  options.best_x = 0.7;
  const std::vector<CopyInput> one = {kAnywhere};
  const ObjectToPlace part{"part", Rectangle(10, 10), {}, one};
  const auto places = PlaceCopies({&part, 1}, options, {});
  ASSERT_TRUE(places.ok()) << places.status();
  EXPECT_THAT(places->at(0), ElementsAre(Point{175 * kMm, 105 * kMm}));
  options.best_x = 1;
  const auto edge = PlaceCopies({&part, 1}, options, {});
  ASSERT_TRUE(edge.ok()) << edge.status();
  EXPECT_NEAR(static_cast<double>(edge->at(0)[0].x), 245e6, 0.1e6) << "as far as the bed allows";
}

}  // namespace
}  // namespace slicefarm::slicing::copy_positions_test
