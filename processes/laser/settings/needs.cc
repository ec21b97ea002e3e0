#include "processes/laser/settings/needs.h"

#include <iterator>

#include "processes/laser/model/exposure_options.h"
#include "processes/laser/model/exposure_settings.h"

namespace slicefarm::config::laser {
namespace {

bool IsRings(const JobRows& s) {
  const ScanStrategy strategy = ExposureOf(s).region.strategy;
  return strategy == ScanStrategy::kRings || strategy == ScanStrategy::kRingsInward;
}
bool IsHatched(const JobRows& s) { return !IsRings(s); }
bool IsGcode(const JobRows& s) {
  const OutputFormat format = ExposureOf(s).output.format;
  return format == OutputFormat::kGrbl || format == OutputFormat::kMarlin;
}
bool IsCli(const JobRows& s) {
  const OutputFormat format = ExposureOf(s).output.format;
  return format == OutputFormat::kCliAscii || format == OutputFormat::kCliBinary;
}
bool HasContours(const JobRows& s) { return ExposureOf(s).region.contours > 0; }

constexpr Need kNeeds[] = {
    {"decompose_method ring_overlap link_rings ring_corners",
     "scan_strategy = rings or rings_inward", IsRings},
    {"hatch_angle hatch_rotation alternate_hatch skywriting gas_window",
     "scan_strategy = stripes, islands or hatch", IsHatched},
    {"gas_flow", "gas_window above 0, or jump_order = against_gas",
     [](const JobRows& s) {
       const ExposureOptions& region = ExposureOf(s).region;
       return region.gas_window_deg > 0 || region.jump_order == JumpOrder::kAgainstGas;
     }},
    {"stripe_width", "scan_strategy = stripes",
     [](const JobRows& s) { return ExposureOf(s).region.strategy == ScanStrategy::kStripes; }},
    {"island_width", "scan_strategy = islands",
     [](const JobRows& s) { return ExposureOf(s).region.strategy == ScanStrategy::kIslands; }},
    {"scan_overlap", "scan_strategy = stripes or islands",
     [](const JobRows& s) {
       const ScanStrategy strategy = ExposureOf(s).region.strategy;
       return strategy == ScanStrategy::kStripes || strategy == ScanStrategy::kIslands;
     }},
    {"hatch_offset", "scan_strategy = stripes, islands or hatch, and contours above 0",
     [](const JobRows& s) { return HasContours(s) && !IsRings(s); }},
    {"contour_start contours_first contour_power contour_speed contour_focus contour_frequency "
     "contour_point_distance contour_point_time contour_point_delay",
     "contours above 0", HasContours},
    {"contour_run", "contours above 0, or thin_wall_exposure = 1",
     [](const JobRows& s) { return HasContours(s) || ExposureOf(s).region.thin_walls; }},
    {"contour_distance", "contours above 1, or contours = 1 with rings",
     [](const JobRows& s) { return ExposureOf(s).region.contours > (IsRings(s) ? 0 : 1); }},
    {"skin_overlap", "upskin_layers or downskin_layers above 0",
     [](const JobRows& s) {
       const ExposureOptions& region = ExposureOf(s).region;
       return region.upskin_layers > 0 || region.downskin_layers > 0;
     }},
    {"upskin_distance upskin_power upskin_speed upskin_focus upskin_frequency "
     "upskin_point_distance "
     "upskin_point_time upskin_point_delay",
     "upskin_layers above 0",
     [](const JobRows& s) { return ExposureOf(s).region.upskin_layers > 0; }},
    {"downskin_distance downskin_power downskin_speed downskin_focus downskin_frequency "
     "downskin_point_distance "
     "downskin_point_time downskin_point_delay",
     "downskin_layers above 0",
     [](const JobRows& s) { return ExposureOf(s).region.downskin_layers > 0; }},
    {"thin_wall_power thin_wall_speed thin_wall_focus thin_wall_frequency "
     "thin_wall_point_distance thin_wall_point_time thin_wall_point_delay",
     "thin_wall_exposure = 1", [](const JobRows& s) { return ExposureOf(s).region.thin_walls; }},
    {"contour_frequency hatch_frequency upskin_frequency downskin_frequency thin_wall_frequency "
     "contour_point_distance hatch_point_distance upskin_point_distance downskin_point_distance "
     "thin_wall_point_distance contour_point_time hatch_point_time upskin_point_time "
     "downskin_point_time thin_wall_point_time contour_point_delay hatch_point_delay "
     "upskin_point_delay downskin_point_delay thin_wall_point_delay",
     "output_format = cli or cli_binary, otherwise only the report uses it", IsCli},
    {"contour_focus hatch_focus upskin_focus downskin_focus thin_wall_focus contour_power "
     "hatch_power upskin_power downskin_power thin_wall_power contour_speed hatch_speed "
     "upskin_speed downskin_speed thin_wall_speed",
     "output_format = cli, cli_binary, grbl or marlin, otherwise only the report uses it",
     [](const JobRows& s) { return IsCli(s) || IsGcode(s); }},
    {"jump_delay mark_delay polygon_delay",
     "output_format = grbl or marlin, otherwise only the report uses it", IsGcode},
    {"jump_speed", "output_format = marlin, otherwise only the report uses it",
     [](const JobRows& s) { return ExposureOf(s).output.format == OutputFormat::kMarlin; }},
    {"output_layer", "output_format = dxf",
     [](const JobRows& s) { return ExposureOf(s).output.format == OutputFormat::kDxf; }},
    {"cli_unit", "output_format = cli or cli_binary", IsCli},
    {"laser_full_power laser_full_s laser_dynamic_power start_gcode before_layer_gcode "
     "layer_gcode end_gcode",
     "output_format = grbl or marlin", IsGcode},
};

}  // namespace

std::vector<Need> Needs() { return {std::begin(kNeeds), std::end(kNeeds)}; }

}  // namespace slicefarm::config::laser
