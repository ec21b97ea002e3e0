#include "services/motion/algo/print_code.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/model/options/motion_options.h"

namespace slicefarm::motion::print_code_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Returns two passes of two layers, each of 100 mm of filament: 240.528 mm3, 0.298255 g.
ProgramSummary Summary() {
  ProgramSummary summary;
  for (int32_t i = 0; i < 4; ++i) {
    LayerSummary layer;
    layer.frame = {i % 2, (i % 2 + 1) * Coord{200'000}, 200'000};
    layer.pass = i / 2;
    layer.filament_mm = 100;
    summary.layers.push_back(layer);
    summary.total.features[0].filament_mm += 100;
  }
  return summary;
}

PrintCode Filled(const MotionOptions& options) {
  const ProgramSummary summary = Summary();
  const auto code = macro::ParseJobCode(options);
  EXPECT_TRUE(code.ok()) << code.status();
  const auto filled = FillIn(*code, summary, PassChanges(summary), options, 60);
  EXPECT_TRUE(filled.ok()) << filled.status();
  return filled.value_or(PrintCode());
}

TEST(FillIn, PlacesAreThoseOfThePrint) {
  MotionOptions options;
  options.start_gcode = "{layer_num} {layer_z} {max_layer_z} {total_layer_count}";
  options.between_objects_gcode = "{layer_num} {layer_z} {max_layer_z} {current_object_idx}";
  options.end_gcode = "{layer_num} {layer_z} {max_layer_z}";
  const PrintCode code = Filled(options);
  EXPECT_EQ(code.start, "-1 0 0.4 4");
  EXPECT_THAT(code.between, ElementsAre("1 0.4 0.4 1"));
  EXPECT_EQ(code.end, "3 0.4 0.4");
  EXPECT_THAT(code.layers, IsEmpty());
}

// F / (bed + print), as Bambu Studio computes it; the empty bed has the machine's limit.
TEST(FillIn, TheBedsAccelerationFallsWithTheMassOnIt) {
  MotionOptions options;
  options.limits.max_acceleration_mm_s2[1] = 20'000;
  options.tool().filament_density_g_cm3 = 1000 / 2.405282;  // 1 g per mm of filament
  options.layer_gcode =
      "{int(curr_y_acceleration_limit)} {int(curr_accumulated_mass + 0.5)} {int(curr_layer_mass + "
      "0.5)}";
  EXPECT_THAT(Filled(options).layers, ElementsAre("", "20000 0 0", "", "20000 100 100", "",
                                                  "20000 200 100", "", "20000 300 100"));
  options.bed_motor = {.force_n = 29, .bed_mass_g = 1400};
  EXPECT_THAT(Filled(options).layers, ElementsAre("", "20000 0 0", "", "19333 100 100", "",
                                                  "18125 200 100", "", "17058 300 100"));
}

TEST(FillIn, SumsRunFromLayerToLayer) {
  MotionOptions options;
  options.start_gcode = "{extruded_weight_total}";
  options.layer_gcode =
      "{int(extruded_volume_total)} {extruded_weight[0] == extruded_weight_total}";
  options.end_gcode = "{int(extruded_volume[0])}";
  const PrintCode code = Filled(options);
  EXPECT_EQ(code.start, "0");
  EXPECT_THAT(code.layers,
              ElementsAre("", "0 true", "", "240 true", "", "481 true", "", "721 true"));
  EXPECT_EQ(code.end, "962");
}

TEST(FillIn, GlobalsLiveOverBlocks) {
  MotionOptions options;
  options.start_gcode = "{global count = 9}";
  options.tool().start_filament_gcode = "{count = count + 1}{count}";
  options.before_layer_gcode = "{count = count + 1}";
  options.layer_gcode = "{count}";
  options.between_objects_gcode = "{count = 20}";
  options.end_gcode = "{count}";
  const PrintCode code = Filled(options);
  EXPECT_EQ(code.start_filament, "10");
  EXPECT_THAT(code.layers, ElementsAre("", "11", "", "12", "", "21", "", "22"));
  EXPECT_EQ(code.end, "22");
}

}  // namespace
}  // namespace slicefarm::motion::print_code_test
