#include "processes/laser/settings/settings_exposure.h"

#include <fmt/core.h>

#include <deque>
#include <iterator>
#include <string>
#include <utility>

#include "common/config/table/bind.h"
#include "processes/laser/model/exposure_options.h"
#include "processes/laser/model/exposure_settings.h"
#include "processes/laser/settings/needs.h"

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
       .doc = "Pattern that scans the inside of an outline. rings, rings_inward: convex pieces of "
              "the outline, each scanned in rings from its middle outwards, or inwards. stripes: "
              "parallel stripes of hatch lines. islands: a chequerboard of squares with hatch "
              "lines. hatch: lines across the whole area",
       .choices = {Named("rings", ScanStrategy::kRings),
                   Named("rings_inward", ScanStrategy::kRingsInward),
                   Named("stripes", ScanStrategy::kStripes),
                   Named("islands", ScanStrategy::kIslands), Named("hatch", ScanStrategy::kHatch)},
       .field = Bind<&ExposureOptions::strategy>()},
      {.key = "decompose_method",
       .kind = Kind::kChoice,
       .standard = "bian",
       .doc = "Method that divides outlines into convex pieces for scan_strategy = rings or "
              "rings_inward. bian: well-shaped pieces. optimal: the fewest pieces without new "
              "corners (slow). approximate and ymonotone: fast",
       .choices = {Named("bian", DecomposeMethod::kBian),
                   Named("optimal", DecomposeMethod::kOptimal),
                   Named("approximate", DecomposeMethod::kApproximate),
                   Named("ymonotone", DecomposeMethod::kYMonotone)},
       .field = Bind<&ExposureOptions::decompose>(),
       .needs = {&needs::kRings}},
      {.key = "jump_order",
       .kind = Kind::kChoice,
       .standard = "nearest",
       .doc = "Order in which convex pieces, stripes or islands are scanned. nearest: the nearest "
              "next. chequerboard: every second one first. farthest: the farthest next, which "
              "spreads heat. against_gas: from the downstream end of gas_flow, so that smoke blows "
              "over scanned areas; this also orders copies, contours and the lines of a stripe",
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
       .doc = "Distance between neighbouring hatch lines, and between rings",
       .field = Bind<&ExposureOptions::hatch_distance_nm>()},
      {.key = "hatch_angle",
       .unit = "degrees",
       .min = -360,
       .max = 360,
       .standard = "45",
       .doc = "Direction of the hatch lines of the first layer, counter-clockwise from the x axis",
       .field = Bind<&ExposureOptions::hatch_angle_deg>(),
       .needs = {&needs::kHatched}},
      {.key = "hatch_rotation",
       .unit = "degrees",
       .min = -360,
       .max = 360,
       .standard = "67",
       .doc = "Angle by which hatch lines turn counter-clockwise from layer to layer",
       .field = Bind<&ExposureOptions::layer_rotation_deg>(),
       .needs = {&needs::kHatched}},
      {.key = "gas_flow",
       .unit = "degrees",
       .min = -360,
       .max = 360,
       .standard = "0",
       .doc = "Direction into which the gas flows, counter-clockwise from the x axis",
       .field = Bind<&ExposureOptions::gas_flow_deg>(),
       .needs = {&needs::kGasDirection}},
      {.key = "gas_window",
       .unit = "degrees",
       .min = 0,
       .max = kWidestGasWindowDeg,
       .standard = "0",
       .doc = "Angle between the gas flow and a hatch line below which the line is turned by 90 "
              "degrees, or by 45 degrees with scan_strategy = islands; 0: no lines are turned",
       .field = Bind<&ExposureOptions::gas_window_deg>(),
       .needs = {&needs::kHatched}},
      Needing({&needs::kHatched}, Flag("alternate_hatch", "1",
                                       "Scan every second hatch line in the opposite direction; 0: "
                                       "all lines in the same direction",
                                       Bind<&ExposureOptions::alternate_directions>())),
      Length("minimum_vector", 10, "0",
             "Length below which hatch lines and rings are omitted; 0: all are scanned",
             Bind<&ExposureOptions::minimum_vector_nm>()),
      {.key = "stripe_width",
       .unit = "mm",
       .min = 0.01,
       .max = 1000,
       .standard = "5",
       .doc = "Width of a stripe",
       .field = Bind<&ExposureOptions::stripe_width_nm>(),
       .needs = {&needs::kStripes}},
      {.key = "island_width",
       .unit = "mm",
       .min = 0.01,
       .max = 1000,
       .standard = "5",
       .doc = "Side length of an island",
       .field = Bind<&ExposureOptions::island_width_nm>(),
       .needs = {&needs::kIslands}},
      Needing({&needs::kCells},
              Length("scan_overlap", 10, "0.1", "Overlap of neighbouring stripes or islands",
                     Bind<&ExposureOptions::overlap_nm>())),
      Needing({&needs::kRings},
              Length("ring_overlap", 10, "0.02",
                     "Overlap of the outermost rings of neighbouring convex pieces",
                     Bind<&ExposureOptions::ring_overlap_nm>())),
      Needing(
          {&needs::kRings},
          Flag("link_rings", "1",
               "Keep the laser on between the rings of a convex piece; 0: a jump from ring to ring",
               Bind<&ExposureOptions::link_rings>())),
      Needing({&needs::kRings},
              Flag("ring_corners", "1",
                   "Extend rings into the sharp corners of the ring around them, which a round "
                   "laser spot does not reach; 0: these corners may remain unexposed",
                   Bind<&ExposureOptions::fill_corners>())),
      Flag("shift_grids", "1",
           "Shift hatch lines, stripes and islands from layer to layer, so that their borders are "
           "not above each other; 0: the same positions in all layers",
           Bind<&ExposureOptions::shift_grids>()),
      Flag("turn_rings", "1",
           "Start rings at other points in each layer, and divide the area into other convex "
           "pieces; 0: the same in all layers",
           Bind<&ExposureOptions::turn_rings>()),
      Length("laser_spot", 10, "0.08", "Width of the line that the laser melts or cures",
             Bind<&ExposureOptions::spot_nm>()),
      Length("beam_compensation", 10, "0.04",
             "Distance from the outline of the part to the centre line of the outermost contour; "
             "usually half of laser_spot",
             Bind<&ExposureOptions::beam_compensation_nm>()),
      Count("contours", 100, "2", "Number of contours along the outline; 0: no contours",
            Bind<&ExposureOptions::contours>()),
      {.key = "contour_distance",
       .unit = "mm",
       .min = 0.001,
       .max = 10,
       .standard = "0.08",
       .doc = "Distance between neighbouring contours, and from the innermost contour to the "
              "outermost ring",
       .field = Bind<&ExposureOptions::contour_distance_nm>(),
       .needs = {&needs::kSecondContour}},
      Needing({&needs::kContoursOfHatch},
              Length("hatch_offset", 10, "0.04",
                     "Distance from the innermost contour to the ends of hatch lines; lines "
                     "parallel to the contour may be closer by half of laser_spot",
                     Bind<&ExposureOptions::hatch_offset_nm>())),
      {.key = "contour_start",
       .kind = Kind::kChoice,
       .standard = "scattered",
       .doc = "Start point of contours. scattered: another point in each layer, so that no seam "
              "runs up the part. nearest: the corner nearest to the laser's position. rear: the "
              "rearmost corner",
       .choices = {Named("scattered", ContourStart::kScattered),
                   Named("nearest", ContourStart::kNearest), Named("rear", ContourStart::kRear)},
       .field = Bind<&ExposureOptions::contour_start>(),
       .needs = {&needs::kContours}},
      Needing({&needs::kContoursOrThinWalls},
              Length("contour_run", 10, "0",
                     "Length by which the scanner moves with the laser off before and after each "
                     "contour and thin wall, to reach full speed; 0: no such moves",
                     Bind<&ExposureOptions::contour_run_nm>())),
      Needing({&needs::kContours},
              Flag("contours_first", "1", "Scan contours before the area inside them; 0: after it",
                   Bind<&ExposureOptions::contours_first>())),
      Flag("thin_wall_exposure", "1",
           "Expose areas once along their middle that are too narrow for a contour, or for another "
           "line between contours; 0: they remain unexposed",
           Bind<&ExposureOptions::thin_walls>()),
      Count("upskin_layers", 100, "0",
            "Number of layers above an area that decide whether the area is upskin. If any of "
            "these layers does not cover the area, the area is scanned with the upskin_ settings. "
            "0: no upskins",
            Bind<&ExposureOptions::upskin_layers>()),
      Count("downskin_layers", 100, "0",
            "Number of layers below an area that decide whether the area is downskin. If any of "
            "these layers does not cover the area, the area is scanned with the downskin_ "
            "settings. 0: no downskins",
            Bind<&ExposureOptions::downskin_layers>()),
      Needing(
          {&needs::kUpskins},
          Length(
              "upskin_distance", 10, "0",
              "Distance between neighbouring hatch lines and rings in upskins; 0: hatch_distance",
              Bind<&ExposureOptions::upskin_distance_nm>())),
      Needing(
          {&needs::kDownskins},
          Length(
              "downskin_distance", 10, "0",
              "Distance between neighbouring hatch lines and rings in downskins; 0: hatch_distance",
              Bind<&ExposureOptions::downskin_distance_nm>())),
      Count("z_compensation_layers", 100, "0",
            "Number of layers below the scanned layer that the laser also melts. An area is "
            "exposed only if it is solid in all of these layers, so that undersides do not become "
            "too thick. 0: no compensation",
            Bind<&ExposureOptions::z_compensation_layers>()),
      Needing({&needs::kSkins}, Length("skin_overlap", 10, "0",
                                       "Distance by which upskins and downskins extend into the "
                                       "neighbouring area; 0: not at all",
                                       Bind<&ExposureOptions::skin_overlap_nm>())),
      Needing({&needs::kHatched},
              Length("skywriting", 10, "0",
                     "Length by which the scanner moves with the laser off before and after each "
                     "hatch line, to reach full speed; 0: no such moves",
                     Bind<&ExposureOptions::skywriting_nm>())),
      {.key = "jump_speed",
       .unit = "mm/s",
       .min = 1,
       .max = 1e5,
       .standard = "5000",
       .doc = "Speed of jumps: moves between lines with the laser off",
       .field = Bind<&ExposureOptions::jump, &JumpOptions::speed_mm_s>(),
       .needs = {&needs::kJumpSpeedInFile}},
      Needing(
          {&needs::kDelaysInFile},
          Delay("jump_delay", "Delay after each jump, in which the mirrors of the scanner settle",
                Bind<&ExposureOptions::jump, &JumpOptions::delay_us>())),
      Needing({&needs::kDelaysInFile},
              Delay("mark_delay", "Delay after each scanned line, in which the laser switches off",
                    Bind<&ExposureOptions::jump, &JumpOptions::mark_delay_us>())),
      Needing(
          {&needs::kDelaysInFile},
          Delay("polygon_delay",
                "Delay at each corner of a scanned line, in which the mirrors of the scanner turn",
                Bind<&ExposureOptions::jump, &JumpOptions::polygon_delay_us>())),
  };
}

