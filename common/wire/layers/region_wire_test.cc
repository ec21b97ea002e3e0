#include "common/wire/layers/region_wire.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "common/geometry/text_format_test.h"
#include "common/model/limits.h"
#include "common/wire/support/round_trip_test.h"

namespace slicefarm::region_wire_test {
namespace {

const MultiPolygon& Outlines() {
  static const MultiPolygon outlines =
      MakePolygonsOrDie("(20 0, 30 0, 30 10) ; (0 0, 9 0, 9 9, 0 9) (1 1, 2 1, 2 2)");
  return outlines;
}

// The structured bindings name every member. A new member does not compile until it is added here,
// and thereby to the message.
template <typename Model>
Model Distinct() {
  Model model;
  auto& [role, settings, tool, area] = model;
  role = Role::kBrim;
  settings = 1;
  tool = 2;
  area = Outlines();
  return model;
}

TEST(RegionWire, Returns) {
  ExpectReturns<v1::Region>(Distinct<Region>());
  ExpectReturns<v1::FillArea>(Distinct<FillArea>());
  ExpectReturns<v1::Region>(Region{});
  ExpectReturns<v1::FillArea>(FillArea{});
}

TEST(RegionWire, EveryFieldChangedAloneReturns) {
  ExpectEveryChangeReturns<v1::Region, Region>(ProtoOf<v1::Region>(Distinct<Region>()),
                                               {"ring_sizes", "rings_per_island"});
  ExpectEveryChangeReturns<v1::FillArea, FillArea>(ProtoOf<v1::FillArea>(Distinct<FillArea>()),
                                                   {"ring_sizes", "rings_per_island"});
}

TEST(RegionWire, EachMemberIsTheFieldOfItsName) {
  const auto region = ProtoOf<v1::Region>(Distinct<Region>());
  EXPECT_EQ(region.role(), v1::ROLE_BRIM);
  EXPECT_EQ(region.settings(), 1);
  EXPECT_EQ(region.tool(), 2);
  const auto area = ProtoOf<v1::FillArea>(Distinct<FillArea>());
  EXPECT_EQ(area.role(), v1::ROLE_BRIM);
  EXPECT_EQ(area.settings(), 1);
  EXPECT_EQ(area.tool(), 2);
}

TEST(RegionWire, EveryRoleReturns) {
  for (int i = 0; i < kRoleCount; ++i) {
    Region region = Distinct<Region>();
    region.role = static_cast<Role>(i);
    ExpectReturns<v1::Region>(region);
  }
}

template <typename Proto, typename Model>
void ExpectRefusals() {
  const std::vector<std::pair<std::string, std::function<void(Proto&)>>> spoils = {
      {"role", [](Proto& p) { p.clear_role(); }},
      {"role", [](Proto& p) { p.set_role(v1::Role(99)); }},
      {"role", [](Proto& p) { p.set_role(v1::Role(-1)); }},
      {"settings", [](Proto& p) { p.set_settings(-1); }},
      {"tool", [](Proto& p) { p.set_tool(INT32_MIN); }},
  };
  for (const auto& [field, spoil] : spoils) {
    auto proto = ProtoOf<Proto>(Distinct<Model>());
    spoil(proto);
    ExpectMalformed(FromProto(proto).status(), field);
  }
}

TEST(RegionWire, RefusesNumbersThatNoJobHas) {
  ExpectRefusals<v1::Region, Region>();
  ExpectRefusals<v1::FillArea, FillArea>();
}

TEST(RegionWire, RefusesOutlinesThatDoNotAddUp) {
  auto region = ProtoOf<v1::Region>(Distinct<Region>());
  region.mutable_outlines()->add_xy_nm(1);
  ExpectMalformed(FromProto(region).status(), "outlines.xy_nm");
  auto area = ProtoOf<v1::FillArea>(Distinct<FillArea>());
  area.mutable_area()->set_rings_per_island(0, 0);
  ExpectMalformed(FromProto(area).status(), "area.rings_per_island");
}

TEST(RegionWire, RefusesOutlinesBeyondTheWire) {
  Region region = Distinct<Region>();
  region.outlines[0].outer[0].x = Coord{1} << 31;
  v1::Region proto;
  EXPECT_EQ(DetailOf(ToProto(region, &proto)).reason, Reason::kOutOfRange);
}

TEST(CheckSection, TheBoundsBelong) {
  EXPECT_TRUE(CheckSection(0, 1).ok());
  EXPECT_TRUE(CheckSection(limits::kMaxLayers - 1, limits::kMaxCoord).ok());
}

TEST(CheckSection, NamesTheField) {
  for (const int32_t layer : {INT32_MIN, -1, 20'000, INT32_MAX})
    ExpectMalformed(CheckSection(layer, 1), "layer");
  for (const int64_t height_nm :
       {INT64_MIN, int64_t{-1}, int64_t{0}, int64_t{limits::kMaxCoord + 1}, INT64_MAX})
    ExpectMalformed(CheckSection(0, height_nm), "height_nm");
}

}  // namespace
}  // namespace slicefarm::region_wire_test
