#include "processes/mill/model/check_milling.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "common/base/error.h"

namespace slicefarm::check_milling_test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct OptionCase {
  const char* setting;
  std::function<void(MillingOptions&)> spoil;
};

TEST(CheckMillingOptions, NamesTheSettingThatCannotBe) {
  EXPECT_TRUE(CheckMillingOptions(MillingOptions()).ok());
  for (const OptionCase& c : {
           OptionCase{"stepdown", [](auto& o) { o.stepdown_mm = 0; }},
           OptionCase{"stepover", [](auto& o) { o.stepover_share = 0.6; }},
           OptionCase{"allowance", [](auto& o) { o.allowance_mm = -0.1; }},
           OptionCase{"minimum_width", [](auto& o) { o.minimum_width_mm = kNaN; }},
           OptionCase{"finish_stepdown", [](auto& o) { o.finish_stepdown_mm = kNaN; }},
           OptionCase{"finish_stepover", [](auto& o) { o.finish_stepover_mm = 5; }},
           OptionCase{"rest_angle", [](auto& o) { o.rest_angle_deg = 90; }},
           OptionCase{"sampling", [](auto& o) { o.sampling_mm = 0; }},
           OptionCase{"tolerance", [](auto& o) { o.tolerance_mm = 0; }},
           OptionCase{"stock_margin", [](auto& o) { o.stock_margin_mm = -1; }},
           OptionCase{"bottom", [](auto& o) { o.bottom_mm = kNaN; }},
           OptionCase{"ramp_angle", [](auto& o) { o.machining.ramp_angle_deg = 0; }},
           OptionCase{"helix_radius", [](auto& o) { o.machining.helix_radius_mm = 3; }},
           OptionCase{"lead_in_radius", [](auto& o) { o.machining.lead_in_radius_mm = -1; }},
           OptionCase{"safe_height", [](auto& o) { o.machining.safe_height_mm = 0; }},
           OptionCase{"clearance", [](auto& o) { o.machining.clearance_mm = 6; }},
           OptionCase{"feed", [](auto& o) { o.machining.feed_mm_min = 0; }},
           OptionCase{"plunge_feed", [](auto& o) { o.machining.plunge_feed_mm_min = -5; }},
           OptionCase{"rapid", [](auto& o) { o.machining.rapid_mm_min = 0; }},
           OptionCase{"spindle", [](auto& o) { o.machining.spindle_rpm = 0; }},
           OptionCase{"tool_number", [](auto& o) { o.machining.tool_number = -1; }},
           OptionCase{"tool_length", [](auto& o) { o.machining.tool_length_mm = -1; }},
       }) {
    MillingOptions options = MillingOptions();
    c.spoil(options);
    const ErrorDetail detail = DetailOf(CheckMillingOptions(options));
    EXPECT_EQ(detail.reason, Reason::kSettingOutOfRange) << c.setting;
    EXPECT_EQ(detail.metadata.at("setting"), c.setting);
  }
}

}  // namespace
}  // namespace slicefarm::check_milling_test