/// Returns the requirements for vectors of the kind; none for hatch lines, which every job has.
std::vector<const Need*> NeedsOf(ExposureKind kind) {
  switch (kind) {
    case ExposureKind::kContour:
      return {&needs::kContours};
    case ExposureKind::kUpskin:
      return {&needs::kUpskins};
    case ExposureKind::kDownskin:
      return {&needs::kDownskins};
    case ExposureKind::kThinWall:
      return {&needs::kThinWalls};
    case ExposureKind::kHatch:
      break;
  }
  return {};
}

/// Appends the style settings of one kind of vector: keys `contour_power` and so on.
template <size_t kKind>
void AppendStyle(std::vector<SettingSpec>& all) {
  const auto kind = static_cast<ExposureKind>(kKind);
  const std::string words(ExposureKindName(kind));
  std::string prefix = words;
  for (char& c : prefix) c = c == ' ' ? '_' : c;
  const auto add = [&](std::string_view name, std::string_view unit, double min, double max,
                       std::string_view standard, std::string_view doc, Field field,
                       const Need& file) {
    std::vector<const Need*> needs = NeedsOf(kind);
    needs.push_back(&file);
    all.push_back({.key = Kept(prefix + "_" + std::string(name)),
                   .unit = unit,
                   .min = min,
                   .max = max,
                   .standard = standard,
                   .doc = Kept(fmt::format("{} of {} vectors", doc, words)),
                   .field = field,
                   .needs = std::move(needs)});
  };
  add("power", "W", 0, 1e5, "200", "Laser power",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::power_w>(), needs::kStylesInFile);
  add("speed", "mm/s", 0.1, 1e5, "800", "Scan speed",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::speed_mm_s>(), needs::kStylesInFile);
  add("focus", "mm", -100, 100, "0",
      "Height of the laser's focus above the layer (0: on the layer)",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::focus_mm>(), needs::kStylesInFile);
  add("frequency", "kHz", 0, 1e5, "0", "Pulse frequency (0: the laser is on continuously)",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::frequency_khz>(), needs::kPulsesInFile);
  add("point_distance", "mm", 0, 10, "0", "Distance between exposure points (0: a continuous line)",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::point_distance_nm>(),
      needs::kPulsesInFile);
  add("point_time", "us", 0, 1e6, "0", "Exposure time of each point",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::point_time_us>(), needs::kPulsesInFile);
  add("point_delay", "us", 0, 1e6, "0", "Delay between exposure points",
      Bind<&ExposureOptions::styles, kKind, &ExposureStyle::point_delay_us>(),
      needs::kPulsesInFile);
}

