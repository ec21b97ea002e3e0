#include "services/slicing/algo/placement/prepared_object.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"
#include "common/model/scene/placement.h"
#include "services/slicing/algo/placement/placed_object.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::prepared_object_test {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

constexpr Coord kMm = kNmPerMm;

ObjectInput ObjectOf(int32_t file, const Transform& to_plate = Transform::Identity()) {
  ObjectInput object;
  object.name = "part.stl";
  object.parts.resize(1);
  object.parts[0].mesh.file = file;
  object.to_plate = to_plate;
  return object;
}

absl::StatusOr<std::vector<PreparedObject>> Prepare(std::vector<std::string> files,
                                                    std::vector<ObjectInput> objects) {
  SliceInput input;
  for (std::string& bytes : files)
    input.files.push_back({"file", MeshFormat::kUnknown, std::move(bytes)});
  input.objects = std::move(objects);
  SlicingOptions options;
  options.objects.resize(input.objects.size());
  return PrepareObjects(std::move(input), *MakeDirectMeshSource(), options, {});
}

absl::StatusOr<std::vector<PreparedObject>> Prepare(std::string bytes,
                                                    const Placement& placement = {}) {
  return Prepare(std::vector{std::move(bytes)}, {ObjectOf(0, TransformOf(placement))});
}

TEST(PrepareObjects, PutsOneCopyInTheMiddleOfTheBed) {
  const auto objects = Prepare(ToBinaryStl(BoxMesh({0, 0, 0}, {10, 20, 30})));
  ASSERT_TRUE(objects.ok()) << objects.status();
  const PreparedObject& object = objects->at(0);
  EXPECT_THAT(object.shifts, ElementsAre(Point{125 * kMm, 105 * kMm}));
  EXPECT_EQ(object.top_nm, 30 * kMm);
  EXPECT_THAT(object.footprint, SizeIs(4));
  EXPECT_EQ(object.parts[0].report.name, "part.stl");
  EXPECT_EQ(object.parts[0].report.min_mm, (std::array<double, 3>{120, 95, 0}));
  EXPECT_EQ(object.parts[0].report.max_mm, (std::array<double, 3>{130, 115, 30}));
}

/// Some corners differ by less than a nanometre: the mesh is open in the file and closed after
/// rounding.
TEST(PrepareObjects, ReportsTheFileAndSlicesTheRounding) {
  RawMesh box = BoxMesh({0, 0, 0}, {10, 20, 30});
  box.positions.push_back({0, 0, 6.9e-15});
  for (auto& corner : box.triangles[0]) corner = corner == 0 ? 8 : corner;
  const auto objects = Prepare(ToBinaryStl(box));
  ASSERT_TRUE(objects.ok()) << objects.status();
  const PreparedPart& part = objects->at(0).parts[0];
  EXPECT_EQ(part.report.vertices, 9);
  EXPECT_EQ(part.report.open_edges, 4);
  EXPECT_FALSE(part.report.Closed());
  EXPECT_TRUE(part.connected.closed);
}

TEST(PrepareObjects, PassesTheErrorsOn) {
  const std::string box = ToBinaryStl(BoxMesh({0, 0, 0}, {10, 20, 30}));
  EXPECT_EQ(DetailOf(Prepare(box.substr(0, 100)).status()).reason, Reason::kMeshTruncated);
  EXPECT_EQ(DetailOf(Prepare(box, {.unit_mm = 25.4}).status()).reason, Reason::kOutOfBuildVolume);
  EXPECT_EQ(DetailOf(Prepare(box, {.unit_mm = 1000}).status()).reason, Reason::kOutOfRange);
  EXPECT_EQ(DetailOf(Prepare(box, {.scale = {1e-8, 1e-8, 1e-8}}).status()).reason,
            Reason::kMeshEmpty);
}

