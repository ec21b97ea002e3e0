#include "services/motion/algo/input_check.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "common/base/error.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::motion::input_check_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(CheckOptions, DefaultsAreGood) { EXPECT_TRUE(CheckOptions(MotionOptions{}).ok()); }

struct OptionCase {
  std::string setting;
  std::function<void(MotionOptions&)> spoil;
};

TEST(CheckOptions, NamesTheSetting) {
  const std::vector<OptionCase> cases = {
      {"filament_diameter", [](auto& o) { o.tool().filament_diameter_mm = 0; }},
      {"extrusion_multiplier", [](auto& o) { o.tool().extrusion_multiplier = kNan; }},
      {"retract_length", [](auto& o) { o.tool().retraction.length_mm = -1; }},
      {"retract_lift", [](auto& o) { o.tool().retraction.lift_mm = 1e300; }},
      // The value is finite, but too large for 32 bits.
      {"filament_diameter", [](auto& o) { o.tool().filament_diameter_mm = 1.1e4; }},
      {"retract_length", [](auto& o) { o.tool().retraction.length_mm = 1e5; }},
      {"retract_lift", [](auto& o) { o.tool().retraction.lift_mm = 1e8; }},
      {"retract_before_travel", [](auto& o) { o.tool().retraction.min_travel_mm = 1.1e4; }},
      {"retract_restart_extra", [](auto& o) { o.tool().retraction.restart_extra_mm = -1e5; }},
      {"retract_lift_above", [](auto& o) { o.tool().retraction.lift_above_mm = -1; }},
      {"retract_lift_below", [](auto& o) { o.tool().retraction.lift_below_mm = 1e8; }},
      {"retract_before_wipe", [](auto& o) { o.tool().retraction.before_wipe = 1.1; }},
      {"z_offset", [](auto& o) { o.z_offset_mm = -1e8; }},
      {"z_offset", [](auto& o) { o.z_offset_mm = kNan; }},
      {"slowdown_below_layer_time",
       [](auto& o) { o.tool().cooling.slowdown_below_layer_time_s = kNan; }},
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
  layer.blocks = {{0, 4, 200'000, {path}}};
  layer.visits = {{0, 0, 0, {}}, {0, 1, 1, {FromMm(30), -1'000}}};
  return layer;
}

Path& PathOf(OrderedLayer& layer) { return layer.blocks[0].paths[0]; }

TEST(CheckLayer, GoodAndEmptyLayers) {
  EXPECT_TRUE(CheckLayer(Layer(), {}).ok());
  EXPECT_TRUE(CheckLayer({}, {}).ok());
}

TEST(CheckLayer, NamesTheLayer) {
  const std::vector<std::function<void(OrderedLayer&)>> spoils = {
      [](auto& l) { l.frame.print_z_nm = INT64_MAX; },
      [](auto& l) { l.frame.height_nm = -1; },
      [](auto& l) { PathOf(l).points.resize(1); },
      [](auto& l) { PathOf(l).widths_nm.clear(); },
      [](auto& l) {
        PathOf(l).widths_nm = {1, 2};
      },
      [](auto& l) { PathOf(l).widths_nm = {-1}; },
      [](auto& l) { PathOf(l).points[1].x = INT64_MIN + 1; },
      [](auto& l) { PathOf(l).feature = static_cast<Feature>(200); },
      [](auto& l) { PathOf(l).settings = -1; },
      [](auto& l) { PathOf(l).settings = 1; },
      [](auto& l) { PathOf(l).tool = 1; },
      [](auto& l) { l.blocks[0].height_nm = -5; },
      [](auto& l) { l.blocks[0].travels.resize(l.blocks[0].paths.size() + 1); },
      [](auto& l) {
        l.blocks[0].travels.resize(l.blocks[0].paths.size());
        l.blocks[0].travels[0].corners = {{INT64_MAX, 0}};
      },
      [](auto& l) { l.blocks[0].height_nm = INT64_MAX; },
      [](auto& l) { l.blocks[0].paths.clear(); },
      [](auto& l) { l.visits[1].block = -1; },
      [](auto& l) { l.visits[1].block = 1; },
      [](auto& l) { l.visits[1].shift.y = INT64_MIN + 1; },
      [](auto& l) { l.visits[1].shift.x = 1'500; },
      [](auto& l) { l.visits[1].shift.y = -1; },
      [](auto& l) {
        l.visits[1].corners = {{0, INT64_MIN + 1}};
      },
      [](auto& l) { l.visits[0].pass = 2; },
      [](auto& l) { l.visits[0].pass = -1; },
      [](auto& l) { l.begins_ready = true; },  // not allowed: the block has two visits
      [](auto& l) { l.ends_ready = true; },
      [](auto& l) {
        l.blocks[0].exit_travel = {{INT64_MAX, 0}, {}};
      },
      [](auto& l) {
        l.blocks[0].exit_travel = {{}, {true, {{0, INT64_MAX}}}};
      },
  };
  for (size_t i = 0; i < spoils.size(); ++i) {
    OrderedLayer layer = Layer();
    spoils[i](layer);
    const ErrorDetail detail = DetailOf(CheckLayer(layer, {}));
    EXPECT_EQ(detail.reason, Reason::kRequestMalformed) << i;
    EXPECT_EQ(detail.metadata.at("layer"), "4") << i;
  }
}

TEST(CheckLayer, SettingsAreARowOfTheTable) {
  OrderedLayer layer = Layer();
  PathOf(layer).settings = 1;
  MotionOptions options;
  options.speeds.resize(2);
  EXPECT_TRUE(CheckLayer(layer, options).ok());
  PathOf(layer).settings = 2;
  EXPECT_FALSE(CheckLayer(layer, options).ok());
}

}  // namespace
}  // namespace slicefarm::motion::input_check_test
