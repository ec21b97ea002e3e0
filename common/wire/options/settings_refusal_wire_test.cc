#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/options/settings_wire.h"

namespace slicefarm::settings_refusal_wire_test {
namespace {

struct Refused {
  std::string name;
  std::function<void(v1::FdmSettings&)> spoil;
  std::string field;
  Reason reason = Reason::kRequestMalformed;
};

class SettingsWireRefuses : public testing::TestWithParam<Refused> {};

TEST_P(SettingsWireRefuses, NamingTheField) {
  v1::FdmSettings proto;
  ASSERT_TRUE(ToProto(FdmSettings{}, &proto).ok());
  GetParam().spoil(proto);
  const absl::Status status = FromProto(proto).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << status;
  EXPECT_EQ(DetailOf(status).reason, GetParam().reason) << status;
  EXPECT_EQ(DetailOf(status).metadata["field"], GetParam().field) << status;
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

INSTANTIATE_TEST_SUITE_P(
    Settings, SettingsWireRefuses,
    testing::Values(
        Refused{"NoMotion", [](auto& p) { p.clear_motion(); }, "motion.flavor"},
        Refused{"NoLimits", [](auto& p) { p.mutable_motion()->clear_limits(); }, "motion.limits"},
        Refused{"UnknownSeam",
                [](auto& p) {
                  p.mutable_planning()->mutable_objects(0)->set_seam(v1::SeamPosition(77));
                },
                "planning.objects[0].seam"},
        Refused{"NoSeam", [](auto& p) { p.mutable_planning()->mutable_objects(0)->clear_seam(); },
                "planning.objects[0].seam"},
        Refused{"NoPlanning", [](auto& p) { p.clear_planning(); }, "planning.objects"},
        Refused{"NoPlannedObjects", [](auto& p) { p.mutable_planning()->clear_objects(); },
                "planning.objects"},
        Refused{
            "NegativeClearance",
            [](auto& p) { p.mutable_planning()->mutable_sequence()->set_clearance_height_nm(-1); },
            "planning.clearance_height_nm"},
        Refused{"NegativePrintHeight",
                [](auto& p) { p.mutable_motion()->set_max_print_height_nm(-1); },
                "motion.max_print_height_nm"},
        Refused{"NegativeMotionResolution",
                [](auto& p) { p.mutable_motion()->set_resolution_nm(-1); }, "motion.resolution_nm"},
        Refused{"NoSkirt", [](auto& p) { p.mutable_planning()->clear_skirt(); }, "planning.skirt"},
        Refused{"TooManySkirts",
                [](auto& p) { p.mutable_planning()->mutable_skirt()->set_loops(501); },
                "planning.skirt.loops"},
        Refused{"SkirtWithoutWidth",
                [](auto& p) { p.mutable_planning()->mutable_skirt()->set_width_nm(0); },
                "planning.skirt.width_nm"},
        Refused{"NoFilament",
                [](auto& p) { p.mutable_planning()->mutable_skirt()->set_filament_area_mm2(0); },
                "planning.skirt.filament_area_mm2"},
        Refused{"NegativeSkirtLength",
                [](auto& p) { p.mutable_planning()->mutable_skirt()->set_min_length_nm(-1); },
                "planning.skirt.min_length_nm"},
        Refused{"NegativeBrim",
                [](auto& p) {
                  p.mutable_planning()->mutable_objects(0)->mutable_brim()->set_width_nm(-1);
                },
                "planning.objects[0].brim.width_nm"},
        Refused{"EarAngle",
                [](auto& p) {
                  p.mutable_planning()->mutable_objects(0)->mutable_brim()->set_ear_max_angle_rad(
                      7);
                },
                "planning.objects[0].brim.ear_max_angle_rad"},
        Refused{"BrimRow",
                [](auto& p) { p.mutable_planning()->mutable_objects(0)->set_brim_settings(-1); },
                "planning.objects[0].brim_settings"},
        Refused{"NoBeading", [](auto& p) { p.clear_beading(); }, "beading"},
        Refused{"NoInfill", [](auto& p) { p.clear_infill(); }, "settings"},
        Refused{"NoWallOrder", [](auto& p) { p.mutable_ordering()->clear_walls(); },
                "ordering.walls"},
        Refused{"NoTravel", [](auto& p) { p.mutable_ordering()->clear_travel(); },
                "ordering.travel"},
        Refused{"NegativeDetour",
                [](auto& p) { p.mutable_ordering()->mutable_travel()->set_max_detour_mm(-1); },
                "ordering.travel"},
        Refused{"NoSpeeds", [](auto& p) { p.mutable_motion()->clear_speeds(); }, "motion.speeds"},
        Refused{"NoArcFitting", [](auto& p) { p.mutable_motion()->clear_arc_fitting(); },
                "motion.arc_fitting"},
        Refused{"NoLabels", [](auto& p) { p.mutable_motion()->clear_labels(); }, "motion.labels"},
        Refused{"UnknownLabels",
                [](auto& p) { p.mutable_motion()->set_labels(v1::ObjectLabels(4)); },
                "motion.labels"},
        Refused{"NanDensity", [](auto& p) { p.mutable_infill(0)->set_density(kNan); },
                "infill[0].density"},
        Refused{"DensityAboveOne", [](auto& p) { p.mutable_infill(0)->set_density(1.01); },
                "infill[0].density"},
        Refused{
            "InfiniteJerk",
            [](auto& p) { p.mutable_motion()->mutable_limits()->set_max_jerk_mm_s(2, kInfinity); },
            "motion.limits.max_jerk_mm_s"},
        Refused{"FiveAxes",
                [](auto& p) { p.mutable_motion()->mutable_limits()->add_max_jerk_mm_s(1); },
                "motion.limits.max_jerk_mm_s"},
        Refused{"NineSpeeds",
                [](auto& p) {
                  p.mutable_motion()->mutable_speeds(0)->mutable_speed_mm_s()->RemoveLast();
                },
                "motion.speeds.speed_mm_s"},
        Refused{"ScarfBelowItsLayer",
                [](auto& p) {
                  p.mutable_motion()->mutable_speeds(0)->mutable_scarf()->set_start_height_ratio(
                      -1);
                },
                "motion.speeds.scarf.start_height_ratio"},
        Refused{"ScarfLength",
                [](auto& p) {
                  p.mutable_motion()->mutable_speeds(0)->mutable_scarf()->set_length_mm(-1);
                },
                "motion.speeds.scarf.length_mm"},
        Refused{"ScarfOfEndlessPieces",
                [](auto& p) {
                  p.mutable_motion()->mutable_speeds(0)->mutable_scarf()->set_max_segment_mm(0);
                },
                "motion.speeds.scarf.max_segment_mm"},
        Refused{"NegativeSpeed",
                [](auto& p) { p.mutable_motion()->mutable_speeds(0)->set_speed_mm_s(3, -1); },
                "motion.speeds.speed_mm_s"},
        Refused{"NegativeFan",
                [](auto& p) {
                  p.mutable_motion()->mutable_cooling()->set_min_fan_percent(
                      std::numeric_limits<int32_t>::min());
                },
                "motion.cooling"},
        Refused{"NegativePerimeters", [](auto& p) { p.mutable_beading(0)->set_perimeters(-1); },
                "beading[0].perimeters"},
        Refused{"NoWidth", [](auto& p) { p.mutable_beading(0)->set_inner_width_nm(0); },
                "beading[0].inner_width_nm"},
        Refused{"NegativeSpare",
                [](auto& p) { p.mutable_infill(0)->mutable_top_spare()->set_layers(-1); },
                "infill[0].top_spare.layers"},
        Refused{"LongStartGcode",
                [](auto& p) {
                  p.mutable_motion()->set_start_gcode(
                      std::string(limits::kMaxSettingBytes + 1, 'G'));
                },
                "motion", Reason::kRequestTooLarge}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::settings_refusal_wire_test
