#include "processes/mill/job/mill_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::coordinator::mill_scene_test {
namespace {

using testing::HasSubstr;

/// Returns a corner of a box of 10 x 6 x 4 mm around its own origin, which was at (100, 50, 7) mm
/// in its file.
PlacedSceneObject Corner(const std::string& name, std::vector<Point> shifts) {
  PlacedSceneObject object;
  object.name = name;
  object.to_origin = {FromMm(-105), FromMm(-53), FromMm(-7)};
  object.shifts = std::move(shifts);
  PlacedScenePart& part = object.parts.emplace_back();
  part.mesh.vertices = {{FromMm(-5), FromMm(-3), 0},
                        {FromMm(5), FromMm(-3), 0},
                        {FromMm(-5), FromMm(3), 0},
                        {FromMm(-5), FromMm(-3), FromMm(4)}};
  part.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  part.report.name = name;
  part.report.min_mm = {15, 17, 0};
  part.report.max_mm = {25, 23, 4};
  return object;
}

constexpr Point kAt = {20'000'000, 20'000'000};

PlacingInput TwoObjects() {
  PlacingInput job;
  job.meshes.files = {{"part.stl", MeshFormat::kStl, "part"},
                      {"blank.stl", MeshFormat::kStl, "blank"}};
  job.meshes.objects = {
      {.name = "part.stl", .parts = {{.name = "", .mesh = {0, kOnlyMesh}}}, .ranges = {}},
      {.name = "blank.stl", .parts = {{.name = "", .mesh = {1, kOnlyMesh}}}, .ranges = {}}};
  job.options.objects.resize(2);
  job.options.objects[0].layer_height_nm = 1;
  job.options.objects[1].layer_height_nm = 2;
  return job;
}

TEST(TakeStock, TakesTheObjectOfThatName) {
  const auto none = TakeStock(TwoObjects(), "");
  ASSERT_TRUE(none.ok());
  EXPECT_FALSE(none->stock.has_value());
  EXPECT_EQ(none->parts.meshes.objects.size(), 2u);
  const auto split = TakeStock(TwoObjects(), "blank.stl");
  ASSERT_TRUE(split.ok()) << split.status();
  ASSERT_TRUE(split->stock.has_value());
  EXPECT_EQ(split->parts.meshes.objects.at(0).name, "part.stl");
  EXPECT_EQ(split->parts.options.objects.at(0).layer_height_nm, 1);
  EXPECT_EQ(split->stock->meshes.objects.at(0).name, "blank.stl");
  EXPECT_EQ(split->stock->options.objects.at(0).layer_height_nm, 2);
  EXPECT_EQ(split->stock->meshes.files[1].bytes, "blank");
  EXPECT_EQ(split->stock->meshes.files[0].bytes, "") << "is not sent twice";
}

TEST(TakeStock, NamesWhatIsNoStock) {
  const auto unknown = TakeStock(TwoObjects(), "block.stl");
  EXPECT_EQ(DetailOf(unknown.status()).reason, Reason::kSettingMalformed);
  EXPECT_EQ(DetailOf(unknown.status()).metadata["setting"], "stock");
  EXPECT_THAT(std::string(unknown.status().message()), HasSubstr("part.stl, blank.stl"));
  PlacingInput twice = TwoObjects();
  twice.meshes.objects[1].copies.resize(2);
  EXPECT_THAT(std::string(TakeStock(twice, "blank.stl").status().message()), HasSubstr("several"));
  PlacingInput alone = TwoObjects();
  alone.meshes.objects.erase(alone.meshes.objects.begin());
  EXPECT_EQ(DetailOf(TakeStock(alone, "blank.stl").status()).reason, Reason::kNothingToPrint);
}

TEST(PutAround, PutsTheStockWhereThePartsAre) {
  const PlacedScene parts{{Corner("a", {kAt, kAt + Point{FromMm(30), 0}})}};
  PlacingInput stock = *TakeStock(TwoObjects(), "blank.stl")->stock;
  PutAround(parts, stock);
  const CopyInput& copy = stock.meshes.objects[0].copies[0];
  EXPECT_EQ(copy.place, CopyInput::Place::kMiddleAt);
  EXPECT_EQ(copy.at, (Point{FromMm(35), FromMm(20)}));
  stock.meshes.objects[0].copies[0] = {CopyInput::Place::kMiddleAt, {7, 7}};
  PutAround(parts, stock);
  EXPECT_EQ(stock.meshes.objects[0].copies[0].at, (Point{7, 7})) << "it has a place";
}

TEST(MillSceneOf, LiesWhereTheProgramWantsIt) {
  struct Case {
    MillOrigin origin;
    Vertex first;  ///< position of the first copy
  };
  for (const Case& c : {Case{MillOrigin::kBed, {FromMm(15), FromMm(17), 0}},
                        Case{MillOrigin::kModel, {FromMm(100), FromMm(50), FromMm(7)}},
                        Case{MillOrigin::kStockTop, {FromMm(1), FromMm(1), FromMm(-5)}}}) {
    MillSettings settings;
    settings.origin = c.origin;
    const PlacedScene parts{{Corner("a", {kAt, kAt + Point{FromMm(30), 0}})}};
    const auto scene = MillSceneOf(parts, std::nullopt, settings);
    ASSERT_TRUE(scene.ok()) << scene.status();
    const IndexedMesh& part = scene->input.part;
    EXPECT_EQ(part.vertices.size(), 8u);
    EXPECT_EQ(part.triangles.size(), 8u);
    EXPECT_EQ(part.vertices[0], c.first);
    EXPECT_EQ(part.vertices[4], (Vertex{c.first.x + FromMm(30), c.first.y, c.first.z}));
    EXPECT_EQ(part.triangles[4], (std::array<uint32_t, 3>{4, 6, 5}));
    EXPECT_NEAR(scene->meshes.at(0).min_mm[0], ToMm(static_cast<double>(c.first.x)), 1e-9);
  }
}

TEST(MillSceneOf, HasItsStockBesideIt) {
  MillSettings settings;
  settings.origin = MillOrigin::kStockTop;
  const PlacedScene parts{{Corner("a", {kAt})}}, stock{{Corner("blank", {kAt})}};
  const auto scene = MillSceneOf(parts, stock, settings);
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_EQ(scene->input.stock.vertices[0], (Vertex{0, 0, FromMm(-4)}));
  EXPECT_EQ(scene->input.part, scene->input.stock);
}

TEST(MillSceneOf, TellsWhatItDoesNotMill) {
  PlacedScene parts{{Corner("a", {kAt})}};
  parts.objects[0].parts.push_back(parts.objects[0].parts[0]);
  parts.objects[0].parts[1].role = PartRole::kModifier;
  const auto scene = MillSceneOf(parts, std::nullopt, {});
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_EQ(scene->input.part.triangles.size(), 4u);
  EXPECT_EQ(scene->warnings.size(), 1u);
  parts.objects[0].parts[1].role = PartRole::kNegative;
  EXPECT_EQ(DetailOf(MillSceneOf(parts, std::nullopt, {}).status()).reason,
            Reason::kRequestMalformed);
  PlacedScene far{{Corner("a", {kAt})}};
  far.objects[0].to_origin.x = FromMm(-9'000);
  EXPECT_EQ(DetailOf(MillSceneOf(far, std::nullopt, {}).status()).reason, Reason::kOutOfRange);
}

}  // namespace
}  // namespace slicefarm::coordinator::mill_scene_test
