#include "services/cli/calibration/calibration_plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/table/value.h"
#include "common/geometry/measure.h"
#include "common/model/bead_section.h"
#include "common/model/options/height_code.h"
#include "services/cli/calibration/calibration_lines.h"
#include "services/cli/calibration/calibration_shapes.h"

namespace slicefarm::cli {
namespace {

constexpr double kTallFloorMm = 10, kFloorMm = 5;
constexpr double kUsualWidth = 1.125;  ///< usual width of a bead, in diameters of the nozzle

Setting RequestOf(std::string_view key, std::string value) {
  return {std::string(key), std::move(value), Source::kRequest};
}

std::string NumberText(double value) { return fmt::format("{:g}", value); }

/// Builder of one print.
class CalibrationPlanner {
 public:
  CalibrationPlanner(CalibrationKind kind, CalibrationMethod method,
                     const std::vector<double>& levels, std::string_view settings_text)
      : info_(InfoOfCalibration(kind)), method_(method), levels_(levels), given_(settings_text) {
    plan_.table = {
        std::string(info_.name), std::string(info_.unit), std::string(info_.setting), {}};
    for (const auto& [key, value] :
         {std::pair("support_material", "0"), std::pair("raft_layers", "0"),
          std::pair("complete_objects", "0"), std::pair("spiral_vase", "0"),
          std::pair("fuzzy_skin", "none"), std::pair("ironing", "0")})
      Set(key, value);
  }

  absl::StatusOr<CalibrationPlan> Run() {
    absl::Status planned = absl::OkStatus();
    switch (info_.kind) {
      case CalibrationKind::kFlow:
        PlanFlow();
        break;
      case CalibrationKind::kVfa:
      case CalibrationKind::kVolumetricSpeed:
        planned = PlanSpeeds();
        break;
      case CalibrationKind::kPressureAdvance:
        planned = method_ == CalibrationMethod::kTower ? PlanCodes() : PlanLines();
        break;
      case CalibrationKind::kTemperature:
      case CalibrationKind::kRetraction:
      case CalibrationKind::kCornering:
      case CalibrationKind::kInputShaping:
        planned = PlanCodes();
        break;
    }
    if (!planned.ok()) return planned;
    return std::move(plan_);
  }

 private:
  void Set(std::string_view key, std::string value) {
    plan_.settings.push_back(RequestOf(key, std::move(value)));
  }

  Floors FloorsFor(double floor_mm) const {
    std::vector<std::string> labels;
    for (const double level : levels_) labels.push_back(LabelOf(info_, level));
    return FloorsOf(floor_mm, NumberIn(given_, "first_layer_height", 0.2),
                    NumberIn(given_, "layer_height", 0.2), std::move(labels));
  }

  /// Adds the tower and its rows.
  void AddTower(const Floors& floors, std::string stl, std::vector<HeightRange> ranges = {}) {
    std::string name = fmt::format("{} tower", info_.name);
    for (size_t i = 0; i < levels_.size(); ++i)
      plan_.table.rows.push_back(
          {floors.labels[i], levels_[i], floors.Bottom(i), floors.Bottom(i + 1), name});
    plan_.parts.push_back({std::move(name), std::move(stl), std::move(ranges), {}});
  }

  /// Leaves only walls, which are printed at full speed.
  void SetHollow(int walls) {
    Set("perimeters", std::to_string(walls));
    Set("fill_density", "0%");
    Set("top_solid_layers", "0");
    Set("bottom_solid_layers", "3");
    Set("solid_infill_below_area", "0");
    Set("slowdown_below_layer_time", "0");
    Set("seam_position", "rear");
  }

  /// Plans a kind with a command at the beginning of each floor.
  absl::Status PlanCodes() {
    const bool tall = info_.kind == CalibrationKind::kTemperature;
    const Floors floors = FloorsFor(tall ? kTallFloorMm : kFloorMm);
    constexpr double kAboveMm = 0.01;  // selects the first layer above the height
    const std::string_view flavor = TextIn(given_, "gcode_flavor");
    const bool by_firmware = NumberIn(given_, "use_firmware_retraction", 0) != 0;
    std::vector<HeightCode> codes;
    for (size_t i = 0; i < levels_.size(); ++i) {
      const Coord z_nm = FromMm((i == 0 ? 0 : floors.Bottom(i)) + kAboveMm);
      if (info_.kind == CalibrationKind::kRetraction && !by_firmware) {
        codes.push_back({z_nm, HeightCodeKind::kRetractLength, NumberText(levels_[i])});
        continue;
      }
      auto code = CodeOf(info_, flavor, levels_[i]);
      if (!code.ok()) return code.status();
      codes.push_back({z_nm, HeightCodeKind::kCustom, *std::move(code)});
    }
    Set("custom_gcode_per_print_z", PrintHeightCodes(codes));
    if (tall) {
      Set("perimeters", "2");
      Set("fill_density", "5%");
      Set("temperature", NumberText(levels_.front()));
      Set("first_layer_temperature", NumberText(levels_.front()));
      AddTower(floors, TemperatureTower(floors));
    } else if (info_.kind == CalibrationKind::kRetraction) {
      Set("retract_length", NumberText(*std::ranges::max_element(levels_)));
      AddTower(floors, PillarPair(floors));
    } else {
      SetHollow(2);
      AddTower(floors, CornerTower(floors));
    }
    return absl::OkStatus();
  }

