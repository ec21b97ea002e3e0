#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "common/base/error.h"
#include "common/wire/options/settings_wire.h"
#include "common/wire/support/round_trip_test.h"
#include "google/protobuf/text_format.h"
#include "google/protobuf/util/message_differencer.h"

namespace slicefarm::slicing_options_wire_test {
namespace {

using google::protobuf::TextFormat;
using google::protobuf::util::MessageDifferencer;

// The bindings name every member: a new one does not compile until it is sent here, and so on the
// wire.
ObjectSlicingOptions DistinctObjectSlicing() {
  ObjectSlicingOptions options;
  auto& [layer_height, fill_rule, close_holes, closing_radius, xy_compensation, hole_compensation,
         on_bed, elephant_foot, elephant_foot_min_width, lift, hollow_from, counterbores,
         adaptive, height_profile] = options;
  auto& [adapts, cusp, min, max, ratio] = adaptive;
  layer_height = 101;
  fill_rule = FillRule::kPositive;
  close_holes = true;
  closing_radius = 104;
  xy_compensation = -106;
  hole_compensation = -107;
  elephant_foot = -108;
  elephant_foot_min_width = 110;
  on_bed = true;
  lift = 602;
  hollow_from = 610;
  counterbores = CounterboreBridging::kSacrificial;
  adapts = true;
  cusp = 603;
  min = 604;
  max = 605;
  ratio = 2.25;
  height_profile = {{606, 607}, {608, 609}};
  return options;
}

SlicingOptions DistinctSlicing() {
  SlicingOptions options;
  auto& [first_layer_height, max_gap, resolution, bed, excluded, max_print_height, thumbnails, objects,
         part_distance, clearance_radius] = options;
  first_layer_height = 102;
  max_gap = 105;
  resolution = 109;
  bed = {{0, 1}, {2, 3}, {4, 2'100'000'000}};
  excluded = {{{5, 6}, {7, 6}, {7, 8}}, {{9, 9}, {10, 9}, {9, 10}}};
  max_print_height = 111;
  thumbnails = {{12, 13, PictureFormat::kQoi}};
  part_distance = 112;
  clearance_radius = 113;
  objects = {DistinctObjectSlicing(), {}};
  return options;
}

constexpr char kDistinctSlicing[] = R"pb(
  first_layer_height_nm: 102
  max_gap_nm: 105
  resolution_nm: 109
  bed_xy_nm: [ 0, 1, 2, 3, 4, 2100000000 ]
  excluded {
    xy_nm: [ 5, 6, 7, 6, 7, 8, 9, 9, 10, 9, 9, 10 ]
    ring_sizes: [ 3, 3 ]
    rings_per_island: [ 1, 1 ]
  }
  max_print_height_nm: 111
  part_distance_nm: 112
  clearance_radius_nm: 113
  thumbnails { width_px: 12 height_px: 13 format: PICTURE_FORMAT_QOI }
  objects {
    layer_height_nm: 101
    fill_rule: FILL_RULE_POSITIVE
    close_holes: true
    closing_radius_nm: 104
    xy_compensation_nm: -106
    hole_compensation_nm: -107
    elephant_foot_nm: -108
    elephant_foot_min_width_nm: 110
    on_bed: true
    lift_nm: 602
    adaptive { on: true cusp_nm: 603 min_nm: 604 max_nm: 605 max_ratio: 2.25 }
    height_profile_nm: [ 606, 607, 608, 609 ]
    hollow_from: 610
    counterbores: COUNTERBORE_BRIDGING_SACRIFICIAL
  }
)pb";

TEST(SlicingOptionsWire, EachMemberIsTheFieldOfItsName) {
  v1::SlicingOptions want;
  ASSERT_TRUE(TextFormat::ParseFromString(kDistinctSlicing, &want));
  auto proto = ProtoOf<v1::SlicingOptions>(DistinctSlicing());
  proto.mutable_objects()->RemoveLast();
  MessageDifferencer differencer;
  std::string difference;
  differencer.ReportDifferencesToString(&difference);
  EXPECT_TRUE(differencer.Compare(want, proto)) << difference;
}

TEST(SlicingOptionsWire, Returns) {
  for (const SlicingOptions& options : {SlicingOptions{}, DistinctSlicing()})
    ExpectReturns<v1::SlicingOptions>(options);
  ExpectEveryChangeReturns<v1::SlicingOptions, SlicingOptions>(
      ProtoOf<v1::SlicingOptions>(SlicingOptions{}), {"max_ratio"});
}

TEST(SlicingOptionsWire, ABedThatLimitsNothingReturns) {
  SlicingOptions options;
  options.bed.clear();
  ExpectReturns<v1::SlicingOptions>(options);
}

struct RefusedSlicing {
  std::string name;
  std::function<void(v1::SlicingOptions&)> spoil;
  std::string field;
};

class SlicingWireRefuses : public testing::TestWithParam<RefusedSlicing> {};

TEST_P(SlicingWireRefuses, NamingTheField) {
  auto proto = ProtoOf<v1::SlicingOptions>(SlicingOptions{});
  GetParam().spoil(proto);
  ExpectMalformed(FromProto(proto).status(), GetParam().field);
}

INSTANTIATE_TEST_SUITE_P(
    Settings, SlicingWireRefuses,
    testing::Values(
        RefusedSlicing{"NoFillRule", [](auto& p) { p.mutable_objects(0)->clear_fill_rule(); },
                       "objects[0].fill_rule"},
        RefusedSlicing{"NegativeDistance", [](auto& p) { p.set_part_distance_nm(-1); },
                       "part_distance_nm"},
        RefusedSlicing{"LiftBelowTheBed",
                       [](auto& p) { p.mutable_objects(0)->set_lift_nm(-1); },
                       "objects[0].lift_nm"},
        RefusedSlicing{"HeightsUpsideDown",
                       [](auto& p) { p.mutable_objects(0)->mutable_adaptive()->set_max_nm(1); },
                       "objects[0].adaptive.max_nm"},
        RefusedSlicing{"NoRatio",
                       [](auto& p) { p.mutable_objects(0)->mutable_adaptive()->set_max_ratio(0.5); },
                       "objects[0].adaptive.max_ratio"},
        RefusedSlicing{"AHeightWithoutZ",
                       [](auto& p) { p.mutable_objects(0)->add_height_profile_nm(1); },
                       "objects[0].height_profile_nm"},
        RefusedSlicing{"AProfileThatFalls",
                       [](auto& p) {
                         for (const Coord at : {9, 1, 8, 1})
                           p.mutable_objects(0)->add_height_profile_nm(at);
                       },
                       "objects[0].height_profile_nm"},
        RefusedSlicing{"NoSlicedObjects", [](auto& p) { p.clear_objects(); }, "objects"},
        RefusedSlicing{"NoLayerHeight",
                       [](auto& p) { p.mutable_objects(0)->set_layer_height_nm(0); },
                       "objects[0].layer_height_nm"},
        RefusedSlicing{"NoFirstLayerHeight", [](auto& p) { p.set_first_layer_height_nm(0); },
                       "first_layer_height_nm"},
        RefusedSlicing{"BedOfTwoPoints", [](auto& p) { p.mutable_bed_xy_nm()->Truncate(4); },
                       "bed_xy_nm"},
        RefusedSlicing{"BedOfOddCoordinates", [](auto& p) { p.add_bed_xy_nm(1); }, "bed_xy_nm"},
        RefusedSlicing{"HugeThumbnail",
                       [](auto& p) { p.mutable_thumbnails(0)->set_width_px(1 << 20); },
                       "thumbnails"}),
    [](const auto& info) { return info.param.name; });

TEST(SlicingOptionsWire, RefusesMoreSlicedObjectsThanAJobMayHave) {
  SlicingOptions options;
  options.objects.resize(1'001);
  const absl::Status status = FromProto(ProtoOf<v1::SlicingOptions>(options)).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge) << status;
}

TEST(SlicingOptionsWire, RefusesABedBeyondTheWire) {
  SlicingOptions options;
  options.bed[1].x = int64_t{1} << 31;
  v1::SlicingOptions proto;
  const absl::Status status = ToProto(options, &proto);
  EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfRange);
  EXPECT_EQ(DetailOf(status).metadata["field"], "bed_xy_nm");
}

}  // namespace
}  // namespace slicefarm::slicing_options_wire_test
