#include "services/motion/algo/input_check.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "common/base/error.h"

namespace slicefarm::motion {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(CheckOptions, DefaultsAreGood) { EXPECT_TRUE(CheckOptions(MotionOptions{}).ok()); }

struct OptionCase {
  std::string setting;
  std::function<void(MotionOptions&)> spoil;
};

TEST(CheckOptions, NamesTheSetting) {
  const std::vector<OptionCase> cases = {
      {"filament_diameter", [](auto& o) { o.filament_diameter_mm = 0; }},
      {"extrusion_multiplier", [](auto& o) { o.extrusion_multiplier = kNan; }},
      {"retract_length", [](auto& o) { o.retraction.length_mm = -1; }},
      {"retract_lift", [](auto& o) { o.retraction.lift_mm = 1e300; }},
      // Finite, but more than 32 bits hold.
      {"filament_diameter", [](auto& o) { o.filament_diameter_mm = 1.1e4; }},
      {"retract_length", [](auto& o) { o.retraction.length_mm = 1e5; }},
      {"retract_lift", [](auto& o) { o.retraction.lift_mm = 1e8; }},
      {"retract_before_travel", [](auto& o) { o.retraction.min_travel_mm = 1.1e4; }},
      {"retract_restart_extra", [](auto& o) { o.retraction.restart_extra_mm = -1e5; }},
      {"z_offset", [](auto& o) { o.z_offset_mm = -1e8; }},
      {"z_offset", [](auto& o) { o.z_offset_mm = kNan; }},
      {"slowdown_below_layer_time", [](auto& o) { o.cooling.slowdown_below_layer_time_s = kNan; }},
  };
  for (const OptionCase& c : cases) {
    MotionOptions options;
    c.spoil(options);
    const ErrorDetail detail = DetailOf(CheckOptions(options));
    EXPECT_EQ(detail.reason, Reason::kSettingOutOfRange) << c.setting;
    EXPECT_EQ(detail.metadata.at("setting"), c.setting);
  }
}

OrderedLayer Layer() {
  OrderedLayer layer;
  layer.frame = {4, 1'000'000, 200'000};
  Path path;
  path.points = {{0, 0}, {10, 0}, {10, 10}};
  path.widths_nm = {450'000};
  layer.paths = {path};
  return layer;
}

TEST(CheckLayer, GoodAndEmptyLayers) {
  EXPECT_TRUE(CheckLayer(Layer()).ok());
  EXPECT_TRUE(CheckLayer({}).ok());
}

TEST(CheckLayer, NamesTheLayer) {
  const std::vector<std::function<void(OrderedLayer&)>> spoils = {
      [](auto& l) { l.frame.print_z_nm = INT64_MAX; },
      [](auto& l) { l.frame.height_nm = -1; },
      [](auto& l) { l.paths[0].points.resize(1); },
      [](auto& l) { l.paths[0].widths_nm.clear(); },
      [](auto& l) {
        l.paths[0].widths_nm = {1, 2};
      },
      [](auto& l) { l.paths[0].widths_nm = {-1}; },
      [](auto& l) { l.paths[0].points[1].x = INT64_MIN + 1; },
      [](auto& l) { l.paths[0].flow = kNan; },
      [](auto& l) { l.paths[0].height_nm = -5; },
      [](auto& l) { l.paths[0].feature = static_cast<Feature>(200); },
      [](auto& l) { l.paths[0].speed_mm_s = kNan; },
  };
  for (size_t i = 0; i < spoils.size(); ++i) {
    OrderedLayer layer = Layer();
    spoils[i](layer);
    const ErrorDetail detail = DetailOf(CheckLayer(layer));
    EXPECT_EQ(detail.reason, Reason::kRequestMalformed) << i;
    EXPECT_EQ(detail.metadata.at("layer"), "4");
  }
}

}  // namespace
}  // namespace slicefarm::motion
