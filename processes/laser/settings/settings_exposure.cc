#include "processes/laser/settings/settings_exposure.h"

#include <fmt/core.h>

#include <deque>
#include <iterator>
#include <string>
#include <utility>

#include "common/config/table/bind.h"
#include "processes/laser/model/exposure_options.h"
#include "processes/laser/model/exposure_settings.h"

namespace slicefarm::config {

template <>
struct RowOf<ExposureOptions> : MemberRow<&ExposureRows::region, Scope::kRegion> {};
template <>
struct RowOf<ExposureOutput> : MemberRow<&ExposureRows::output, Scope::kJob> {};

}  // namespace slicefarm::config

namespace slicefarm::config::laser {
namespace {

template <class Enum>
Choice Named(std::string_view name, Enum value) {
  return {name, static_cast<int>(value)};
}

/// Returns a view of a text that exists as long as the table; used for assembled keys and texts.
std::string_view Kept(std::string text) {
  static auto& texts = *new std::deque<std::string>();
  return texts.emplace_back(std::move(text));
}

SettingSpec Length(std::string_view key, double max, std::string_view standard,
                   std::string_view doc, Field field) {
  return {.key = key,
          .unit = "mm",
          .min = 0,
          .max = max,
          .standard = standard,
          .doc = doc,
          .field = field};
}

SettingSpec Flag(std::string_view key, std::string_view standard, std::string_view doc,
                 Field field) {
  return {.key = key, .kind = Kind::kFlag, .standard = standard, .doc = doc, .field = field};
}

SettingSpec Count(std::string_view key, double max, std::string_view standard, std::string_view doc,
                  Field field) {
  return {.key = key,
          .kind = Kind::kInteger,
          .min = 0,
          .max = max,
          .standard = standard,
          .doc = doc,
          .field = field};
}

SettingSpec Delay(std::string_view key, std::string_view doc, Field field) {
  return {
      .key = key, .unit = "us", .min = 0, .max = 1e6, .standard = "0", .doc = doc, .field = field};
}

SettingSpec Gcode(std::string_view key, std::string_view doc, Field field) {
  return {.key = key, .kind = Kind::kGcode, .doc = doc, .field = field};
}

std::vector<SettingSpec> ScanSettings() {
  return {
      {.key = "scan_strategy",
       .kind = Kind::kChoice,
       .standard = "stripes",
       .doc = "How the inside of an outline is scanned: convex pieces by rings from the inside out "
              "(rings) or from the outside in, parallel stripes, a chequerboard of islands, or "
              "lines right through (hatch)",
       .choices = {Named("rings", ScanStrategy::kRings),
                   Named("rings_inward", ScanStrategy::kRingsInward),
                   Named("stripes", ScanStrategy::kStripes),
                   Named("islands", ScanStrategy::kIslands), Named("hatch", ScanStrategy::kHatch)},
       .field = Bind<&ExposureOptions::strategy>()},
      {.key = "decompose_method",
       .kind = Kind::kChoice,
       .standard = "bian",
       .doc = "How outlines are cut into convex pieces: for good shapes (bian), into the fewest "
              "without new corners (optimal, slow), or fast (approximate, ymonotone)",
       .choices = {Named("bian", DecomposeMethod::kBian),
                   Named("optimal", DecomposeMethod::kOptimal),
                   Named("approximate", DecomposeMethod::kApproximate),
                   Named("ymonotone", DecomposeMethod::kYMonotone)},
       .field = Bind<&ExposureOptions::decompose>()},
      {.key = "jump_order",
       .kind = Kind::kChoice,
       .standard = "nearest",
       .doc = "Which piece, stripe or island comes next: the nearest, every other one first "
              "(chequerboard), the farthest, so that heat spreads, or the one farthest along "
              "gas_flow (against_gas), so that smoke blows over what is done; copies, contours and "
              "the lines of a stripe then come in that order, too",
       .choices = {Named("nearest", JumpOrder::kNearest),
                   Named("chequerboard", JumpOrder::kChequerboard),
                   Named("farthest", JumpOrder::kFarthest),
                   Named("against_gas", JumpOrder::kAgainstGas)},
       .field = Bind<&ExposureOptions::jump_order>()},
      {.key = "hatch_distance",
       .unit = "mm",
       .min = 0.001,
       .max = 10,
       .standard = "0.08",
       .doc = "Distance of neighbouring lines, and of rings",
       .field = Bind<&ExposureOptions::hatch_distance_nm>()},
      {.key = "hatch_angle",
       .unit = "degrees",
       .min = -360,
       .max = 360,
       .standard = "45",
       .doc = "Direction of the lines of the first layer, from the x axis",
       .field = Bind<&ExposureOptions::hatch_angle_deg>()},
      {.key = "hatch_rotation",
       .unit = "degrees",
       .min = -360,
       .max = 360,
       .standard = "67",
       .doc = "By how much the lines turn from each layer to the next",
       .field = Bind<&ExposureOptions::layer_rotation_deg>()},
      {.key = "gas_flow",
       .unit = "degrees",
       .min = -360,
       .max = 360,
       .standard = "0",
       .doc = "Where the gas flows to, from the x axis",
       .field = Bind<&ExposureOptions::gas_flow_deg>()},
      {.key = "gas_window",
       .unit = "degrees",
       .min = 0,
       .max = kWidestGasWindowDeg,
       .standard = "0",
       .doc = "Hatch lines that run nearer to gas_flow or against it than this are turned by 90 "
              "degrees, those of islands by 45; 0: none are",
       .field = Bind<&ExposureOptions::gas_window_deg>()},
      Flag("alternate_hatch", "1", "Every other line runs backwards",
           Bind<&ExposureOptions::alternate_directions>()),
      Length("minimum_vector", 10, "0", "Shorter hatch lines and rings are left out",
             Bind<&ExposureOptions::minimum_vector_nm>()),
      {.key = "stripe_width",
       .unit = "mm",
       .min = 0.01,
       .max = 1000,
       .standard = "5",
       .doc = "Width of a stripe",
       .field = Bind<&ExposureOptions::stripe_width_nm>()},
      {.key = "island_width",
       .unit = "mm",
       .min = 0.01,
       .max = 1000,
       .standard = "5",
       .doc = "Side of an island",
       .field = Bind<&ExposureOptions::island_width_nm>()},
      Length("scan_overlap", 10, "0.1", "By how much neighbouring stripes or islands overlap",
             Bind<&ExposureOptions::overlap_nm>()),
      Length("ring_overlap", 10, "0.02",
             "By how much the outermost rings of neighbouring pieces overlap",
             Bind<&ExposureOptions::ring_overlap_nm>()),
      Flag("link_rings", "1", "The laser stays on from one ring of a piece to the next",
           Bind<&ExposureOptions::link_rings>()),
      Flag("ring_corners", "1",
           "Rings reach into sharp corners of the ring around them, which a round spot leaves open",
           Bind<&ExposureOptions::fill_corners>()),
      Flag("shift_grids", "1",
           "The lines and cells of hatch, stripes and islands lie elsewhere in each layer",
           Bind<&ExposureOptions::shift_grids>()),
      Flag("turn_rings", "1",
           "Rings begin, and outlines are cut into pieces, at other places in each layer",
           Bind<&ExposureOptions::turn_rings>()),
      Length("laser_spot", 10, "0.08", "Width of what a line melts or cures",
             Bind<&ExposureOptions::spot_nm>()),
      Length("beam_compensation", 10, "0.04",
             "From the outline to the middle of the outermost contour",
             Bind<&ExposureOptions::beam_compensation_nm>()),
      Count("contours", 100, "2", "Lines along the outline", Bind<&ExposureOptions::contours>()),
      {.key = "contour_distance",
       .unit = "mm",
       .min = 0.001,
       .max = 10,
       .standard = "0.08",
       .doc = "Distance of neighbouring contours, and of rings from the innermost one",
       .field = Bind<&ExposureOptions::contour_distance_nm>()},
      Length(
          "hatch_offset", 10, "0.04",
          "From the innermost contour to the ends of hatch lines; lines along the contour may lie "
          "half a spot nearer to it",
          Bind<&ExposureOptions::hatch_offset_nm>()),
      {.key = "contour_start",
       .kind = Kind::kChoice,
       .standard = "scattered",
       .doc = "Where contours begin and end: elsewhere in each layer, so that no seam runs up the "
              "part (scattered), at the corner nearest to where the laser is, or at the corner "
              "farthest back (rear)",
       .choices = {Named("scattered", ContourStart::kScattered),
                   Named("nearest", ContourStart::kNearest), Named("rear", ContourStart::kRear)},
       .field = Bind<&ExposureOptions::contour_start>()},
      Length("contour_run", 10, "0",
             "The scanner comes to and leaves each contour and thin wall on this length along its "
             "direction, with the laser off",
             Bind<&ExposureOptions::contour_run_nm>()),
      Flag("contours_first", "1", "Contours before the inside; 0: after it",
           Bind<&ExposureOptions::contours_first>()),
      Flag("thin_wall_exposure", "1",
           "What is too thin for a contour, or for one more line between contours, is exposed once "
           "along its middle",
           Bind<&ExposureOptions::thin_walls>()),
      Count("upskin_layers", 100, "0",
            "Where no part lies this many layers above, the style of upskin holds; 0: nowhere",
            Bind<&ExposureOptions::upskin_layers>()),
      Count("downskin_layers", 100, "0",
            "Where powder lies within this many layers below, the style of downskin holds; 0: "
            "nowhere",
            Bind<&ExposureOptions::downskin_layers>()),
      Length("upskin_distance", 10, "0",
             "Distance of neighbouring lines of upskins, and of rings; 0: hatch_distance",
             Bind<&ExposureOptions::upskin_distance_nm>()),
      Length("downskin_distance", 10, "0",
             "Distance of neighbouring lines of downskins, and of rings; 0: hatch_distance",
             Bind<&ExposureOptions::downskin_distance_nm>()),
      Count("z_compensation_layers", 100, "0",
            "By how many layers the laser melts deeper than the one it draws on: where powder lies "
            "within as many layers below, nothing is exposed",
            Bind<&ExposureOptions::z_compensation_layers>()),
      Length("skin_overlap", 10, "0", "How far skins reach into the rest",
             Bind<&ExposureOptions::skin_overlap_nm>()),
      Length("skywriting", 10, "0",
             "The scanner comes and goes on this length beyond each hatch line, with the laser off",
             Bind<&ExposureOptions::skywriting_nm>()),
      {.key = "jump_speed",
       .unit = "mm/s",
       .min = 1,
       .max = 1e5,
       .standard = "5000",
       .doc = "Speed with the laser off",
       .field = Bind<&ExposureOptions::jump, &JumpOptions::speed_mm_s>()},
      Delay("jump_delay", "Wait after a jump, until the mirrors rest",
            Bind<&ExposureOptions::jump, &JumpOptions::delay_us>()),
      Delay("mark_delay", "Wait after each line, until the laser is off",
            Bind<&ExposureOptions::jump, &JumpOptions::mark_delay_us>()),
      Delay("polygon_delay", "Wait at each corner of a line",
            Bind<&ExposureOptions::jump, &JumpOptions::polygon_delay_us>()),
  };
}

/// Appends the style settings of one kind of vector: keys `contour_power` and so on.
template <size_t kKind>
void AppendStyle(std::vector<SettingSpec>& all) {
  const auto kind = static_cast<ExposureKind>(kKind);
  const std::string words(ExposureKindName(kind));
  std::string prefix = words;
  for (char& c : prefix) c = c == ' ' ? '_' : c;
  const auto add = [&](std::string_view name, std::string_view unit, double min, double max,
                       std::string_view standard, std::string_view doc, Field field) {
    all.push_back({.key = Kept(prefix + "_" + std::string(name)),
                   .unit = unit,
                   .min = min,
                   .max = max,
                   .standard = standard,
                   .doc = Kept(fmt::format("{} of {} vectors", doc, words)),
                   .field = field});
  };
  add("power", "W", 0, 1e5, "200", "Power of the laser",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::power_w>());
  add("speed", "mm/s", 0.1, 1e5, "800", "Speed",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::speed_mm_s>());
  add("focus", "mm", -100, 100, "0", "Height of the focus above the layer",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::focus_mm>());
  add("frequency", "kHz", 0, 1e5, "0", "Pulse frequency (0: continuous)",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::frequency_khz>());
  add("point_distance", "mm", 0, 10, "0", "Distance of single points (0: a continuous line)",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::point_distance_nm>());
  add("point_time", "us", 0, 1e6, "0", "Exposure time of single points",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::point_time_us>());
  add("point_delay", "us", 0, 1e6, "0", "Wait between single points",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::point_delay_us>());
}

std::vector<SettingSpec> OutputSettings() {
  return {
      {.key = "output_format",
       .kind = Kind::kChoice,
       .standard = "cli",
       .doc = "Common Layer Interface as text (cli) or with binary geometry (cli_binary), G-code "
              "of grbl or Marlin, drawings of all layers (svg) or of one (dxf)",
       .choices = {Named("cli", OutputFormat::kCliAscii),
                   Named("cli_binary", OutputFormat::kCliBinary),
                   Named("grbl", OutputFormat::kGrbl), Named("marlin", OutputFormat::kMarlin),
                   Named("svg", OutputFormat::kSvg), Named("dxf", OutputFormat::kDxf)},
       .field = Bind<&ExposureOutput::format>()},
      Count("output_layer", 1e6, "0", "The layer of a dxf, from 0", Bind<&ExposureOutput::layer>()),
      {.key = "cli_unit",
       .unit = "mm",
       .min = 1e-5,
       .max = 1,
       .standard = "0.001",
       .doc = "What 1 means in a CLI file ($$UNITS)",
       .field = Bind<&ExposureOutput::unit_mm>()},
      {.key = "laser_full_power",
       .unit = "W",
       .min = 0.001,
       .max = 1e5,
       .standard = "400",
       .doc = "Power of the laser where G-code says S = laser_full_s",
       .field = Bind<&ExposureOutput::full_power_w>()},
      {.key = "laser_full_s",
       .min = 1,
       .max = 1e6,
       .standard = "1000",
       .doc = "The S of G-code that stands for laser_full_power ($30 of grbl)",
       .field = Bind<&ExposureOutput::full_power_s>()},
      Flag("laser_dynamic_power", "1",
           "M4: the power follows the head's speed; 0: M3, constant power",
           Bind<&ExposureOutput::dynamic_power>()),
      {.key = "recoating_time",
       .unit = "s",
       .min = 0,
       .max = 3600,
       .standard = "0",
       .doc = "How long it takes before each layer until there is new powder or resin",
       .field = Bind<&ExposureOutput::recoat_s>()},
      Gcode("start_gcode", "G-code before all layers", Bind<&ExposureOutput::start_gcode>()),
      Gcode("before_layer_gcode", "G-code before each layer's move in Z",
            Bind<&ExposureOutput::before_layer_gcode>()),
      Gcode("layer_gcode", "G-code after each layer's move in Z, such as for the recoater",
            Bind<&ExposureOutput::layer_gcode>()),
      Gcode("end_gcode", "G-code after all layers", Bind<&ExposureOutput::end_gcode>()),
  };
}

}  // namespace

std::vector<SettingSpec> ExposureTable() {
  std::vector<SettingSpec> all = ScanSettings();
  AppendStyle<0>(all);
  AppendStyle<1>(all);
  AppendStyle<2>(all);
  AppendStyle<3>(all);
  AppendStyle<4>(all);
  static_assert(kExposureKindCount == 5);
  // Gas flows in one direction over the whole bed, so objects cannot override it.
  for (SettingSpec& spec : all)
    if (spec.key == "gas_flow") spec.own_scope = Scope::kJob;
  std::ranges::move(OutputSettings(), std::back_inserter(all));
  return all;
}

}  // namespace slicefarm::config::laser
