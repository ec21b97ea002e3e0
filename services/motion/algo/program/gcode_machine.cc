#include "services/motion/algo/program/gcode_machine.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/base/portable_math.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::motion {
namespace {

constexpr char kWords[] = {'X', 'Y', 'Z', 'E'};
constexpr double kInchMm = 25.4;
/// Speed before the first F, as in Klipper.
constexpr double kFirstSpeedMmS = 25;
/// Largest remainder of a sum that does not move an axis.
constexpr double kNothingMm = 1e-9;
constexpr double kSecondsPerMinute = 60;

/// Returns true if a G10 sets values of a tool (RepRapFirmware). A G10 that retracts has no word
/// except Marlin's S.
bool HasOtherWords(const GcodeLine& line) {
  return line.Has('P') || line.Has('L') || line.Has('R') || line.Has('X') || line.Has('Y') ||
         line.Has('Z');
}

GcodeAction Rest() { return {.kind = GcodeAction::Kind::kRest}; }

}  // namespace

GcodeAction GcodeMachine::Read(const GcodeLine& line) {
  moves_.clear();
  if (line.command.empty() || !line.fault.empty()) return {};
  if (line.letter == 'G') return ReadG(line);
  if (line.letter == 'M') return ReadM(line);
  if (line.letter == 'T') return Rest();
  firmware_.ApplyLimits(line, limits_);
  return {.kind = GcodeAction::Kind::kLimits};
}

void GcodeMachine::Resume(const std::array<double, 3>& position_mm, double speed_mm_s,
                          double acceleration_mm_s2) {
  std::ranges::copy(position_mm, at_.begin());
  speed_mm_s_ = speed_mm_s;
  limits_.max_acceleration_extruding_mm_s2 = acceleration_mm_s2;
}

GcodeAction GcodeMachine::ReadG(const GcodeLine& line) {
  switch (line.number) {
    case 0:
    case 1:
      return MoveTo(line);
    case 2:
    case 3:
      return ArcTo(line);
    case 4:
      return {.kind = GcodeAction::Kind::kDwell,
              .dwell_s = std::max(0.0, line['P'].value_or(0) / 1000 + line['S'].value_or(0))};
    case 10:
      return IsFirmwareRetraction(line) ? Retract(/*back=*/false) : GcodeAction{};
    case 11:
      return Retract(/*back=*/true);
    case 20:
      unit_mm_ = kInchMm;
      return {};
    case 21:
      unit_mm_ = 1;
      return {};
    case 28:
      Home(line);
      return Rest();
    case 90:
    case 91:
      relative_ = line.number == 91;
      if (firmware_.extruder_mode() == ExtruderMode::kWithAxes) relative_filament_ = relative_;
      return {};
    case 92:
      SetPosition(line);
      return {};
    default:
      return line.number >= 29 && line.number <= 38 ? Rest() : GcodeAction{};
  }
}

GcodeAction GcodeMachine::ReadM(const GcodeLine& line) {
  switch (line.number) {
    case 82:
    case 83:
      relative_filament_ = line.number == 83;
      return {};
    case 0:
    case 1:
    case 25:
    case 109:
    case 116:
    case 190:
    case 191:
    case 226:
    case 400:
    case 600:
    case 601:
    case 701:
    case 702:
      return Rest();
    case 200:
      // D is the diameter of the filament, and E is then a volume; D0: E is a length again.
      if (const auto d = line['D']) ScaleFilament(flow_factor_, FilamentUnitMm(*d));
      return {};
    case 207:
      retraction_.length_mm = line['S'].value_or(retraction_.length_mm);
      retraction_.lift_mm = line['Z'].value_or(retraction_.lift_mm);
      if (const auto f = line['F']; f && *f > 0) {
        retraction_.speed_mm_s = *f / kSecondsPerMinute;
        retraction_.restart_speed_mm_s = retraction_.speed_mm_s;
      }
      return {};
    case 208:
      retraction_.restart_extra_mm = line['S'].value_or(retraction_.restart_extra_mm);
      if (const auto f = line['F']; f && *f > 0)
        retraction_.restart_speed_mm_s = *f / kSecondsPerMinute;
      return {};
    case 220:
      if (const auto s = line['S']; s && *s > 0) speed_factor_ = *s / 100;
      return {};
    case 221:
      if (const auto s = line['S']; s && *s > 0) ScaleFilament(*s / 100, filament_unit_mm_);
      return {};
    default:
      firmware_.ApplyLimits(line, limits_);
      return {.kind = GcodeAction::Kind::kLimits};
  }
}

