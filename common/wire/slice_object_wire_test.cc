#include "common/wire/slice_object_wire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::slice_object_wire_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Transform Counted(double from) {
  Transform transform;
  for (int i = 0; i < 12; ++i) transform(i / 4, i % 4) = from + i;
  return transform;
}

// The structured bindings name every member. A new member does not compile until it is added here,
// and thereby to the message.
PartInput DistinctPart() {
  PartInput part;
  auto& [name, mesh, role, to_object, regions, changes] = part;
  name = "part";
  auto& [file, index, first_triangle, triangle_count] = mesh;
  file = 1;
  index = 2;
  first_triangle = 3;
  triangle_count = 4;
  role = PartRole::kModifier;
  to_object = Counted(100);
  regions = {5, 6, 7};
  changes = {{8, 9}, {20, 21}};
  return part;
}

ObjectInput Distinct() {
  ObjectInput object;
  auto& [name, parts, ranges, copies, to_plate, sunk] = object;
  name = "object";
  parts = {DistinctPart(), {}};
  RangeInput range;
  auto& [from, to, layer_height] = range;
  from = 11;
  to = 12;
  layer_height = 13;
  ranges = {range, {}};
  CopyInput copy;
  auto& [place, at] = copy;
  place = CopyInput::Place::kOriginAt;
  at = {14, -15};
  copies = {copy, {}};
  to_plate = Counted(200);
  sunk = 16.5;
  return object;
}

TEST(SliceObjectWire, Returns) {
  ExpectReturns<v1::SliceObject>(Distinct());
  ExpectReturns<v1::SliceObject>(ObjectInput{});
}

TEST(SliceObjectWire, NoCopiesAreNotOne) {
  ObjectInput object = Distinct();
  object.copies.clear();
  object.parts[0].regions.clear();
  ExpectReturns<v1::SliceObject>(object);
}

TEST(SliceObjectWire, EveryFieldChangedAloneReturns) {
  ExpectEveryChangeReturns<v1::SliceObject, ObjectInput>(ProtoOf<v1::SliceObject>(Distinct()));
}

// Finds fields that are swapped in both directions, which no round trip finds.
TEST(SliceObjectWire, EachMemberIsTheFieldOfItsName) {
  const auto proto = ProtoOf<v1::SliceObject>(Distinct());
  EXPECT_EQ(proto.name(), "object");
  EXPECT_EQ(proto.sunk_mm(), 16.5);
  EXPECT_THAT(proto.to_plate(),
              testing::ElementsAre(200, 201, 202, 203, 204, 205, 206, 207, 208, 209, 210, 211));
  const v1::SlicePart& part = proto.parts(0);
  EXPECT_EQ(part.name(), "part");
  EXPECT_EQ(part.mesh().file(), 1);
  EXPECT_EQ(part.mesh().mesh(), 2);
  EXPECT_EQ(part.mesh().first_triangle(), 3);
  EXPECT_EQ(part.mesh().triangle_count(), 4);
  EXPECT_EQ(part.role(), v1::PART_ROLE_MODIFIER);
  EXPECT_EQ(part.to_object(3), 103);
  EXPECT_THAT(part.regions(), testing::ElementsAre(5, 6, 7));
  EXPECT_EQ(part.changes().at(8), 9);
  EXPECT_EQ(part.changes().at(20), 21);
  EXPECT_EQ(proto.ranges(0).from_nm(), 11);
  EXPECT_EQ(proto.ranges(0).to_nm(), 12);
  EXPECT_EQ(proto.ranges(0).layer_height_nm(), 13);
  EXPECT_EQ(proto.copies(0).place(), v1::SliceCopy::PLACE_ORIGIN_AT);
  EXPECT_EQ(proto.copies(0).at().y_nm(), -15);
}

TEST(SliceObjectWire, EveryRoleAndPlaceReturns) {
  for (int i = 0; i < v1::PartRole_MAX; ++i) {
    ObjectInput object = Distinct();
    object.parts[0].role = static_cast<PartRole>(i);
    object.copies[0].place = static_cast<CopyInput::Place>(i % v1::SliceCopy::Place_MAX);
    ExpectReturns<v1::SliceObject>(object);
  }
}

struct Refused {
  std::string name;
  std::function<void(v1::SliceObject&)> spoil;
  std::string field;
};

class SliceObjectWireRefuses : public testing::TestWithParam<Refused> {};

