#include "services/exposure/algo/check_exposure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "common/base/error.h"

namespace slicefarm::exposure {
namespace {

TEST(CheckExposure, DefaultsPass) { EXPECT_TRUE(CheckExposure({}).ok()); }

TEST(CheckExposure, NamesWhatIsOutOfRange) {
  struct Case {
    const char* setting;
    std::function<void(ExposureOptions&)> spoil;
  };
  const Case cases[] = {
      {"hatch_distance_nm", [](ExposureOptions& o) { o.hatch_distance_nm = 0; }},
      {"hatch_angle_deg", [](ExposureOptions& o) { o.hatch_angle_deg = NAN; }},
      {"layer_rotation_deg", [](ExposureOptions& o) { o.layer_rotation_deg = INFINITY; }},
      {"minimum_vector_nm", [](ExposureOptions& o) { o.minimum_vector_nm = -1; }},
      {"stripe_width_nm", [](ExposureOptions& o) { o.stripe_width_nm = 10'000; }},
      {"island_width_nm", [](ExposureOptions& o) { o.island_width_nm = 0; }},
      {"overlap_nm", [](ExposureOptions& o) { o.overlap_nm = 4'000'000; }},
      {"ring_overlap_nm", [](ExposureOptions& o) { o.ring_overlap_nm = 81'000; }},
      {"spot_nm", [](ExposureOptions& o) { o.spot_nm = 0; }},
      {"beam_compensation_nm", [](ExposureOptions& o) { o.beam_compensation_nm = -5; }},
      {"contours", [](ExposureOptions& o) { o.contours = -1; }},
      {"contour_distance_nm", [](ExposureOptions& o) { o.contour_distance_nm = 0; }},
      {"hatch_offset_nm", [](ExposureOptions& o) { o.hatch_offset_nm = -1; }},
      {"upskin_layers", [](ExposureOptions& o) { o.upskin_layers = -1; }},
      {"downskin_layers", [](ExposureOptions& o) { o.downskin_layers = 1001; }},
      {"skin_overlap_nm", [](ExposureOptions& o) { o.skin_overlap_nm = -1; }},
      {"skywriting_nm", [](ExposureOptions& o) { o.skywriting_nm = -1; }},
      {"jump_speed_mm_s", [](ExposureOptions& o) { o.jump.speed_mm_s = 0; }},
      {"jump_delay_us", [](ExposureOptions& o) { o.jump.delay_us = -1; }},
      {"mark_delay_us", [](ExposureOptions& o) { o.jump.mark_delay_us = -1; }},
      {"polygon_delay_us", [](ExposureOptions& o) { o.jump.polygon_delay_us = -1; }},
      {"power_w", [](ExposureOptions& o) { o.styles[2].power_w = -1; }},
      {"speed_mm_s", [](ExposureOptions& o) { o.styles[4].speed_mm_s = 0; }},
      {"focus_mm", [](ExposureOptions& o) { o.styles[0].focus_mm = NAN; }},
      {"frequency_khz", [](ExposureOptions& o) { o.styles[0].frequency_khz = -1; }},
      {"point_distance_nm", [](ExposureOptions& o) { o.styles[1].point_distance_nm = -1; }},
      {"point_time_us", [](ExposureOptions& o) { o.styles[1].point_time_us = -1; }},
      {"point_delay_us", [](ExposureOptions& o) { o.styles[1].point_delay_us = -1; }},
  };
  for (const Case& c : cases) {
    ExposureOptions options;
    c.spoil(options);
    const ErrorDetail detail = DetailOf(CheckExposure(options));
    EXPECT_EQ(detail.reason, Reason::kSettingOutOfRange) << c.setting;
    const auto setting = detail.metadata.find("setting");
    ASSERT_NE(setting, detail.metadata.end()) << c.setting;
    EXPECT_EQ(setting->second, c.setting);
  }
}

}  // namespace
}  // namespace slicefarm::exposure