bool GcodeMachine::RelativeFilament() const {
  return relative_filament_ ||
         (relative_ && firmware_.extruder_mode() == ExtruderMode::kEitherWise);
}

std::array<double, 4> GcodeMachine::TargetOf(const GcodeLine& line) const {
  std::array<double, 4> to = at_;
  for (size_t axis = 0; axis < to.size(); ++axis) {
    const auto word = line[kWords[axis]];
    if (!word) continue;
    const double factor = axis == kE ? FilamentFactor() : 1;
    const double given = *word * unit_mm_ * factor;
    const bool relative = axis == kE ? RelativeFilament() : relative_;
    to[axis] = given + (relative ? at_[axis] : origin_[axis]);
  }
  return to;
}

void GcodeMachine::Push(const std::array<double, 4>& to, double speed_mm_s) {
  const ProgramMove move = {at_, to, speed_mm_s};
  at_ = to;
  const double x = to[kX] - move.from[kX], y = to[kY] - move.from[kY], z = to[kZ] - move.from[kZ];
  const bool moves = std::sqrt(x * x + y * y + z * z) > kNothingMm;
  if (moves || std::abs(move.Filament()) > kNothingMm) moves_.push_back(move);
}

void GcodeMachine::ReadSpeed(const GcodeLine& line) {
  if (const auto f = line['F']; f && *f > 0) speed_mm_s_ = *f * unit_mm_ / kSecondsPerMinute;
}

GcodeAction GcodeMachine::MoveTo(const GcodeLine& line) {
  ReadSpeed(line);
  Push(TargetOf(line), (has_speed() ? speed_mm_s_ : kFirstSpeedMmS) * speed_factor_);
  return {.kind = GcodeAction::Kind::kMoves, .moves = moves_};
}

GcodeAction GcodeMachine::ArcTo(const GcodeLine& line) {
  ReadSpeed(line);
  const std::array<double, 4> start = at_, to = TargetOf(line);
  const double speed = (has_speed() ? speed_mm_s_ : kFirstSpeedMmS) * speed_factor_;
  Arc arc;
  arc.from = {start[kX], start[kY]};
  arc.to = {to[kX], to[kY]};
  arc.clockwise = line.number == 2;
  if (const auto radius = line['R']) {
    arc.centre = arc.from == arc.to
                     ? arc.from
                     : CentreByRadius(arc.from, arc.to, *radius * unit_mm_, arc.clockwise);
  } else {
    arc.centre = {start[kX] + line['I'].value_or(0) * unit_mm_,
                  start[kY] + line['J'].value_or(0) * unit_mm_};
  }
  const double radius = arc.StartRadius();
  const double rise = to[kZ] - start[kZ];
  const double length = Hypot(radius * arc.Angle(), rise);
  const double chord =
      arc_segment_mm_ > 0 ? arc_segment_mm_ : firmware_.ArcSegmentMm(radius, speed);
  const std::vector<Vector2> ends = ArcChords(arc, length, chord);
  const auto count = static_cast<double>(ends.size());
  for (size_t i = 0; i < ends.size(); ++i) {
    const double share = static_cast<double>(i + 1) / count;
    const bool last = i + 1 == ends.size();
    Push({ends[i].x(), ends[i].y(), last ? to[kZ] : start[kZ] + share * rise,
          last ? to[kE] : start[kE] + share * (to[kE] - start[kE])},
         speed);
  }
  return {.kind = GcodeAction::Kind::kMoves, .moves = moves_, .arc = arc};
}

