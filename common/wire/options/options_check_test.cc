#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/model/options/slicing_options.h"
#include "common/wire/options/options_wire.h"
#include "processes/fdm/model/fdm_settings.h"
#include "processes/laser/model/exposure_settings.h"
#include "processes/mill/model/milling_options.h"

namespace slicefarm::options_check_test {
namespace {

template <typename Options>
struct Refused {
  std::string name;
  std::function<void(Options&)> spoil;
  std::string member;
};

template <typename Options>
void ExpectRefused(const std::vector<Refused<Options>>& cases) {
  ASSERT_TRUE(OptionsFromBytes<Options>(PackFields(Options{})).ok());
  for (const auto& [name, spoil, member] : cases) {
    Options options;
    spoil(options);
    const absl::Status status = OptionsFromBytes<Options>(PackFields(options)).status();
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed) << name << ": " << status;
    EXPECT_EQ(DetailOf(status).metadata["field"], member) << name;
  }
}

using Fdm = FdmSettings;

TEST(OptionsCheck, RefusesFdmSettingsNamingTheMember) {
  ExpectRefused<FdmSettings>({
      {"no planned objects", [](Fdm& s) { s.objects.clear(); }, "objects"},
      {"negative clearance", [](Fdm& s) { s.machine.plan.sequence.clearance_height_nm = -1; },
       "sequence.clearance_height_nm"},
      {"negative print height", [](Fdm& s) { s.machine.motion.max_print_height_nm = -1; },
       "max_print_height_nm"},
      {"negative resolution", [](Fdm& s) { s.machine.motion.resolution_nm = -1; }, "resolution_nm"},
      {"too many skirts", [](Fdm& s) { s.machine.plan.skirt.loops = 501; }, "skirt.loops"},
      {"skirt without width", [](Fdm& s) { s.machine.plan.skirt.width_nm = 0; }, "skirt.width_nm"},
      {"no filament", [](Fdm& s) { s.machine.plan.skirt.filament_area_mm2 = 0; },
       "skirt.filament_area_mm2"},
      {"negative skirt length", [](Fdm& s) { s.machine.plan.skirt.min_length_nm = -1; },
       "skirt.min_length_nm"},
      {"negative brim", [](Fdm& s) { s.objects[0].brim.width_nm = -1; },
       "objects[0].brim.width_nm"},
      {"ear angle", [](Fdm& s) { s.objects[0].brim.ear_max_angle_rad = 7; },
       "objects[0].brim.ear_max_angle_rad"},
      {"row of the brim", [](Fdm& s) { s.objects[0].brim_settings = -1; },
       "objects[0].brim_settings"},
      {"raft", [](Fdm& s) { s.objects[0].raft.heights.layers = -1; }, "objects[0].raft.layers"},
      {"tree", [](Fdm& s) { s.objects[0].support.tree.branch_distance_nm = 0; },
       "objects[0].tree.branch_distance_nm"},
      {"threshold", [](Fdm& s) { s.objects[0].support.threshold_rad = 2; },
       "objects[0].support.threshold_rad"},
      {"no regions", [](Fdm& s) { s.regions.clear(); }, "speeds"},
      {"no tools", [](Fdm& s) { s.tools.clear(); }, "tools"},
      {"negative detour", [](Fdm& s) { s.machine.order.travel.max_detour_mm = -1; }, "travel"},
      {"density above one", [](Fdm& s) { s.regions[0].infill.density = 1.01; },
       "infill[0].density"},
      {"scarf below its layer", [](Fdm& s) { s.regions[0].motion.scarf.start_height_ratio = -1; },
       "speeds[0].scarf.start_height_ratio"},
      {"scarf length", [](Fdm& s) { s.regions[0].motion.scarf.length_mm = -1; },
       "speeds[0].scarf.length_mm"},
      {"scarf of endless pieces", [](Fdm& s) { s.regions[0].motion.scarf.max_segment_mm = 0; },
       "speeds[0].scarf.max_segment_mm"},
      {"negative speed", [](Fdm& s) { s.regions[0].motion.speed_mm_s[3] = -1; },
       "speeds[0].speed_mm_s"},
      {"negative fan", [](Fdm& s) { s.tools[0].cooling.min_fan_percent = -1; },
       "tools[0].cooling: a fan"},
      {"negative perimeters", [](Fdm& s) { s.regions[0].walls.perimeters = -1; },
       "walls[0].perimeters"},
      {"no width", [](Fdm& s) { s.regions[0].walls.inner_width_nm = 0; },
       "walls[0].inner_width_nm"},
      {"negative spare", [](Fdm& s) { s.regions[0].infill.top_spare.layers = -1; },
       "infill[0].spare.layers"},
  });
}

using Slicing = SlicingOptions;

TEST(OptionsCheck, RefusesSlicingOptionsNamingTheMember) {
  ExpectRefused<SlicingOptions>({
      {"negative distance", [](Slicing& s) { s.part_distance_nm = -1; }, "part_distance_nm"},
      {"lift below the bed", [](Slicing& s) { s.objects[0].lift_nm = -1; }, "objects[0].lift_nm"},
      {"heights upside down", [](Slicing& s) { s.objects[0].adaptive.max_nm = 1; },
       "objects[0].adaptive.max_nm"},
      {"no ratio", [](Slicing& s) { s.objects[0].adaptive.max_ratio = 0.5; },
       "objects[0].adaptive.max_ratio"},
      {"a profile that falls",
       [](Slicing& s) {
         s.objects[0].height_profile = {{9, 1}, {8, 1}};
       },
       "objects[0].height_profile"},
      {"no objects", [](Slicing& s) { s.objects.clear(); }, "objects"},
      {"no layer height", [](Slicing& s) { s.objects[0].layer_height_nm = 0; },
       "objects[0].layer_height_nm"},
      {"no first layer", [](Slicing& s) { s.first_layer_height_nm = 0; }, "first_layer_height_nm"},
      {"bed of two points", [](Slicing& s) { s.bed.resize(2); }, "bed"},
      {"huge thumbnail", [](Slicing& s) { s.thumbnails[0].width_px = 1 << 20; }, "thumbnails"},
  });
}

using Laser = ExposureSettings;

TEST(OptionsCheck, RefusesExposureSettingsNamingTheMember) {
  ExpectRefused<ExposureSettings>({
      {"no regions", [](Laser& s) { s.regions.clear(); }, "regions"},
      {"lines of no distance", [](Laser& s) { s.regions[0].hatch_distance_nm = 1; },
       "regions[0].hatch_distance_nm"},
      {"stripes within stripes", [](Laser& s) { s.regions[0].overlap_nm = 5'000'000; },
       "regions[0].overlap_nm"},
      {"wide window", [](Laser& s) { s.regions[0].gas_window_deg = 46; },
       "regions[0].gas_window_deg"},
      {"no speed", [](Laser& s) { s.regions[0].styles[1].speed_mm_s = 0; },
       "regions[0].styles.speed_mm_s"},
      {"negative delay", [](Laser& s) { s.regions[0].jump.delay_us = -1; },
       "regions[0].jump: a delay"},
      {"negative power", [](Laser& s) { s.regions[0].styles[2].power_w = -1; },
       "regions[0].styles: an amount"},
      {"no jump", [](Laser& s) { s.regions[0].jump.speed_mm_s = 0; }, "regions[0].jump.speed_mm_s"},
      {"narrow stripes", [](Laser& s) { s.regions[0].stripe_width_nm = 1'000; },
       "regions[0].stripe_width_nm, island_width_nm"},
      {"rings over rings", [](Laser& s) { s.regions[0].ring_overlap_nm = 80'001; },
       "regions[0].ring_overlap_nm"},
      {"beam grows the part", [](Laser& s) { s.regions[0].beam_compensation_nm = -5; },
       "regions[0].beam_compensation_nm"},
      {"skins of a thousand layers", [](Laser& s) { s.regions[0].downskin_layers = 1'001; },
       "regions[0].contours or skin layers"},
      {"skins too fine", [](Laser& s) { s.regions[0].downskin_distance_nm = 999; },
       "regions[0].upskin_distance_nm, downskin_distance_nm"},
      {"islands both ways",
       [](Laser& s) {
         s.regions[0].strategy = ScanStrategy::kIslands;
         s.regions[0].gas_window_deg = 23;
       },
       "regions[0].gas_window_deg"},
      {"negative layer", [](Laser& s) { s.output.layer = -1; }, "output.layer"},
      {"no unit", [](Laser& s) { s.output.unit_mm = 0; }, "output.unit_mm"},
  });
}

TEST(OptionsCheck, RefusesAStepBeforeTheFirst) {
  ExpectRefused<MillSettings>(
      {{"step", [](MillSettings& s) { s.output_step = -1; }, "output_step"}});
}

TEST(OptionsCheck, RefusesMoreRowsThanAJobMayHave) {
  SlicingOptions options;
  options.objects.resize(limits::kMaxRegionSettings + 1);
  const absl::Status status = OptionsFromBytes<SlicingOptions>(PackFields(options)).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge) << status;
}

TEST(OptionsCheck, ABedThatLimitsNothingReturns) {
  SlicingOptions options;
  options.bed.clear();
  const auto back = OptionsFromBytes<SlicingOptions>(PackFields(options));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(*back, options);
}

}  // namespace
}  // namespace slicefarm::options_check_test