  /// Plans lines, each with its value. The lines are G-code; the frame around them is sliced.
  absl::Status PlanLines() {
    const std::string_view flavor = TextIn(given_, "gcode_flavor");
    std::vector<ValueLine> lines;
    for (const double level : levels_) {
      auto code = CodeOf(info_, flavor, level);
      if (!code.ok()) return code.status();
      lines.push_back({LabelOf(info_, level), *std::move(code)});
    }
    LineSettings settings = SettingsOfLines();
    const auto own = CodeOf(info_, flavor, NumberIn(given_, "pressure_advance", 0));
    if (own.ok()) settings.code_after = *own;
    const bool corners = method_ == CalibrationMethod::kPattern;
    LinePrint print =
        MakeLinePrint(corners ? LineShape::kCorner : LineShape::kStraight, lines, settings);
    Set("custom_gcode_per_print_z", PrintHeightCodes(print.codes));
    // The lines need a retracted filament at the height of the layer, and relative E.
    for (const auto& [key, value] :
         {std::pair("use_relative_e_distances", "1"), std::pair("use_volumetric_e", "0"),
          std::pair("use_firmware_retraction", "0"), std::pair("retract_layer_change", "1"),
          std::pair("retract_lift", "0"), std::pair("travel_ramping_lift", "0"),
          std::pair("skirts", "0"), std::pair("brim_width", "0")})
      Set(key, value);
    const std::string name = fmt::format("{} {}", info_.name, corners ? "pattern" : "lines");
    for (size_t i = 0; i < levels_.size(); ++i)
      plan_.table.rows.push_back({lines[i].label, levels_[i], 0, 0, name});
    const Point middle = {FromMm(settings.middle[0]), FromMm(settings.middle[1])};
    plan_.parts.push_back({name, std::move(print.stl), {}, {}, middle});
    return absl::OkStatus();
  }

  LineSettings SettingsOfLines() const {
    constexpr double kFastMmS = 100;
    LineSettings settings;
    settings.first_layer_mm = NumberIn(given_, "first_layer_height", 0.2);
    settings.layer_mm = NumberIn(given_, "layer_height", 0.2);
    settings.width_mm = kUsualWidth * NumberIn(given_, "nozzle_diameter", 0.4);
    settings.flow = NumberIn(given_, "extrusion_multiplier", 1);
    const double diameter = NumberIn(given_, "filament_diameter", 1.75);
    settings.filament_mm2 = std::numbers::pi / 4 * diameter * diameter;
    settings.fast = SpeedWithinLimits(kFastMmS, settings);
    // A soft filament may allow less than the usual slow speed, but the lines need both speeds.
    settings.slow = std::min(settings.slow, settings.fast / 2);
    settings.travel = NumberIn(given_, "travel_speed", settings.travel);
    settings.retract_mm = NumberIn(given_, "retract_length", 0);
    settings.retract_speed = NumberIn(given_, "retract_speed", settings.retract_speed);
    settings.restart_speed = NumberIn(given_, "deretract_speed", 0);
    if (settings.restart_speed <= 0) settings.restart_speed = settings.retract_speed;
    settings.middle = MiddleOfBed();
    return settings;
  }

  /// Returns the speed, or the largest speed that the machine and the filament allow.
  double SpeedWithinLimits(double speed, const LineSettings& settings) const {
    const double section = std::max(settings.first_layer_mm, settings.layer_mm) * settings.width_mm;
    for (const auto& [key, per_mm] :
         {std::pair("machine_max_feedrate_x", 1.0), std::pair("machine_max_feedrate_y", 1.0),
          std::pair("max_volumetric_speed", section),
          std::pair("filament_max_volumetric_speed", section)})
      if (const double limit = NumberIn(given_, key, 0) / per_mm; limit > 0)
        speed = std::min(speed, limit);
    return speed;
  }

