#include "common/wire/layers/fill_stats_wire.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::fill_stats_wire_test {
namespace {

// The structured binding names every member. A new member does not compile until it is added here,
// and thereby to the message.
FillStats Distinct() {
  FillStats use;
  auto& [settings, feature, pattern, area, volume, asked, plastic, paths, length, longest] = use;
  settings = 1;
  feature = Feature::kSolidInfill;
  pattern = FillPattern::kGyroid;
  area = 2;
  volume = 3;
  asked = 4;
  plastic = 5;
  paths = 6;
  length = 7;
  longest = 8;
  return use;
}

TEST(FillStatsWire, Returns) {
  ExpectReturns<v1::FillStats>(Distinct());
  ExpectReturns<v1::FillStats>(FillStats{});
  ExpectEveryChangeReturns<v1::FillStats, FillStats>(ProtoOf<v1::FillStats>(Distinct()));
}

TEST(FillStatsWire, EachMemberIsTheFieldOfItsName) {
  const auto proto = ProtoOf<v1::FillStats>(Distinct());
  EXPECT_EQ(proto.settings(), 1);
  EXPECT_EQ(proto.feature(), v1::FEATURE_SOLID_INFILL);
  EXPECT_EQ(proto.pattern(), static_cast<int>(FillPattern::kGyroid) + 1);
  EXPECT_EQ(proto.area_mm2(), 2);
  EXPECT_EQ(proto.volume_mm3(), 3);
  EXPECT_EQ(proto.asked_mm3(), 4);
  EXPECT_EQ(proto.plastic_mm3(), 5);
  EXPECT_EQ(proto.paths(), 6);
  EXPECT_EQ(proto.length_mm(), 7);
  EXPECT_EQ(proto.longest_mm(), 8);
}

TEST(FillStatsWire, RefusesWhatIsNoTotal) {
  constexpr char kAmounts[] = "area_mm2, volume_mm3, asked_mm3, plastic_mm3, length_mm, longest_mm";
  const std::vector<std::pair<std::string, std::function<void(v1::FillStats&)>>> spoils = {
      {"settings", [](auto& u) { u.set_settings(-1); }},
      {"paths", [](auto& u) { u.set_paths(-1); }},
      {"feature", [](auto& u) { u.clear_feature(); }},
      {"pattern", [](auto& u) { u.set_pattern(1000); }},
      {kAmounts, [](auto& u) { u.set_area_mm2(-1); }},
      {kAmounts, [](auto& u) { u.set_plastic_mm3(1e308 * 10); }},
  };
  for (const auto& [field, spoil] : spoils) {
    auto proto = ProtoOf<v1::FillStats>(Distinct());
    spoil(proto);
    ExpectMalformed(FromProto(proto).status(), field);
  }
}

}  // namespace
}  // namespace slicefarm::fill_stats_wire_test
