#include "services/motion/algo/program/print_clock.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/gcode/gcode_text.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/toolpath/edge_moves.h"
#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {
namespace {

/// Returns the acceleration that the layer's own times use for moves before its first bead.
double AssumedBy(const LayerEdges& edges) {
  for (size_t i = 1; i < edges.head.size(); ++i)
    if (Prints(edges.head[i - 1], edges.head[i])) return edges.head[i].acceleration_mm_s2;
  return edges.acceleration_mm_s2;
}

int32_t Um(double mm) { return static_cast<int32_t>(std::lround(mm * kUmPerMm)); }

}  // namespace

PrintClock::PrintClock(const ProgramSummary& summary, const MotionOptions& options)
    : summary_(summary),
      firmware_(FirmwareOf(options.flavor)),
      machine_(firmware_, SetupOf(options)),
      heat_({options.nozzle_heating_c_s, options.bed_heating_c_s}),
      planner_(firmware_.MakePlanner(options.limits)) {
  const ProgramStats& total = summary.total;
  for (size_t i = 0; i < times_.feature_s.size(); ++i)
    times_.feature_s[i] = total.features[i].time_s;
  times_.retract_s = total.retract_time_s;
  times_.travel_s = total.travel_time_s - total.retract_time_s;
  for (const LayerSummary& layer : summary.layers) times_.layer_s.push_back(layer.time_s);
  for (const CopySummary& copy : summary.copies) times_.copy_s.push_back(copy.use.time_s);
}

void PrintClock::Read(std::string_view gcode, double& part_s) {
  Resume();
  while (!gcode.empty()) {
    const size_t end = std::min(gcode.find('\n'), gcode.size());
    ReadLine(gcode.substr(0, end), part_s);
    gcode.remove_prefix(std::min(end + 1, gcode.size()));
  }
  const auto& place = machine_.position();
  at_ = {.x_um = Um(place[kX]), .y_um = Um(place[kY]), .z_um = Um(place[kZ])};
  set_mm_s2_ = firmware_.AccelerationFor({1, {1, 0, 0, 0}}, machine_.limits());
}

/// Sets the machine to the state after the last moves, before more text is read.
void PrintClock::Resume() {
  if (set_mm_s2_ == 0) return;
  machine_.Resume(
      {at_.x_um / static_cast<double>(kUmPerMm), at_.y_um / static_cast<double>(kUmPerMm),
       at_.z_um / static_cast<double>(kUmPerMm)},
      SpeedOf(at_.feed_rate), set_mm_s2_);
}

void PrintClock::ReadLine(std::string_view text, double& part_s) {
  const GcodeLine line = ParseGcodeLine(text);
  const GcodeAction action = machine_.Read(line);
  switch (action.kind) {
    case GcodeAction::Kind::kMoves:
      for (const ProgramMove& move : action.moves) {
        double& kind_s = move.Prints()    ? times_.custom_s
                         : move.InSpace() ? times_.travel_s
                                          : times_.retract_s;
        accounts_.push_back({&kind_s, &part_s, CopySum(kNoCopy)});
        planner_->Add(motion::ToKinematic(move, firmware_, machine_.limits()));
      }
      break;
    case GcodeAction::Kind::kDwell:
      Stop();
      times_.dwell_s += action.dwell_s;
      part_s += action.dwell_s;
      break;
    case GcodeAction::Kind::kRest:
      Stop();
      Rest(line, part_s);
      break;
    case GcodeAction::Kind::kLimits:
      planner_->SetLimits(machine_.limits());
      heat_.Read(line, times_.TotalS());
      break;
    case GcodeAction::Kind::kNone:
      break;
  }
}

void PrintClock::Rest(const GcodeLine& line, double& part_s) {
  if (line.letter == 'T') ++times_.tool_changes;
  if (line.letter == 'G') ++times_.homings;
  const auto wait_s = heat_.Read(line, times_.TotalS());
  if (!wait_s) ++times_.heat_waits;
  times_.heating_s += wait_s.value_or(0);
  part_s += wait_s.value_or(0);
}

void PrintClock::AddLayer(size_t i) {
  const LayerEdges& edges = summary_.layers[i].edges;
  if (summary_.layers[i].empty || edges.head.empty() || edges.tail.empty()) return;
  double& part_s = times_.layer_s[i];
  QueueHead(edges, part_s);
  Stop();
  // Subtracts the times of the moves at both ends, which the layer has planned from a standstill.
  const std::span<const EdgeMove> head = edges.head;
  const auto approach = static_cast<size_t>(edges.approach);
  Queue(head.first(approach), AssumedBy(edges), part_s);
  Stop(-1);
  Queue(head.subspan(approach), AssumedBy(edges), part_s);
  Stop(-1);
  Queue(edges.tail, edges.acceleration_mm_s2, part_s);
  Stop(-1);
  Queue(edges.tail, edges.acceleration_mm_s2, part_s);
  at_ = edges.tail.back();
  set_mm_s2_ = edges.acceleration_mm_s2;
}

double* PrintClock::CopySum(int32_t copy) {
  const auto index = static_cast<size_t>(copy);
  return copy >= 0 && index < times_.copy_s.size() ? &times_.copy_s[index] : &shared_s_;
}

void PrintClock::QueueHead(const LayerEdges& edges, double& part_s) {
  const auto approach = static_cast<size_t>(edges.approach);
  // The travel to the layer belongs to a copy only if it begins in the same copy.
  const int32_t left = at_.copy;
  for (size_t i = 1; i < edges.head.size(); ++i) {
    EdgeMove move = edges.head[i];
    if (i <= approach && move.copy != left) move.copy = kNoCopy;
    if (i < approach) {
      move.x_um = at_.x_um;
      move.y_um = at_.y_um;
    }
    Queue(at_, move, set_mm_s2_, part_s);
    at_ = move;
  }
}

void PrintClock::Queue(std::span<const EdgeMove> travel, double set_mm_s2, double& part_s) {
  for (size_t i = 1; i < travel.size(); ++i) Queue(travel[i - 1], travel[i], set_mm_s2, part_s);
}

void PrintClock::Queue(const EdgeMove& before, const EdgeMove& move, double set_mm_s2,
                       double& part_s) {
  const auto kinematic = motion::ToKinematic(before, move, set_mm_s2);
  if (!kinematic) return;
  double& kind_s = Prints(before, move)        ? times_.feature_s[static_cast<size_t>(move.feature)]
                   : kinematic->ExtruderOnly() ? times_.retract_s
                                               : times_.travel_s;
  accounts_.push_back({&kind_s, &part_s, CopySum(move.copy)});
  if (move.jerk_mm_s > 0) planner_->SetJerk(move.jerk_mm_s);
  planner_->Add(*kinematic);
}

void PrintClock::Stop(double sign) {
  const auto profiles = planner_->Stop();
  for (size_t i = 0; i < profiles.size(); ++i) {
    *accounts_[i].kind_s += sign * profiles[i].time_s;
    *accounts_[i].part_s += sign * profiles[i].time_s;
    *accounts_[i].copy_s += sign * profiles[i].time_s;
  }
  accounts_.clear();
}

PrintTimes PrintClock::Finish() {
  Stop();
  // Rounding may leave a negative sum after additions and subtractions.
  const auto round_up = [](double& sum) { sum = std::max(0.0, sum); };
  std::ranges::for_each(times_.feature_s, round_up);
  std::ranges::for_each(times_.layer_s, round_up);
  std::ranges::for_each(times_.copy_s, round_up);
  round_up(times_.travel_s);
  round_up(times_.retract_s);
  return std::move(times_);
}

}  // namespace slicefarm::motion
