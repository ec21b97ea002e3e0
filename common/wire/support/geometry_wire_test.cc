#include "common/wire/support/geometry_wire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "common/base/error.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::geometry_wire_test {
namespace {

constexpr Coord kMost = std::numeric_limits<int32_t>::max();
constexpr Coord kLeast = std::numeric_limits<int32_t>::min();

v1::MultiPolygon Proto(const MultiPolygon& polygons) {
  v1::MultiPolygon proto;
  EXPECT_TRUE(ToProto(polygons, &proto).ok());
  return proto;
}

struct Case {
  std::string name;
  MultiPolygon polygons;
};

class MultiPolygonWire : public testing::TestWithParam<Case> {};

TEST_P(MultiPolygonWire, Returns) {
  const absl::StatusOr<MultiPolygon> back = FromProto(Proto(GetParam().polygons));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(*back, GetParam().polygons);
}

INSTANTIATE_TEST_SUITE_P(
    Geometry, MultiPolygonWire,
    testing::Values(
        Case{"Empty", {}}, Case{"OneRing", MakePolygonsOrDie("(0 0, 10 0, 10 10)")},
        Case{"TwoIslands", MakePolygonsOrDie("(0 0, 10 0, 10 10) ; (20 0, 30 0, 30 10)")},
        Case{"HoleInIsland", MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9) (1 1, 2 1, 2 2)")},
        Case{"IslandInHole", MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9) (1 1, 8 1, 8 8, 1 8) ; "
                                               "(3 3, 4 3, 4 4)")},
        Case{"TwoIslandsTheSecondWithTwoHoles",
             MakePolygonsOrDie("(20 0, 30 0, 30 10) ; "
                               "(0 0, 9 0, 9 9, 0 9) (1 1, 2 1, 2 2) (5 5, 6 5, 6 6)")},
        Case{"MaxCoordinates",
             {{{{kLeast, kLeast}, {kMost, kLeast}, {kMost, kMost}, {kLeast, kMost}}, {}}}}),
    [](const auto& info) { return info.param.name; });

// The structure of the message prevents that two islands are received as one island with a hole.
TEST(GeometryWire, SaysWhichRingsMakeAnIsland) {
  const v1::MultiPolygon proto =
      Proto(MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9) (1 1, 2 1, 2 2) ; (20 0, 30 0, 30 10)"));
  EXPECT_THAT(proto.ring_sizes(), testing::ElementsAre(4, 3, 3));
  EXPECT_THAT(proto.rings_per_island(), testing::ElementsAre(2, 1));
  EXPECT_EQ(proto.xy_nm_size(), 20);
  EXPECT_EQ(proto.xy_nm(2), 9 * kNmPerMm);
  EXPECT_EQ(proto.xy_nm(3), 0);
}

class OutOfRange : public testing::TestWithParam<Point> {};

TEST_P(OutOfRange, IsRefusedWithTheNumbers) {
  const auto expect_refused = [](const absl::Status& status) {
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
    EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfRange) << status;
    EXPECT_TRUE(DetailOf(status).metadata.contains("got")) << status;
  };
  v1::Point point;
  expect_refused(ToProto(GetParam(), &point));
  google::protobuf::RepeatedField<int32_t> xy_nm;
  expect_refused(PackPoints(std::vector<Point>{{0, 0}, GetParam(), {1, 1}}, &xy_nm));
  v1::MultiPolygon polygon;
  expect_refused(ToProto(MultiPolygon{{{{0, 0}, {1, 0}, GetParam()}, {}}}, &polygon));
  v1::MultiPolygon hole;
  expect_refused(
      ToProto(MultiPolygon{{{{0, 0}, {1, 0}, {0, 1}}, {{{0, 0}, {1, 0}, GetParam()}}}}, &hole));
}

INSTANTIATE_TEST_SUITE_P(Geometry, OutOfRange,
                         testing::Values(Point{kMost + 1, 0}, Point{0, kMost + 1},
                                         Point{kLeast - 1, 0}, Point{0, kLeast - 1},
                                         Point{INT64_MAX, 0}, Point{0, INT64_MIN}));

struct Refused {
  std::string name;
  std::function<void(v1::MultiPolygon&)> spoil;
  std::string field;
};

class MultiPolygonWireRefuses : public testing::TestWithParam<Refused> {};

TEST_P(MultiPolygonWireRefuses, NamingTheField) {
  v1::MultiPolygon proto = Proto(MakePolygonsOrDie("(0 0, 9 0, 9 9) (1 1, 2 1, 2 2)"));
  GetParam().spoil(proto);
  const absl::Status status = FromProto(proto).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed) << status;
  EXPECT_EQ(DetailOf(status).metadata["field"], GetParam().field) << status;
}

INSTANTIATE_TEST_SUITE_P(
    Geometry, MultiPolygonWireRefuses,
    testing::Values(
        Refused{"OddCoordinates", [](auto& p) { p.add_xy_nm(1); }, "xy_nm"},
        Refused{"TooFewPoints", [](auto& p) { p.mutable_xy_nm()->Truncate(10); }, "ring_sizes"},
        Refused{"TooManyPoints", [](auto& p) { p.add_xy_nm(1), p.add_xy_nm(1); }, "ring_sizes"},
        Refused{"HugeRing", [](auto& p) { p.set_ring_sizes(0, 0xffffffff); }, "ring_sizes"},
        Refused{"SizesThatWrapAround",
                [](auto& p) { p.add_ring_sizes(0xffffffff), p.add_ring_sizes(1); }, "ring_sizes"},
        Refused{"RingOfTwoPoints", [](auto& p) { p.set_ring_sizes(0, 2), p.set_ring_sizes(1, 4); },
                "ring_sizes"},
        Refused{"RingsLeftOver", [](auto& p) { p.set_rings_per_island(0, 1); }, "rings_per_island"},
        Refused{"TooFewRings", [](auto& p) { p.set_rings_per_island(0, 3); }, "rings_per_island"},
        Refused{"IslandWithoutRings", [](auto& p) { p.add_rings_per_island(0); },
                "rings_per_island"}),
    [](const auto& info) { return info.param.name; });

TEST(GeometryWire, RefusesMorePointsThanALayerMayHave) {
  v1::MultiPolygon proto;
  proto.mutable_xy_nm()->Resize(2 * 5'000'001, 0);
  const absl::Status status = FromProto(proto).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge) << status;
  EXPECT_EQ(DetailOf(status).metadata["limit"], "5000000");
  EXPECT_EQ(DetailOf(status).metadata["got"], "5000001");
}

TEST(GeometryWire, OpenLinesReturn) {
  for (const Polyline& line : {Polyline{}, Polyline{{1, -2}, {3, -4}, {kMost, kLeast}}}) {
    google::protobuf::RepeatedField<int32_t> xy_nm;
    ASSERT_TRUE(PackPoints(line, &xy_nm).ok());
    const auto back = UnpackPoints(xy_nm, "xy_nm");
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(*back, line);
  }
}

}  // namespace
}  // namespace slicefarm::geometry_wire_test
