#include "services/infill/algo/fields/region_fields.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/text_format_test.h"
#include "common/model/options/infill_options.h"

namespace slicefarm::infill::region_fields_test {
namespace {

std::vector<SlicedLayer> Layers() {
  std::vector<SlicedLayer> layers(20);
  for (int i = 0; i < 20; ++i) {
    ObjectSection section{
        0,  i, 20, 500'000, {{Role::kPart, 0, 0, MakePolygonsOrDie("(0 0, 30 0, 30 30, 0 30)")}},
        {}, 0, {}};
    section.z_nm = 500'000 * (i + 1);
    layers[static_cast<size_t>(i)].sections = {section};
  }
  return layers;
}

TEST(RegionFields, AreNoneWhereNothingIsSet) {
  const auto rows = ParseFields(std::vector<InfillOptions>(2));
  ASSERT_TRUE(rows.ok()) << rows.status();
  RegionFields fields(*rows, {});
  EXPECT_FALSE(fields.Of(1, 0, 3, 1)->has_value());
}

TEST(RegionFields, AreThoseOfTheirRow) {
  std::vector<InfillOptions> regions(3);
  regions[1].density_field = R"({"kind":"height","table":[[0,0.1],[10,0.3]]})";
  regions[2].stress_field = R"({"kind":"constant","stress":[1,0,0]})";
  regions[2].density = 0.35;
  const auto rows = ParseFields(regions);
  ASSERT_TRUE(rows.ok()) << rows.status();
  RegionFields fields(*rows, {});
  const auto density = *fields.Of(1, 0, 3, 5);
  ASSERT_TRUE(density.has_value());
  EXPECT_EQ(density->directions, nullptr);
  EXPECT_DOUBLE_EQ(density->DensityAt(Point{7, 7}), 0.2);
  const auto stress = *fields.Of(2, 0, 3, 5);
  ASSERT_TRUE(stress.has_value());
  EXPECT_NE(stress->directions, nullptr);
  EXPECT_EQ(stress->DensityAt(Point{7, 7}), 0.35);
}

TEST(RegionFields, RememberLinesOfFieldsThatAreTheSameAtAllHeights) {
  std::vector<InfillOptions> regions(3);
  for (InfillOptions& options : regions)
    options.stress_field = R"({"kind":"constant","stress":[1,0,0]})";
  regions[1].density_field = R"({"kind":"height","table":[[0,0.1],[10,0.3]]})";
  regions[2].density_field =
      R"({"kind":"voxels","count":[2,1,1],"origin":[0,0,0],"spacing":[1,1,1],"values":[0.1,0.2]})";
  const auto rows = ParseFields(regions);
  ASSERT_TRUE(rows.ok()) << rows.status();
  RegionFields fields(*rows, {});
  EXPECT_NE((*fields.Of(0, 0, 3, 5))->memo, nullptr);
  EXPECT_EQ((*fields.Of(1, 0, 3, 5))->memo, nullptr);
  EXPECT_NE((*fields.Of(2, 0, 3, 5))->memo, nullptr);
}

// Layers that are filled at once count as one.
TEST(RegionFields, FollowBothFamiliesInTurn) {
  std::vector<InfillOptions> regions(2);
  for (InfillOptions& options : regions)
    options.stress_field = R"({"kind":"constant","stress":[1,0,0]})";
  regions[1].every_layers = 3;
  const auto rows = ParseFields(regions);
  ASSERT_TRUE(rows.ok()) << rows.status();
  RegionFields fields(*rows, {});
  for (int layer = 0; layer < 12; ++layer) {
    EXPECT_EQ((*fields.Of(0, 0, layer, 5))->across, layer % 2 == 1) << layer;
    EXPECT_EQ((*fields.Of(1, 0, layer, 5))->across, layer / 3 % 2 == 1) << layer;
  }
  EXPECT_NE((*fields.Of(0, 0, 2, 5))->memo, (*fields.Of(0, 0, 3, 5))->memo);
}

TEST(RegionFields, LookForTheSurface) {
  std::vector<InfillOptions> regions(1);
  regions[0].density_field = R"({"kind":"surface_distance","near":0.6,"far":0.2,"length":4})";
  const auto layers = Layers();
  const auto rows = ParseFields(regions);
  ASSERT_TRUE(rows.ok()) << rows.status();
  RegionFields fields(*rows, layers);
  const auto field = *fields.Of(0, 0, 10, 5.25);
  ASSERT_TRUE(field.has_value());
  EXPECT_NEAR(field->DensityAt(1.0, 15), 0.5, 0.03);
  EXPECT_NEAR(field->DensityAt(15, 15), 0.2, 1e-6);
}

TEST(RegionFields, OfAnObjectThatIsNotAtHandAreThoseOfItsSurface) {
  std::vector<InfillOptions> regions(1);
  regions[0].density_field = R"({"kind":"surface_distance","near":0.6,"far":0.2,"length":4})";
  const auto layers = Layers();
  const auto rows = ParseFields(regions);
  ASSERT_TRUE(rows.ok()) << rows.status();
  RegionFields fields(*rows, layers);
  EXPECT_EQ((*fields.Of(0, 7, 10, 5.25))->DensityAt(15, 15), 0.6);
}

TEST(RegionFields, RefuseTextsThatAreNone) {
  for (const bool density : {true, false}) {
    std::vector<InfillOptions> regions(1);
    (density ? regions[0].density_field : regions[0].stress_field) = "x";
    const auto fields = ParseFields(regions);
    ASSERT_FALSE(fields.ok());
    EXPECT_EQ(DetailOf(fields.status()).reason, Reason::kSettingMalformed);
    EXPECT_EQ(DetailOf(fields.status()).metadata.at("setting"),
              density ? "density_field" : "stress_field");
  }
}

TEST(RegionFields, ATextIsReadOnceForAllWhoHaveIt) {
  std::vector<InfillOptions> regions(3);
  regions[0].density_field = regions[2].density_field = R"({"kind":"height","table":[[0,0.1]]})";
  regions[1].density_field = R"({"kind":"height","table":[[0,0.2]]})";
  const auto rows = ParseFields(regions);
  ASSERT_TRUE(rows.ok()) << rows.status();
  EXPECT_EQ((*rows)[0].density, (*rows)[2].density);
  EXPECT_NE((*rows)[0].density, (*rows)[1].density);
}

}  // namespace
}  // namespace slicefarm::infill::region_fields_test