TEST(PrepareObjects, RefusesProjectsAsSingleMeshes) {
  ObjectInput object = ObjectOf(0);
  object.parts[0].mesh.mesh = kOnlyMesh;
  const auto status = Prepare({std::string("PK\3\4 and more")}, {object}).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr("3MF project"));
  // Given the number of one mesh, the project is read.
  EXPECT_EQ(DetailOf(Prepare(std::string("PK\3\4 and more"), {}).status()).reason,
            Reason::kMeshTruncated);
}

TEST(PrepareObjects, NamesTheObjectOfSeveral) {
  const std::string box = ToBinaryStl(BoxMesh({0, 0, 0}, {10, 20, 30}));
  const auto status = Prepare({box, "solid\n"}, {ObjectOf(0), ObjectOf(1)}).status();
  EXPECT_EQ(DetailOf(status).metadata.at("object"), "1");
}

TEST(PrepareObjects, PartsKeepTheirPlacesInTheObject) {
  ObjectInput object = ObjectOf(0);
  object.parts.push_back(object.parts[0]);
  object.parts[1].to_object(0, 3) = 20;
  object.parts.push_back(object.parts[0]);
  object.parts[2].role = PartRole::kModifier;
  object.parts[2].to_object(2, 3) = -50;
  const auto objects = Prepare({ToBinaryStl(BoxMesh({5, 5, 5}, {15, 15, 15}))}, {object});
  ASSERT_TRUE(objects.ok()) << objects.status();
  const PreparedObject& prepared = objects->at(0);
  // The middle is computed from the solid parts: from 5 to 35.
  EXPECT_EQ(prepared.parts[0].report.min_mm[0] - 125, -15);
  EXPECT_EQ(prepared.parts[1].report.max_mm[0] - 125, 15);
  EXPECT_EQ(prepared.parts[2].report.min_mm[2], -50);
  EXPECT_EQ(prepared.top_nm, 10 * kMm);
}

TEST(PrepareObjects, CopiesStandWhereTheyAreTold) {
  ObjectInput object = ObjectOf(0);
  object.copies = {{CopyInput::Place::kMiddleAt, {50 * kMm + 1'499, 60 * kMm - 1'500}},
                   {CopyInput::Place::kOriginAt, {100 * kMm, 100 * kMm}}};
  const auto objects = Prepare({ToBinaryStl(BoxMesh({10, 20, 0}, {30, 40, 9}))}, {object});
  ASSERT_TRUE(objects.ok()) << objects.status();
  // Shifts are whole micrometres.
  EXPECT_THAT(objects->at(0).shifts, ElementsAre(Point{50 * kMm + 1'000, 60 * kMm - 2'000 + 1'000},
                                                 Point{120 * kMm, 130 * kMm}));
}

TEST(PrepareObjects, CopiesParkedBesideTheBedAreLeftOut) {
  const std::string box = ToBinaryStl(BoxMesh({0, 0, 0}, {20, 20, 9}));
  const CopyInput on{CopyInput::Place::kMiddleAt, {50 * kMm, 60 * kMm}};
  const CopyInput beside{CopyInput::Place::kMiddleAt, {-50 * kMm, 60 * kMm}};
  const CopyInput half{CopyInput::Place::kMiddleAt, {-5 * kMm, 60 * kMm}};
  std::vector<ObjectInput> given = {ObjectOf(0), ObjectOf(0)};
  given[0].copies = {beside, on, beside};
  given[1].copies = {beside};
  const auto objects = Prepare({box}, given);
  ASSERT_TRUE(objects.ok()) << objects.status();
  EXPECT_THAT(objects->at(0).shifts, ElementsAre(Point{50 * kMm, 60 * kMm}));
  EXPECT_EQ(objects->at(0).copies_off_bed, 2);
  EXPECT_THAT(objects->at(1).shifts, SizeIs(0));
  EXPECT_EQ(objects->at(1).copies_off_bed, 1);

  given[1].copies = {half};
  EXPECT_EQ(DetailOf(Prepare({box}, given).status()).reason, Reason::kOutOfBuildVolume);
  given[0].copies = given[1].copies = {beside};
  EXPECT_EQ(DetailOf(Prepare({box}, given).status()).reason, Reason::kOutOfBuildVolume)
      << "nothing would be left";
}

TEST(PrepareObjects, ObjectsWithoutPlacesStandApart) {
  const auto objects = Prepare({ToBinaryStl(BoxMesh({0, 0, 0}, {50, 50, 9}))},
                               {ObjectOf(0), ObjectOf(0), ObjectOf(0)});
  ASSERT_TRUE(objects.ok()) << objects.status();
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j < i; ++j) {
      const Point apart = objects->at(i).shifts[0] - objects->at(j).shifts[0];
      EXPECT_GE(std::max(std::abs(apart.x), std::abs(apart.y)), 56 * kMm) << i << " " << j;
    }
  }
}