std::vector<SettingSpec> OutputSettings() {
  return {
      {.key = "output_format",
       .kind = Kind::kChoice,
       .standard = "cli",
       .doc = "Format of the output file. cli: Common Layer Interface as text. cli_binary: the "
              "same with binary geometry. grbl, marlin: G-code for this firmware. svg: drawings of "
              "all layers. dxf: a drawing of output_layer",
       .choices = {Named("cli", OutputFormat::kCliAscii),
                   Named("cli_binary", OutputFormat::kCliBinary),
                   Named("grbl", OutputFormat::kGrbl), Named("marlin", OutputFormat::kMarlin),
                   Named("svg", OutputFormat::kSvg), Named("dxf", OutputFormat::kDxf)},
       .field = Bind<&ExposureOutput::format>()},
      Needing({&needs::kDxf},
              Count("output_layer", 1e6, "0", "Layer that a dxf file shows, counted from 0",
                    Bind<&ExposureOutput::layer>())),
      {.key = "cli_unit",
       .unit = "mm",
       .min = 1e-5,
       .max = 1,
       .standard = "0.001",
       .doc = "Length of one unit of the coordinates in a CLI file ($$UNITS)",
       .field = Bind<&ExposureOutput::unit_mm>(),
       .needs = {&needs::kCli}},
      {.key = "laser_full_power",
       .unit = "W",
       .min = 0.001,
       .max = 1e5,
       .standard = "400",
       .doc = "Laser power that the value laser_full_s of S in the G-code gives",
       .field = Bind<&ExposureOutput::full_power_w>(),
       .needs = {&needs::kGcode}},
      {.key = "laser_full_s",
       .min = 1,
       .max = 1e6,
       .standard = "1000",
       .doc = "Value of S in the G-code that gives laser_full_power ($30 of grbl)",
       .field = Bind<&ExposureOutput::full_power_s>(),
       .needs = {&needs::kGcode}},
      Needing({&needs::kGcode},
              Flag("laser_dynamic_power", "1",
                   "Reduce the laser power where the head is slower (M4); 0: constant power (M3)",
                   Bind<&ExposureOutput::dynamic_power>())),
      {.key = "recoating_time",
       .unit = "s",
       .min = 0,
       .max = 3600,
       .standard = "0",
       .doc = "Duration of recoating before each layer, for the estimated time; 0: not counted",
       .field = Bind<&ExposureOutput::recoat_s>()},
      Needing({&needs::kGcode}, Gcode("start_gcode", "G-code before the first layer",
                                      Bind<&ExposureOutput::start_gcode>())),
      Needing({&needs::kGcode},
              Gcode("before_layer_gcode", "G-code before the move in z to each layer",
                    Bind<&ExposureOutput::before_layer_gcode>())),
      Needing({&needs::kGcode},
              Gcode("layer_gcode",
                    "G-code after the move in z to each layer, such as commands for the recoater",
                    Bind<&ExposureOutput::layer_gcode>())),
      Needing({&needs::kGcode}, Gcode("end_gcode", "G-code after the last layer",
                                      Bind<&ExposureOutput::end_gcode>())),
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
