#include "services/motion/algo/firmware/klipper.h"

#include <algorithm>
#include <array>

#include "common/geometry/measure.h"
#include "common/kinematics/klipper_planner.h"
#include "services/motion/algo/firmware/known_commands.h"
#include "services/motion/algo/firmware/limit_command.h"

namespace slicefarm::motion {
namespace {

constexpr int kKlipperG[] = {0, 1, 2, 3, 4, 10, 11, 17, 18, 19, 20, 21, 28, 90, 91, 92};
constexpr int kKlipperM[] = {18,  20,  21,  23,  24,  25,  26,  27,  73,  82,
                             83,  84,  104, 105, 106, 107, 109, 110, 112, 114,
                             115, 117, 118, 119, 140, 190, 204, 220, 221, 400};
constexpr KnownCommands kKlipperCommands{kKlipperG, kKlipperM};

/// Klipper's named commands that slicers and start G-code use. Any other name counts as a macro.
constexpr std::string_view kNamed[] = {"ACTIVATE_EXTRUDER",
                                       "BED_MESH_CALIBRATE",
                                       "BED_MESH_CLEAR",
                                       "BED_MESH_PROFILE",
                                       "CANCEL_PRINT",
                                       "CLEAR_PAUSE",
                                       "EXCLUDE_OBJECT",
                                       "EXCLUDE_OBJECT_DEFINE",
                                       "EXCLUDE_OBJECT_END",
                                       "EXCLUDE_OBJECT_START",
                                       "FIRMWARE_RESTART",
                                       "FORCE_MOVE",
                                       "PAUSE",
                                       "QUAD_GANTRY_LEVEL",
                                       "RESPOND",
                                       "RESTORE_GCODE_STATE",
                                       "RESUME",
                                       "SAVE_GCODE_STATE",
                                       "SET_DISPLAY_TEXT",
                                       "SET_FAN_SPEED",
                                       "SET_GCODE_OFFSET",
                                       "SET_HEATER_TEMPERATURE",
                                       "SET_INPUT_SHAPER",
                                       "SET_LED",
                                       "SET_PIN",
                                       "SET_PRESSURE_ADVANCE",
                                       "SET_PRINT_STATS_INFO",
                                       "SET_RETRACTION",
                                       "SET_TEMPERATURE_FAN_TARGET",
                                       "SET_VELOCITY_LIMIT",
                                       "STATUS",
                                       "TEMPERATURE_WAIT",
                                       "TURN_OFF_HEATERS",
                                       "TUNING_TOWER",
                                       "Z_TILT_ADJUST"};

/// Klipper's defaults: [gcode_arcs] resolution, [extruder] max_extrude_only_distance and
/// max_extrude_cross_section.
constexpr double kKlipperArcSegmentMm = 1;
constexpr double kLongestExtrusionMm = 50;
constexpr double kMostSectionsOfNozzle = 4;

/// Replaces the characters at which Klipper splits parameters: blanks, quotes and comment signs.
std::string WithoutSpecials(std::string name) {
  constexpr std::string_view kSpecial = " \"#%&'*-./:;<>\\=[]{}|";
  std::ranges::replace_if(
      name, [&](char c) { return kSpecial.find(c) != kSpecial.npos; }, '_');
  return name;
}

Point Middle(const Polygon& hull) {
  const Box box = Bounds(hull);
  return {box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
}

void WritePoint(Point point, std::string_view between, GcodeText& out) {
  out.Real(ToMm(static_cast<double>(point.x)), 3) << between;
  out.Real(ToMm(static_cast<double>(point.y)), 3);
}

void DefineCopy(const CopySummary& copy, const std::string& label, GcodeText& out) {
  out << "EXCLUDE_OBJECT_DEFINE NAME=" << label;
  if (!copy.footprint.empty()) {
    out << " CENTER=";
    WritePoint(Middle(copy.footprint), ",", out);
    out << " POLYGON=";
    std::string_view before = "[[";
    for (const Point corner : copy.footprint) {
      out << before;
      WritePoint(corner, ",", out);
      before = "],[";
    }
    out << "]]";
  }
  out << '\n';
}

/// Reads MINIMUM_CRUISE_RATIO, or its older form ACCEL_TO_DECEL, which is the acceleration of moves
/// without a cruise.
void ReadCruiseRatio(const GcodeLine& line, MachineLimits& limits) {
  auto ratio = line.NamedNumber("MINIMUM_CRUISE_RATIO");
  const auto to_decel = line.NamedNumber("ACCEL_TO_DECEL");
  const double accel = limits.max_acceleration_extruding_mm_s2;
  if (!ratio && to_decel && *to_decel > 0 && accel > 0)
    ratio = 1 - std::min(1.0, *to_decel / accel);
  if (ratio && *ratio >= 0 && *ratio < 1) limits.minimum_cruise_ratio = *ratio;
}

class KlipperFirmware : public Firmware {
 public:
  std::string_view name() const override { return "klipper"; }

  std::unique_ptr<Planner> MakePlanner(const MachineLimits& limits) const override {
    return std::make_unique<KlipperPlanner>(limits);
  }
  double AccelerationFor(const KinematicMove& /*move*/,
                         const MachineLimits& limits) const override {
    return AccelerationOr(limits.max_acceleration_extruding_mm_s2, 0);
  }
  bool StopsForFilament() const override { return true; }
  double ArcSegmentMm(double /*radius_mm*/, double /*speed_mm_s*/) const override {
    return kKlipperArcSegmentMm;
  }

  ExtruderMode extruder_mode() const override { return ExtruderMode::kEitherWise; }
  bool Knows(const GcodeLine& line) const override {
    if (line.letter != 0) return kKlipperCommands.Contain(line);
    std::string upper(line.command);
    std::ranges::transform(upper, upper.begin(), [](char c) {
      return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    });
    return std::ranges::find(kNamed, upper) != std::end(kNamed);
  }
  bool has_macros() const override { return true; }
  bool RefusesSection(double section_mm2, double nozzle_mm) const override {
    return section_mm2 > kMostSectionsOfNozzle * nozzle_mm * nozzle_mm;
  }
  double LongestExtrusionMm() const override { return kLongestExtrusionMm; }
  bool ArcsByRadius() const override { return false; }
  bool RelativeArcs() const override { return false; }

  void ApplyLimits(const GcodeLine& line, MachineLimits& limits) const override {
    if (line.Is('M', 204)) {
      std::optional<double> asked = line['S'];
      if (!asked && line['P'] && line['T']) asked = std::min(*line['P'], *line['T']);
      ReadLimit(asked, limits.max_acceleration_extruding_mm_s2);
    } else if (line.command == "SET_VELOCITY_LIMIT") {
      ReadLimit(line.NamedNumber("VELOCITY"), limits.max_feedrate_mm_s[kX]);
      ReadLimit(line.NamedNumber("VELOCITY"), limits.max_feedrate_mm_s[kY]);
      ReadLimit(line.NamedNumber("ACCEL"), limits.max_acceleration_extruding_mm_s2);
      if (const auto corner = line.NamedNumber("SQUARE_CORNER_VELOCITY"); corner && *corner >= 0)
        limits.square_corner_velocity_mm_s = *corner;
      ReadCruiseRatio(line, limits);
    }
  }

  void WriteLimits(const MachineLimits& limits, GcodeText& out) const override {
    LimitCommand("SET_VELOCITY_LIMIT", out)
        .Set("VELOCITY=", std::min(limits.max_feedrate_mm_s[kX], limits.max_feedrate_mm_s[kY]))
        .Set("ACCEL=", limits.max_acceleration_extruding_mm_s2)
        .Set("SQUARE_CORNER_VELOCITY=", limits.square_corner_velocity_mm_s);
  }
  bool HasTravelAcceleration() const override { return false; }
  bool HasRetractAcceleration() const override { return false; }
  void WriteAcceleration(double print_mm_s2, double /*travel_mm_s2*/,
                         GcodeText& out) const override {
    WriteM204(print_mm_s2, out);
  }

  /// Writes ACCEL_TO_DECEL, which versions before 2024 need with each acceleration.
  void WriteAccelToDecel(double print_mm_s2, double to_decel_mm_s2, GcodeText& out) const override {
    LimitCommand("SET_VELOCITY_LIMIT", out)
        .Set("ACCEL=", print_mm_s2)
        .Set("ACCEL_TO_DECEL=", to_decel_mm_s2);
  }
  void WriteCruiseRatio(double ratio, GcodeText& out) const override {
    LimitCommand("SET_VELOCITY_LIMIT", out).SetEven0("MINIMUM_CRUISE_RATIO=", ratio);
  }
  void WriteJerk(std::span<const double, 4> jerk_mm_s, GcodeText& out) const override {
    LimitCommand("SET_VELOCITY_LIMIT", out).Set("SQUARE_CORNER_VELOCITY=", jerk_mm_s[kX]);
  }

  void WritePressureAdvance(double value, GcodeText& out) const override {
    out << "SET_PRESSURE_ADVANCE ADVANCE=";
    out.Real(value, 5) << '\n';
  }

  std::string LabelOf(std::string_view name, size_t index) const override {
    return WithoutSpecials(std::string(name)) + "-" + std::to_string(index);
  }
  void DefineCopies(std::span<const CopySummary> copies, std::span<const std::string> labels,
                    GcodeText& out) const override {
    for (size_t i = 0; i < copies.size(); ++i) DefineCopy(copies[i], labels[i], out);
  }
  void BeginCopy(std::string_view label, size_t /*index*/, GcodeText& out) const override {
    out << "EXCLUDE_OBJECT_START NAME=" << label << '\n';
  }
  void EndCopy(std::string_view label, size_t /*index*/, GcodeText& out) const override {
    out << "EXCLUDE_OBJECT_END NAME=" << label << '\n';
  }
};

}  // namespace

const Firmware& Klipper() {
  static const KlipperFirmware firmware;
  return firmware;
}

}  // namespace slicefarm::motion