  /// Returns the middle of the smallest rectangle around the bed, in mm.
  std::array<double, 2> MiddleOfBed() const {
    const auto bed = config::ParseBedShape(TextIn(given_, "bed_shape"));
    if (!bed.ok()) return {};
    const Box box = Bounds(*bed);
    const auto middle = [](Coord low, Coord high) {
      return (ToMm(static_cast<double>(low)) + ToMm(static_cast<double>(high))) / 2;
    };
    return {middle(box.min.x, box.max.x), middle(box.min.y, box.max.y)};
  }

  /// Plans a kind with a speed of walls for each floor.
  absl::Status PlanSpeeds() {
    const bool by_volume = info_.kind == CalibrationKind::kVolumetricSpeed;
    const Floors floors = FloorsFor(kFloorMm);
    const double per_mm = by_volume ? BeadMm2() : 1;
    std::vector<HeightRange> ranges;
    for (size_t i = 0; i < levels_.size(); ++i) {
      const double speed = levels_[i] / per_mm;
      if (absl::Status ok = CheckSpeed(speed); !ok.ok()) return ok;
      HeightRange& range = ranges.emplace_back();
      range.from_mm = floors.Bottom(i);
      range.to_mm = floors.Bottom(i + 1);
      for (const char* key :
           {"perimeter_speed", "external_perimeter_speed", "small_perimeter_speed"})
        range.settings.push_back(RequestOf(key, fmt::format("{:.4f}", speed)));
    }
    SetHollow(by_volume ? 1 : 2);
    Set("enable_dynamic_overhang_speeds", "0");
    Set("max_volumetric_speed", "0");
    Set("filament_max_volumetric_speed", "0");
    AddTower(floors, by_volume ? LongTower(floors) : FlatWallTower(floors), std::move(ranges));
    return absl::OkStatus();
  }

  void PlanFlow() {
    constexpr double kPercent = 100;
    const double multiplier = NumberIn(given_, "extrusion_multiplier", 1);
    const double ratio = NumberIn(given_, "top_solid_infill_flow_ratio", 1);
    Set("top_solid_layers", "5");
    Set("bottom_solid_layers", "3");
    Set("top_fill_pattern", "monotonic");
    for (const double level : levels_) {
      const double factor = 1 + level / kPercent;
      const std::string label = LabelOf(info_, level);
      std::string name = "flow " + label;
      plan_.table.rows.push_back({label, multiplier * factor, 0, 0, name});
      plan_.parts.push_back(
          {std::move(name),
           FlowPlate(label),
           {},
           {RequestOf("top_solid_infill_flow_ratio", NumberText(ratio * factor))}});
    }
  }

  /// Returns the section of the filament's flow in an outer wall: a rectangle with round ends,
  /// times the flow.
  double BeadMm2() const {
    const double height = NumberIn(given_, "layer_height", 0.2);
    const double nozzle = NumberIn(given_, "nozzle_diameter", 0.4);
    double width = NumberIn(given_, "external_perimeter_extrusion_width", 0);
    if (width <= height) width = kUsualWidth * nozzle;
    return SectionMm2(FromMm(width), FromMm(height)) * NumberIn(given_, "extrusion_multiplier", 1);
  }

  absl::Status CheckSpeed(double speed) const {
    for (const char* key : {"machine_max_feedrate_x", "machine_max_feedrate_y"}) {
      const double limit = NumberIn(given_, key, 0);
      if (limit <= 0 || speed <= limit) continue;
      return MakeError(
          absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
          fmt::format("calibrate {}: the last value needs {:.1f} mm/s, which is above {} = {:g}; "
                      "choose a lower --end",
                      info_.name, speed, key, limit),
          {{"setting", key}, {"limit", NumberText(limit)}, {"got", NumberText(speed)}});
    }
    return absl::OkStatus();
  }

  const CalibrationInfo& info_;
  const CalibrationMethod method_;
  const std::vector<double>& levels_;
  const std::string_view given_;
  CalibrationPlan plan_;
};

}  // namespace

std::string_view TextIn(std::string_view settings_text, std::string_view key) {
  constexpr std::string_view kEquals = " = ";
  for (const std::string_view line : Split(settings_text, "\n"))
    if (line.starts_with(key) && line.substr(key.size()).starts_with(kEquals))
      return line.substr(key.size() + kEquals.size());
  return "";
}

double NumberIn(std::string_view settings_text, std::string_view key, double otherwise) {
  const std::string_view text = TextIn(settings_text, key);
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  return read.ec == std::errc() ? number : otherwise;
}

absl::StatusOr<CalibrationPlan> PlanCalibration(CalibrationKind kind,
                                                const std::vector<double>& levels,
                                                std::string_view settings_text,
                                                CalibrationMethod method) {
  return CalibrationPlanner(kind, method, levels, settings_text).Run();
}

}  // namespace slicefarm::cli