TEST_P(SliceObjectWireRefuses, NamingTheField) {
  auto proto = ProtoOf<v1::SliceObject>(Distinct());
  GetParam().spoil(proto);
  ExpectMalformed(FromProto(proto).status(), GetParam().field);
}

v1::SlicePart& Part(v1::SliceObject& object) { return *object.mutable_parts(1); }

INSTANTIATE_TEST_SUITE_P(
    Objects, SliceObjectWireRefuses,
    testing::Values(
        Refused{"NanDepth", [](auto& o) { o.set_sunk_mm(kNan); }, "sunk_mm"},
        Refused{"HugeDepth", [](auto& o) { o.set_sunk_mm(-10'001); }, "sunk_mm"},
        Refused{"NoTransform", [](auto& o) { o.clear_to_plate(); }, "to_plate"},
        Refused{"ThirteenNumbers", [](auto& o) { o.add_to_plate(1); }, "to_plate"},
        Refused{"InfiniteTransform", [](auto& o) { o.set_to_plate(11, kInfinity); }, "to_plate"},
        Refused{"NanPartTransform", [](auto& o) { Part(o).set_to_object(0, kNan); },
                "parts[1].to_object"},
        Refused{"NoPartTransform", [](auto& o) { Part(o).clear_to_object(); },
                "parts[1].to_object"},
        Refused{"NoRole", [](auto& o) { Part(o).clear_role(); }, "parts[1].role"},
        Refused{"UnknownRole", [](auto& o) { Part(o).set_role(v1::PartRole(8)); }, "parts[1].role"},
        Refused{"NegativeFile", [](auto& o) { Part(o).mutable_mesh()->set_file(-1); },
                "parts[1].mesh"},
        Refused{"NegativeMesh", [](auto& o) { Part(o).mutable_mesh()->set_mesh(INT32_MIN); },
                "parts[1].mesh"},
        Refused{"NegativeTriangle",
                [](auto& o) { Part(o).mutable_mesh()->set_first_triangle(INT64_MIN); },
                "parts[1].mesh"},
        Refused{"NegativeTriangles",
                [](auto& o) { Part(o).mutable_mesh()->set_triangle_count(-2); }, "parts[1].mesh"},
        Refused{"NegativeRegion", [](auto& o) { Part(o).add_regions(-1); }, "parts[1].regions"},
        Refused{"ChangeOfANegativeRow", [](auto& o) { (*Part(o).mutable_changes())[-1] = 0; },
                "parts[1].changes"},
        Refused{"ChangeToANegativeRow", [](auto& o) { (*Part(o).mutable_changes())[0] = -1; },
                "parts[1].changes"},
        Refused{"NegativeHeight", [](auto& o) { o.mutable_ranges(0)->set_from_nm(-1); },
                "ranges[0].from_nm, to_nm, layer_height_nm"},
        Refused{"HugeHeight", [](auto& o) { o.mutable_ranges(0)->set_to_nm(INT64_MAX); },
                "ranges[0].from_nm, to_nm, layer_height_nm"},
        Refused{"NoPlace", [](auto& o) { o.mutable_copies(1)->clear_place(); }, "copies[1].place"},
        Refused{"UnknownPlace",
                [](auto& o) { o.mutable_copies(1)->set_place(v1::SliceCopy::Place(4)); },
                "copies[1].place"}),
    [](const auto& info) { return info.param.name; });

TEST(SliceObjectWire, RefusesMoreThanAPlateMayHave) {
  auto copies = ProtoOf<v1::SliceObject>(Distinct());
  while (copies.copies_size() <= 1'000) *copies.add_copies() = copies.copies(0);
  EXPECT_EQ(DetailOf(FromProto(copies).status()).reason, Reason::kRequestTooLarge);
  auto changes = ProtoOf<v1::SliceObject>(Distinct());
  for (int i = 0; i <= 1'000; ++i) (*Part(changes).mutable_changes())[i] = i;
  const absl::Status status = FromProto(changes).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge) << status;
  EXPECT_EQ(DetailOf(status).metadata["field"], "parts[1]");
}

TEST(SliceObjectWire, RefusesPlacesBeyondTheWire) {
  ObjectInput object = Distinct();
  object.copies[1].at.y = Coord{1} << 31;
  v1::SliceObject proto;
  const absl::Status status = ToProto(object, &proto);
  EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfRange);
  EXPECT_EQ(DetailOf(status).metadata["field"], "copies[1]");
}

}  // namespace
}  // namespace slicefarm::slice_object_wire_test