GcodeAction GcodeMachine::Retract(bool back) {
  if (retracted_ != back || retraction_.length_mm <= 0) return {};
  retracted_ = !back;
  std::array<double, 4> to = at_;
  const double lift = retraction_.lift_mm;
  if (back) {
    to[kZ] -= lift;
    if (lift > 0) Push(to, limits_.max_feedrate_mm_s[kZ]);
    to[kE] += retraction_.length_mm + retraction_.restart_extra_mm;
    Push(to, retraction_.restart_speed_mm_s);
  } else {
    to[kE] -= retraction_.length_mm;
    Push(to, retraction_.speed_mm_s);
    to[kZ] += lift;
    if (lift > 0) Push(to, limits_.max_feedrate_mm_s[kZ]);
  }
  // Only the machine retracts: the program's own E and Z do not change.
  const double moved = moves_.empty() ? 0 : to[kE] - moves_.front().from[kE];
  origin_[kE] += moved;
  origin_[kZ] += back ? -lift : lift;
  return {.kind = GcodeAction::Kind::kMoves, .moves = moves_};
}

void GcodeMachine::Home(const GcodeLine& line) {
  const bool all = !line.Has('X') && !line.Has('Y') && !line.Has('Z');
  for (size_t axis = kX; axis <= kZ; ++axis) {
    if (!all && !line.Has(kWords[axis])) continue;
    at_[axis] = 0;
    origin_[axis] = 0;
  }
}

void GcodeMachine::SetPosition(const GcodeLine& line) {
  const bool all = !line.Has('X') && !line.Has('Y') && !line.Has('Z') && !line.Has('E');
  for (size_t axis = 0; axis < at_.size(); ++axis) {
    if (!all && !line[kWords[axis]]) continue;
    const double factor = axis == kE ? FilamentFactor() : 1;
    origin_[axis] = at_[axis] - line[kWords[axis]].value_or(0) * unit_mm_ * factor;
  }
}

double GcodeMachine::FilamentUnitMm(double diameter_mm) {
  return diameter_mm > 0 ? 4 / (std::numbers::pi * diameter_mm * diameter_mm) : 1;
}

MachineSetup SetupOf(const MotionOptions& options) {
  return {options.limits,
          options.tool().retraction,
          {options.nozzle_heating_c_s, options.bed_heating_c_s},
          options.writing.volumetric_e ? options.tool().filament_diameter_mm : 0};
}

/// Changes the scale of E. The value of E in the program does not change.
void GcodeMachine::ScaleFilament(double flow, double unit_mm) {
  const double value = (at_[kE] - origin_[kE]) / FilamentFactor();
  flow_factor_ = flow;
  filament_unit_mm_ = unit_mm;
  origin_[kE] = at_[kE] - value * FilamentFactor();
}

bool IsFirmwareRetraction(const GcodeLine& line) {
  return line.Is('G', 11) || (line.Is('G', 10) && !HasOtherWords(line));
}

KinematicMove ToKinematic(const ProgramMove& move, const Firmware& firmware,
                          const MachineLimits& limits) {
  KinematicMove result;
  double change[4];
  for (size_t axis = 0; axis < 4; ++axis) change[axis] = move.to[axis] - move.from[axis];
  double length =
      std::sqrt(change[kX] * change[kX] + change[kY] * change[kY] + change[kZ] * change[kZ]);
  if (length <= kNothingMm) {
    change[kX] = change[kY] = change[kZ] = 0;
    length = std::abs(change[kE]);
  }
  result.length_mm = length;
  for (size_t axis = 0; axis < 4; ++axis) result.ratio[axis] = change[axis] / length;
  result.speed_mm_s = move.speed_mm_s;
  result.acceleration_mm_s2 = firmware.AccelerationFor(result, limits);
  return result;
}

}  // namespace slicefarm::motion
