#include "services/motion/algo/gcode/layer_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/base/portable_math.h"
#include "services/motion/algo/gcode/move_comment.h"
#include "services/motion/algo/toolpath/overhang.h"

namespace slicefarm::motion {
namespace {

/// A width comment is written if the width changes by at least this, on beads of at least
/// kSeenLengthUm. On shorter beads the change must be larger in proportion. A preview shows no
/// difference below this. For comparison, PrusaSlicer's beads of varying width change in steps of
/// 0.05 mm. The amount of filament is always exact.
constexpr int32_t kWidthStepUm = 50;
constexpr double kSeenLengthUm = 400;

bool IsSeen(int32_t width_change_um, double length_um) {
  return std::abs(width_change_um) * std::min(length_um, kSeenLengthUm) >=
         kWidthStepUm * kSeenLengthUm;
}

double LengthUm(const Toolpath& path, size_t index) {
  if (index == 0) return kSeenLengthUm;
  const Move &from = path.moves[index - 1], &to = path.moves[index];
  return Hypot(to.x_um - from.x_um, to.y_um - from.y_um);
}

/// Returns the time of a move at its full speed.
double TimeS(const Toolpath& path, size_t index) {
  const Move& to = path.moves[index];
  if (index == 0 || to.feed_rate <= 0) return 0;
  const Move& from = path.moves[index - 1];
  const double um = MovesInPlane(to.kind) ? Hypot(to.x_um - from.x_um, to.y_um - from.y_um)
                                          : std::abs(to.z_um - from.z_um);
  const double filament_um = std::abs(to.filament) * 1000.0 / kFilamentUnitsPerMm;
  return std::max(um, MovesInPlane(to.kind) ? 0 : filament_um) / kUmPerMm * 60 / to.feed_rate;
}

/// Returns the text of `out` from `begin` on as a mode line. Its value is the text itself.
ModeLine LineSince(size_t begin, MachineMode mode, const GcodeText& out) {
  std::string line = out.text().substr(begin);
  const auto size = std::ssize(line);
  return {static_cast<int64_t>(begin), size, mode, std::move(line)};
}

std::string PositionText(PointUm place) { return absl::StrCat(place.x, " ", place.y); }

}  // namespace

void LayerWriter::WriteLayerFan(GcodeText& out) {
  if (state_.fan_percent == kFanAsBefore) return;
  const size_t begin = out.text().size();
  if (state_.fan_limits.kickstart_s > 0 && state_.fan_is_off && state_.fan_percent > 0) {
    fan_ = FanCommand(state_.fan_limits, 0);
    fan_.Set(state_.fan_percent, out);
  } else {
    WriteFan(state_.fan_percent, out);
  }
  mode_lines_.push_back(LineSince(begin, MachineMode::kFan, out));
}

ModeValues LayerWriter::Modes() const {
  ModeValues values;
  const auto value = [&](MachineMode mode) -> std::string& {
    return values[static_cast<size_t>(mode)];
  };
  GcodeText text;
  if (fan_.percent() != kFanAsBefore) WriteFan(fan_.percent(), text);
  value(MachineMode::kFan) = text.Take();
  for (const auto& [mode, written] : {std::pair(MachineMode::kAcceleration, acceleration_),
                                      {MachineMode::kTravelAcceleration, travel_acceleration_}}) {
    GcodeText line;
    if (written != -1) WriteAcceleration(mode, written, line);
    value(mode) = line.Take();
  }
  if (jerk_ != -1) {
    GcodeText line;
    firmware_.WriteJerk(accelerations_.jerks.OfAxes(jerk_), line);
    value(MachineMode::kJerk) = line.Take();
  }
  if (at_) value(MachineMode::kPosition) = PositionText(*at_);
  return values;
}

void LayerWriter::Write(const Toolpath& path, size_t first, size_t last, ShiftUm shift,
                        GcodeText& out) {
  at_.reset();
  if (z_um_ == -1) z_um_ = path.start_z_um;
  auto arc = std::ranges::lower_bound(path.arcs, first, {}, &MoveArc::first);
  for (size_t i = first; i < last;) {
    if (arc != path.arcs.end() && arc->first == i) {
      WriteArc(path, *arc, shift, out);
      i = arc++->last;
    } else if (path.moves[i].if_needed) {
      WriteIfNeeded(path, i++, out);
    } else {
      WriteMove(path, i++, shift, out);
    }
  }
  WriteWipe(false, out);
  if (std::exchange(pulled_, false)) extruder_.Reset(out);
}

void LayerWriter::WriteWipe(bool wipes, GcodeText& out) {
  if (wipes == wipes_) return;
  wipes_ = wipes;
  out << (wipes ? firmware_.comments().wipe_start : firmware_.comments().wipe_end) << '\n';
}

void LayerWriter::WriteArc(const Toolpath& path, const MoveArc& arc, ShiftUm shift,
                           GcodeText& out) {
  const Move& from = path.moves[arc.first - 1];
  Move move = path.moves[arc.last - 1];
  move.filament = 0;
  for (size_t i = arc.first; i < arc.last; ++i) move.filament += path.moves[i].filament;
  Describe(move, kSeenLengthUm, FanAhead(path, arc.first), out);
  advance_.SetFor(path, arc.first, out);
  SetAcceleration(move, out);
  SetJerk(move, out);
  out << (arc.clockwise ? "G2 X" : "G3 X");
  out.Micrometers(move.x_um + shift.x) << " Y";
  out.Micrometers(move.y_um + shift.y) << " I";
  out.Micrometers(arc.centre.x - from.x_um) << " J";
  out.Micrometers(arc.centre.y - from.y_um);
  at_ = PointUm{move.x_um + shift.x, move.y_um + shift.y};
  WriteEnd(move, comments_ ? CommentOn(path, arc.first) : "", out);
  for (size_t i = arc.first; i < arc.last && fan_.IsKicking(); ++i) fan_.Pass(TimeS(path, i), out);
}

/// Writes the coordinates that have changed. This saves text: a coordinate is an eighth of a line.
void LayerWriter::WritePosition(PointUm to, GcodeText& out) {
  const bool stays = at_ == to;
  if (!at_ || stays || at_->x != to.x) (out << " X").Micrometers(to.x);
  if (!at_ || stays || at_->y != to.y) (out << " Y").Micrometers(to.y);
  at_ = to;
}

void LayerWriter::WriteEnd(const Move& move, std::string_view comment, GcodeText& out) {
  if (move.filament != 0) extruder_.Push(move.filament, out);
  FeedRate(move, out);
  if (comments_) out << " ; " << comment;
  out << '\n';
}

void LayerWriter::BeginBlock(GcodeText& out) {
  extruder_.Reset(out);
  feed_rate_.Forget();
  mix_.Forget();
  advance_.Forget();
  type_ = -1;
}

void LayerWriter::EndBlock(GcodeText& out) {
  extruder_.Reset(out);
  fan_.Set(state_.fan_percent, out);
  fan_.Finish(out);
  SetHeight(state_.height_um, out);
}

bool LayerWriter::HasBridgeFan(const Move& move) const {
  if (IsBridge(move.feature) || move.feature == Feature::kOverhangPerimeter) return true;
  // If the limit includes fully supported beads, only the outer walls get this fan speed.
  if (state_.cooled_rest >= kFullRest) return move.feature == Feature::kExternalPerimeter;
  return move.rest <= state_.cooled_rest;
}

/// Returns the fan speed that settings give to a feature, or -1.
int32_t LayerWriter::OwnFan(Feature feature) const {
  if (feature == Feature::kSupportInterface) return state_.line_fans.interface_percent;
  if (feature == Feature::kIroning) return state_.line_fans.ironing_percent;
  if (feature == Feature::kInternalBridge) return state_.line_fans.internal_bridge_percent;
  return -1;
}

int32_t LayerWriter::FanFor(const Move& move) const {
  if (const int32_t own = OwnFan(move.feature); own >= 0) return own;
  if (HasBridgeFan(move)) return state_.bridge_fan_percent;
  if (move.rest == kFullRest || !state_.overhang_fan_percent) return state_.fan_percent;
  return static_cast<int32_t>(
      std::lround(ByRest(*state_.overhang_fan_percent, state_.fan_percent, move.rest)));
}

/// Returns the fastest fan of the beads that follow within fan_early_s. As in OrcaSlicer, the time
/// is that of moves at full speed.
int32_t LayerWriter::FanAhead(const Toolpath& path, size_t index) const {
  if (state_.fan_early_s <= 0) return FanFor(path.moves[index]);
  int32_t percent = -1;
  double time_s = 0;
  for (size_t i = index; i < path.moves.size() && time_s <= state_.fan_early_s; ++i) {
    const Move& move = path.moves[i];
    const bool counts = i == index || state_.fan_early_all || HasBridgeFan(move);
    if (move.kind == MoveKind::kPrint && counts) percent = std::max(percent, FanFor(move));
    time_s += TimeS(path, i);
  }
  return percent;
}

void LayerWriter::SetHeight(int32_t height_um, GcodeText& out) {
  if (height_um == height_um_) return;
  height_um_ = height_um;
  out << firmware_.comments().height;
  out.Real(static_cast<double>(height_um) / kUmPerMm, 3) << '\n';
}

/// Restarts absolute numbers after a retraction, before the next move.
void LayerWriter::CountAnew(const Move& move, GcodeText& out) {
  const bool pulls = move.kind == MoveKind::kRetract || move.kind == MoveKind::kWipe;
  if (!pulls && pulled_) extruder_.Reset(out);
  pulled_ = pulls;
}

/// Writes a retraction or restart that needs no move: the firmware makes it itself (G10, G11), or a
/// change of colour has already primed the filament. Returns false if the move has to be written.
bool LayerWriter::WriteByFirmware(const Move& move, GcodeText& out) {
  const bool restarts = move.kind == MoveKind::kRestart;
  if (restarts && std::exchange(primed_, false)) return true;
  if (move.kind == MoveKind::kRetract || move.kind == MoveKind::kPrint) primed_ = false;
  if (!extruder_.by_firmware() || !(restarts || move.kind == MoveKind::kRetract)) return false;
  out << (restarts ? "G11" : "G10");
  if (comments_) out << (restarts ? " ; unretract" : " ; retract");
  out << '\n';
  return true;
}

void LayerWriter::WriteMove(const Toolpath& path, size_t index, ShiftUm shift, GcodeText& out) {
  const Move& move = path.moves[index];
  CountAnew(move, out);
  if (move.kind != MoveKind::kPrint && state_.fan_early_s > 0)
    SetFan(std::max(fan_.percent(), FanAhead(path, index)), out);
  if (move.kind == MoveKind::kPrint) {
    Describe(move, LengthUm(path, index), FanAhead(path, index), out);
    advance_.SetFor(path, index, out);
    const auto mm = [](int32_t um) { return static_cast<double>(um) / kUmPerMm; };
    mix_.SetFor({mm(move.x_um + shift.x + state_.to_plate.x),
                 mm(move.y_um + shift.y + state_.to_plate.y), mm(move.z_um)},
                out);
  }
  WriteWipe(move.kind == MoveKind::kWipe, out);
  if (WriteByFirmware(move, out)) return;
  const bool climbs =
      (move.kind == MoveKind::kPrint || move.kind == MoveKind::kTravel) && move.z_um != z_um_;
  SetAcceleration(move, out);
  SetJerk(move, out);
  const size_t begin = out.text().size();
  out << "G1";
  if (MovesInPlane(move.kind)) WritePosition({move.x_um + shift.x, move.y_um + shift.y}, out);
  if (move.kind == MoveKind::kLift || climbs) {
    out << " Z";
    out.Micrometers(move.z_um);
    z_um_ = move.z_um;
  }
  WriteEnd(move, comments_ ? CommentOn(path, index) : "", out);
  if (fan_.IsKicking()) fan_.Pass(TimeS(path, index), out);
  if (!MovesInPlane(move.kind) || std::exchange(approached_, true)) return;
  if (move.kind != MoveKind::kTravel || climbs) return;
  mode_lines_.push_back(LineSince(begin, MachineMode::kPosition, out));
  mode_lines_.back().value = PositionText(*at_);
}

/// Writes a line that may be removed later, so the text before and after it does not depend on it.
void LayerWriter::WriteIfNeeded(const Toolpath& path, size_t index, GcodeText& out) {
  const size_t begin = out.text().size();
  WriteMove(path, index, {}, out);
  extruder_.Reset(out);
  pulled_ = false;
  feed_rate_.Forget();
  const bool retracts = path.moves[index].kind == MoveKind::kRetract;
  mode_lines_.push_back(LineSince(begin, MachineMode::kFilament, out));
  mode_lines_.back().value = retracts ? kRetracted : kReady;
}

void LayerWriter::FeedRate(const Move& move, GcodeText& out) {
  if (feed_rate_.Changes(move.feed_rate)) (out << " F").Integer(move.feed_rate);
}

/// Writes the G-code before the first bead of another feature.
void LayerWriter::WriteRole(Feature feature, GcodeText& out) {
  const auto role = static_cast<int32_t>(feature);
  const int32_t before = std::exchange(role_, role);
  if (state_.roles == nullptr || role == before) return;
  const auto text = state_.roles->find({before, role});
  if (text == state_.roles->end()) return;
  out.Lines(text->second);
  Forget();
  at_.reset();
}

void LayerWriter::Describe(const Move& move, double length_um, int32_t fan_percent,
                           GcodeText& out) {
  const auto type = static_cast<int32_t>(move.feature);
  if (type != type_) {
    WriteRole(move.feature, out);
    type_ = type;
    width_um_ = -1;
    out << firmware_.comments().feature << firmware_.WordsOf(move.feature) << '\n';
  }
  SetFan(fan_percent, out);
  if (width_um_ == -1 || IsSeen(move.width_um - width_um_, length_um)) {
    width_um_ = move.width_um;
    out << firmware_.comments().width;
    out.Real(static_cast<double>(move.width_um) / kUmPerMm, 3) << '\n';
  }
  SetHeight(move.height_um, out);
}

void LayerWriter::SetAcceleration(const Move& move, GcodeText& out) {
  if (!accelerations_.written) return;
  const bool of_travel = move.kind == MoveKind::kTravel || move.kind == MoveKind::kLift;
  if (of_travel && !accelerations_.travel_written) return;
  if (of_travel && firmware_.HasTravelAcceleration()) {
    SetAcceleration(MachineMode::kTravelAcceleration, move.acceleration_mm_s2, travel_acceleration_,
                    out);
  } else if (of_travel || move.kind == MoveKind::kPrint) {
    SetAcceleration(MachineMode::kAcceleration, move.acceleration_mm_s2, acceleration_, out);
  }
}

void LayerWriter::SetAcceleration(MachineMode mode, float value, float& written, GcodeText& out) {
  const float before = std::exchange(written, value);
  if (before == value) return;
  const size_t begin = out.text().size();
  WriteAcceleration(mode, value, out);
  if (before == -1) mode_lines_.push_back(LineSince(begin, mode, out));
}

void LayerWriter::WriteAcceleration(MachineMode mode, float value, GcodeText& out) const {
  const bool of_travel = mode == MachineMode::kTravelAcceleration;
  if (accelerations_.to_decel > 0)
    return firmware_.WriteAccelToDecel(value, value * accelerations_.to_decel, out);
  firmware_.WriteAcceleration(of_travel ? 0 : value, of_travel ? value : 0, out);
}

/// Writes the jerk of beads and, if they have their own, of travels.
void LayerWriter::SetJerk(const Move& move, GcodeText& out) {
  const Jerks& jerks = accelerations_.jerks;
  const bool of_travel = move.kind == MoveKind::kTravel || move.kind == MoveKind::kLift;
  const bool sets = move.kind == MoveKind::kPrint || (of_travel && jerks.travel > 0);
  if (!jerks.written || !sets || move.jerk_mm_s == jerk_) return;
  const size_t begin = out.text().size();
  firmware_.WriteJerk(jerks.OfAxes(move.jerk_mm_s), out);
  if (std::exchange(jerk_, move.jerk_mm_s) == -1)
    mode_lines_.push_back(LineSince(begin, MachineMode::kJerk, out));
}

}  // namespace slicefarm::motion