TEST(PrepareObjects, WhatIsTooLargeByItselfIsToldWithItsSize) {
  const auto status =
      Prepare({ToBinaryStl(BoxMesh({0, 0, 0}, {400, 50, 9}))}, {ObjectOf(0), ObjectOf(0)}).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfBuildVolume);
  EXPECT_TRUE(DetailOf(status).metadata.contains("excess_mm"));
}

TEST(PrepareObjects, SinksWhatReachesBelowTheBed) {
  ObjectInput object = ObjectOf(0);
  object.sunk_mm = 4;
  const auto objects = Prepare({ToBinaryStl(BoxMesh({0, 0, 7}, {10, 10, 17}))}, {object});
  ASSERT_TRUE(objects.ok()) << objects.status();
  EXPECT_EQ(objects->at(0).top_nm, 6 * kMm);
}

TEST(PrepareObjects, RefusesWhatIsNoObject) {
  const std::string box = ToBinaryStl(BoxMesh({0, 0, 0}, {10, 20, 30}));
  const auto reason = [&](const ObjectInput& object) {
    return DetailOf(Prepare({box}, {object}).status()).reason;
  };
  ObjectInput bad = ObjectOf(0);
  bad.parts[0].role = PartRole::kModifier;
  EXPECT_EQ(reason(bad), Reason::kNothingToPrint) << "no solid part";
  EXPECT_EQ(reason(ObjectOf(1)), Reason::kRequestMalformed) << "no such file";
  bad = ObjectOf(0);
  bad.parts[0].mesh.mesh = 3;
  EXPECT_EQ(reason(bad), Reason::kRequestMalformed) << "no such mesh";
  bad = ObjectOf(0);
  bad.ranges.resize(2);
  EXPECT_EQ(reason(bad), Reason::kRequestMalformed) << "no rows for the ranges";
  bad = ObjectOf(0);
  bad.copies.clear();
  EXPECT_EQ(reason(bad), Reason::kRequestMalformed) << "no copy";
}

/// Source of files with a million triangles that take almost no time to read.
class MillionTriangles : public MeshSource {
 public:
  absl::StatusOr<MeshFileContents> Read(std::string, MeshFormat, double, ReadDepth,
                                        const CancelToken&) const override {
    MeshFileContents contents;
    RawMesh& mesh = contents.meshes.emplace_back();
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 1}};
    mesh.triangles.assign(1'000'000, {0, 1, 2});
    return contents;
  }
};

// A thousand objects that use one file would need a thousand times its memory.
TEST(PrepareObjects, PartsOfOneFileCountEachForThemselves) {
  const MillionTriangles source;
  const CancelToken cancel;
  const std::vector<ObjectInput> objects(21, ObjectOf(0));
  PartMeshes meshes({{"file", MeshFormat::kStl, "bytes"}}, objects, source, cancel);
  for (int64_t i = 0; i < limits::kMaxTriangles / 1'000'000; ++i)
    ASSERT_TRUE(meshes.Take({.file = 0}).ok());
  const ErrorDetail refused = DetailOf(meshes.Take({.file = 0}).status());
  EXPECT_EQ(refused.reason, Reason::kMeshTooLarge);
  EXPECT_EQ(refused.metadata.at("got"), std::to_string(limits::kMaxTriangles + 1'000'000));
}

}  // namespace
}  // namespace slicefarm::slicing::prepared_object_test
