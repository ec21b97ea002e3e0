#include "services/motion/algo/layer_program.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "common/gcode/custom_code.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/built_block.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/gcode/layer_writer.h"
#include "services/motion/algo/gcode/machine_setup.h"
#include "services/motion/algo/gcode/object_labels.h"
#include "services/motion/algo/macro/layer_code.h"
#include "services/motion/algo/program/custom_use.h"
#include "services/motion/algo/toolpath/accelerations.h"
#include "services/motion/algo/toolpath/cooling.h"
#include "services/motion/algo/toolpath/edge_moves.h"
#include "services/motion/algo/toolpath/footprint.h"
#include "services/motion/algo/toolpath/layer_context.h"
#include "services/motion/algo/toolpath/layer_timing.h"
#include "services/motion/algo/toolpath/lifts.h"

namespace slicefarm::motion {
namespace {

constexpr size_t kBytesPerMove = 32;
constexpr size_t kBytesAround = 512;

/// Records the position of code that is filled in later.
void KeepPosition(const CustomCode& code, const GcodeText& out, std::vector<int64_t>& places) {
  if (code.waits) places.push_back(std::ssize(out.text()));
}

void WriteHeader(const LayerFrame& frame, const CommentWords& words, const CustomCode& code,
                 std::vector<int64_t>& places, GcodeText& out) {
  const double z_mm = ToMm(static_cast<double>(frame.print_z_nm));
  out << words.layer_change << '\n' << words.z;
  out.Real(z_mm, 3) << '\n' << words.height;
  out.Real(static_cast<double>(ToUm(frame.height_nm)) / kUmPerMm, 3) << '\n';
  // Printer hosts search for this pair of lines, and many profiles write it themselves.
  if (!code.names_layer_change) {
    out << ";BEFORE_LAYER_CHANGE\n;";
    out.Real(z_mm, 3) << '\n';
  }
  KeepPosition(code, out, places);
  out.Lines(code.before);
}

/// Writes the change from the first layer's temperatures to the normal ones, at the second layer.
void WriteTemperatures(const MotionOptions& options, int32_t layer_index, GcodeText& out) {
  if (layer_index != 1) return;
  if (options.tool().temperature_c != options.tool().first_layer_temperature_c) {
    WriteTemperature("M104", options.tool().temperature_c, out);
  }
  if (options.tool().bed_temperature_c != options.tool().first_layer_bed_temperature_c) {
    WriteTemperature("M140", options.tool().bed_temperature_c, out);
  }
}

/// Returns true if the visits print no part: there are only supports, or no visits.
bool PrintsNoPart(std::span<const BlockVisit> visits, const OrderedLayer& layer) {
  return std::ranges::all_of(visits, [&](const BlockVisit& visit) {
    return BlockOf(visit, layer).stack.kind == StackKind::kSupport;
  });
}

/// Returns the start of the first bead. A turn of a spiral starts where the turn below ended.
Point StartOf(const PathBlock& block) {
  if (block.spiral && block.spiral->blends && block.spiral->from) return *block.spiral->from;
  return StartOf(block.paths.front());
}

/// Returns the plate coordinates of the start of a visit.
Point EntryOf(const BlockVisit& visit, const OrderedLayer& layer) {
  const PathBlock& block = BlockOf(visit, layer);
  const bool turns = layer.begins_ready && &visit == &layer.visits.front() &&
                     !block.travels.empty() && !block.travels.front().corners.empty();
  return visit.shift + (turns ? block.travels.front().corners.front() : StartOf(block));
}
/// Returns the plate coordinates of the end of a visit.
Point ExitOf(const BlockVisit& visit, std::span<const BuiltBlock> built) {
  return visit.shift + built[static_cast<size_t>(visit.block)].Exit();
}

ProgramStats Moved(ProgramStats stats, Point shift) {
  if (!stats.bounds.Empty()) stats.bounds = {stats.bounds.min + shift, stats.bounds.max + shift};
  return stats;
}

/// Returns the totals over all features, without a time.
FeatureUse FilamentOf(const ProgramStats& stats) {
  return {.length_mm = stats.ExtrudedMm(),
          .filament_mm = stats.FilamentMm(),
          .volume_mm3 = stats.VolumeMm3()};
}

double TravelMm(Point from, std::span<const Point> corners, Point to) {
  double length_nm = 0;
  for (const Point corner : corners) length_nm += Distance(std::exchange(from, corner), corner);
  return ToMm(length_nm + Distance(from, to));
}

/// Program of one pass.
class PassProgram {
 public:
  /// All arguments must outlive this object. `visits`: not empty.
  PassProgram(const OrderedLayer& layer, std::span<const BuiltBlock> built,
              std::span<const BlockVisit> visits, const MotionOptions& options)
      : layer_(layer), visits_(visits), options_(options) {
    for (const BlockVisit& visit : visits) {
      const auto block = static_cast<size_t>(visit.block);
      if (place_of_.try_emplace(visit.block, paths_.size()).second)
        paths_.push_back(built[block].path);
      stats_.Add(Moved(built[block].stats, visit.shift));
      if (visit.copy != kNoCopy) AddUse(visit.copy, FilamentOf(built[block].stats), copies_);
    }
    for (const BlockVisit& visit : visits) travels_.push_back(TravelTo(visit));
    for (size_t i = 1; i < visits.size(); ++i)
      stats_.travel_mm +=
          TravelMm(ExitOf(visits[i - 1], built), visits[i].corners, EntryOf(visits[i], layer));
    const std::vector<MoveSpan> spans = MoveSpans();
    LayerTiming timing(FirmwareOf(options.flavor), options.limits);
    const auto times = SlowDown(CoolingOf(visits), spans, timing, paths_);
    AddTimes(spans, times, stats_);
    AddCopyTimes(spans, times, copies_);
    edges_ = EdgesOf(spans);
    if (layer.frame.index == 0) footprint_ = FootprintOf(spans);
    for (Point& corner : footprint_) corner = corner + options.tool().offset;
    if (options.silent_limits) {
      LayerTiming silent(FirmwareOf(options.flavor), *options.silent_limits);
      const std::span<const double> times = silent.Times(spans);
      silent_time_s_ = std::accumulate(times.begin(), times.end(), 0.0);
    }
  }

  const ProgramStats& stats() const { return stats_; }
  const LayerEdges& edges() const { return edges_; }
  const Polygon& footprint() const { return footprint_; }
  double silent_time_s() const { return silent_time_s_; }
  const std::vector<CopyUse>& copies() const { return copies_; }

  void Write(const CustomCode& code, const JobFacts& facts, LayerWriter& writer,
             std::vector<int64_t>& places, GcodeText& out) const {
    for (const BlockVisit& visit : visits_) {
      const Toolpath& path = PathOf(visit);
      const ShiftUm shift = ShiftOf(visit);
      const size_t approach = path.approach;
      const bool first = &visit == &visits_.front();
      if (first || Lifts()) writer.Write(path, 0, approach, shift, out);
      const Toolpath& travel = TravelOf(visit);
      writer.Write(travel, 0, travel.moves.size(), OnMachine({}), out);
      if (first) KeepPosition(code, out, places);
      if (first) out.Lines(code.after);
      if (first && code.has_after) writer.Forget();
      if (first && code.moves) writer.ForgetPosition();
      if (first && code.primes) writer.Prime();
      writer.Write(path, approach, approach + 1, shift, out);
      WriteCopy(visit, shift, facts, writer, out);
    }
  }

 private:
  /// Returns the cooling options. Supports between the part's own layers have no part to cool, so
  /// they are not slowed down.
  CoolingOptions CoolingOf(std::span<const BlockVisit> visits) const {
    CoolingOptions cooling = options_.tool().cooling;
    if (PrintsNoPart(visits, layer_)) cooling.slowdown_below_layer_time_s = 0;
    return cooling;
  }

  bool Lifts() const { return LiftsToStart(options_.tool().retraction, layer_.frame); }

  const Toolpath& PathOf(const BlockVisit& visit) const {
    return paths_[place_of_.at(visit.block)];
  }

  /// Converts a point of the plate to the machine's coordinates, as a shift.
  ShiftUm OnMachine(Point at) const {
    const Point shift = at - options_.tool().offset;
    return {ToUm(shift.x), ToUm(shift.y)};
  }
  ShiftUm ShiftOf(const BlockVisit& visit) const { return OnMachine(visit.shift); }

  const Toolpath& TravelOf(const BlockVisit& visit) const {
    return travels_[static_cast<size_t>(&visit - &visits_.front())];
  }

  /// Returns the moves to the corners of the travel from the previous visit, in plate coordinates.
  /// They have the properties of the approach.
  Toolpath TravelTo(const BlockVisit& visit) const {
    Toolpath travel;
    if (&visit == &visits_.front()) return travel;
    const Toolpath& path = PathOf(visit);
    for (const Point corner : visit.corners) {
      Move move = path.moves[path.approach];
      move.x_um = ToUm(corner.x);
      move.y_um = ToUm(corner.y);
      travel.moves.push_back(move);
    }
    return travel;
  }

  /// Returns the copy to which the travel to a visit belongs. A travel from one copy to another
  /// belongs to none. The print clock decides about the first travel of the layer.
  int32_t TravelCopy(const BlockVisit& visit) const {
    const bool stays = &visit == &visits_.front() || (&visit)[-1].copy == visit.copy;
    return stays ? visit.copy : kNoCopy;
  }

  /// Returns the written spans in their order. Copies after the first are already at their
  /// height, unless travels rise.
  std::vector<MoveSpan> MoveSpans() const {
    std::vector<MoveSpan> spans;
    for (const BlockVisit& visit : visits_) {
      const Toolpath& path = PathOf(visit);
      const Toolpath& travel = TravelOf(visit);
      const ShiftUm shift = ShiftOf(visit);
      size_t first = &visit == &visits_.front() || Lifts() ? 0 : path.approach;
      const int32_t arrives = TravelCopy(visit);
      if (!travel.moves.empty()) {
        spans.push_back({&path, first, path.approach, shift, visit.copy, arrives});
        spans.push_back({&travel, 0, travel.moves.size(), OnMachine({}), arrives, arrives});
        first = path.approach;
      }
      spans.push_back({&path, first, path.moves.size(), shift, visit.copy, arrives});
    }
    return spans;
  }

  /// Writes a visit. The blocks of a copy follow each other under one label.
  void WriteCopy(const BlockVisit& visit, ShiftUm shift, const JobFacts& facts, LayerWriter& writer,
                 GcodeText& out) const {
    const auto copy = static_cast<size_t>(visit.copy);
    const bool labelled = visit.copy >= 0 && copy < facts.copies.size() &&
                          !LabelIsAroundAll(facts.copies.size(), options_);
    const bool begins = &visit == &visits_.front() || (&visit)[-1].copy != visit.copy;
    const bool ends = &visit == &visits_.back() || (&visit)[1].copy != visit.copy;
    if (labelled && begins) BeginCopy(facts.copies[copy], copy, options_, out);
    writer.BeginBlock(out);
    const Toolpath& path = PathOf(visit);
    writer.Write(path, path.approach + 1, path.moves.size(), shift, out);
    writer.EndBlock(out);
    if (!labelled || !ends) return;
    EndCopy(facts.copies[copy], copy, options_, out);
    // If the firmware skips a copy, it may also skip the lines that set modes. They are written
    // again, if there is another copy.
    if (options_.labels != ObjectLabels::kNone && facts.copies.size() > 1) writer.Forget();
  }

  const OrderedLayer& layer_;
  const std::span<const BlockVisit> visits_;
  const MotionOptions& options_;
  /// key: index of a block in the layer; value: index in paths_
  std::map<int32_t, size_t> place_of_;
  std::vector<Toolpath> paths_;
  std::vector<Toolpath> travels_;  ///< travel to each visit
  ProgramStats stats_;
  LayerEdges edges_;
  Polygon footprint_;
  double silent_time_s_ = 0;
  std::vector<CopyUse> copies_;
};

/// Returns the visits of each pass, in order. Without visits, returns one pass without visits.
std::vector<std::span<const BlockVisit>> PassesOf(std::span<const BlockVisit> visits) {
  std::vector<std::span<const BlockVisit>> passes;
  size_t first = 0;
  for (size_t i = 1; i <= visits.size(); ++i) {
    if (i < visits.size() && visits[i].pass == visits[first].pass) continue;
    passes.push_back(visits.subspan(first, i - first));
    first = i;
  }
  if (passes.empty()) passes.push_back({});
  return passes;
}

/// Returns the fan speeds and the height of a layer. `index`: index of the layer in its pass. In a
/// layer above the first one that prints no part, the fan speed does not change.
LayerState StateOf(const OrderedLayer& layer, std::span<const BlockVisit> visits, int32_t index,
                   double time_s, const MotionOptions& options) {
  const CoolingOptions& cooling = options.tool().cooling;
  LayerState state;
  state.height_um = ToUm(layer.frame.height_nm);
  state.to_plate = {ToUm(options.tool().offset.x), ToUm(options.tool().offset.y)};
  state.fan_percent = FanPercent(cooling, index, time_s);
  if (PrintsNoPart(visits, layer) && layer.frame.index > 0) state.fan_percent = kFanAsBefore;
  state.fan_limits = {options.fan_least_percent, options.fan_kickstart_s};
  state.fan_percent = state.fan_limits.Raised(state.fan_percent);
  state.fan_is_off = IsOffBefore(cooling, index);
  state.bridge_fan_percent = BridgeFanPercent(cooling, index, state.fan_percent);
  state.overhang_fan_percent = OverhangFanPercent(cooling, index, state.fan_percent);
  state.cooled_rest = CooledRest(cooling);
  state.line_fans = LineFanPercent(cooling, index);
  state.fan_early_s = options.fan_speedup_s;
  state.fan_early_all = options.fan_speedup_all;
  return state;
}

/// Returns the changes of the feature in a pass, in the order of printing.
std::set<RoleChange> RoleChangesIn(std::span<const BuiltBlock> built,
                                   std::span<const BlockVisit> visits) {
  std::set<RoleChange> changes;
  int32_t last = -1;
  for (const BlockVisit& visit : visits)
    for (const Move& move : built[static_cast<size_t>(visit.block)].path.moves) {
      const auto role = static_cast<int32_t>(move.feature);
      if (move.kind != MoveKind::kPrint || role == last) continue;
      changes.emplace(std::exchange(last, role), role);
    }
  return changes;
}

absl::StatusOr<LayerProgram> ProgramPass(const OrderedLayer& layer,
                                         std::span<const BuiltBlock> built,
                                         std::span<const BlockVisit> visits, const JobFacts& facts,
                                         const MotionOptions& options, const LayerCode& layer_code,
                                         const MaterialField* materials) {
  const LayerContext context = ContextOf(layer, visits, facts);
  const auto code = layer_code.At(layer.frame, context, facts);
  if (!code.ok()) return code.status();
  LayerProgram program;
  program.frame = layer.frame;
  std::optional<PassProgram> pass;
  if (!visits.empty()) {
    pass.emplace(layer, built, visits, options);
    program.pass = visits.front().pass;
    program.stats = pass->stats();
    program.edges = pass->edges();
    program.footprint = pass->footprint();
    program.silent_time_s = pass->silent_time_s();
    program.copies = pass->copies();
    program.entry = EntryOf(visits.front(), layer) - options.tool().offset;
    program.exit = ExitOf(visits.back(), built) - options.tool().offset;
    program.ends_retracted = built[static_cast<size_t>(visits.back().block)].ends_retracted;
  }
  LayerState state = StateOf(layer, visits, context.index, program.stats.TimeS(), options);
  const std::optional<AdvanceControl> advance = AdvanceControl::Of(options);
  if (advance) state.advance = &*advance;
  RoleTexts roles;
  if (layer_code.HasRoles()) {
    auto texts = layer_code.RolesAt(context, facts, RoleChangesIn(built, visits));
    if (!texts.ok()) return texts.status();
    roles = *std::move(texts);
    state.roles = &roles;
  }
  LayerWriter writer(FirmwareOf(options.flavor), AccelerationsFor(options, Ground::kLayers), state,
                     pass ? materials : nullptr, ExtruderWords(options), options.writing.comments);
  size_t moves = 0;
  for (const BlockVisit& visit : visits)
    moves += built[static_cast<size_t>(visit.block)].path.moves.size();
  GcodeText out(moves * kBytesPerMove + kBytesAround + code->before.size() + code->after.size());
  WriteHeader(layer.frame, FirmwareOf(options.flavor).comments(), *code, program.code_at, out);
  WriteTemperatures(options, context.index, out);
  if (context.number == 1) FirmwareOf(options.flavor).WriteSecondLayer(out);
  writer.WriteLayerFan(out);
  if (pass) {
    pass->Write(*code, facts, writer, program.code_at, out);
  } else {
    KeepPosition(*code, out, program.code_at);
    out.Lines(code->after);
    const BuiltBlock idle = HandOver(layer, options);
    writer.Write(idle.path, 0, idle.path.moves.size(), {}, out);
    writer.EndBlock(out);
    program.stats = idle.stats;
    program.ends_retracted = idle.ends_retracted;
  }
  // The lines of custom G-code belong to no part, like a skirt.
  if (code->moves)
    program.stats.features[static_cast<size_t>(Feature::kSkirt)].Add(
        UseOfCode(code->after, options));
  program.gcode = out.Take();
  program.mode_lines = writer.TakeModeLines();
  // The firmware may skip a copy and the lines in it; then it has not executed all lines.
  const bool all_are_done = options.labels == ObjectLabels::kNone || facts.copies.size() < 2;
  if (all_are_done && gcode::LeavesModes(code->before) && gcode::LeavesModes(code->after))
    program.modes_at_end = writer.Modes();
  return program;
}

/// Returns the options with the length of retractions of the layer.
MotionOptions AtHeight(MotionOptions options, const HeightTexts& heights, const LayerFrame& frame) {
  double& length_mm = options.tool().retraction.length_mm;
  length_mm = heights.RetractLengthMm(frame.print_z_nm, length_mm);
  return options;
}

}  // namespace

absl::StatusOr<std::vector<LayerProgram>> ProgramLayer(const OrderedLayer& layer,
                                                       const JobFacts& facts,
                                                       const MotionOptions& given,
                                                       const LayerCode& code,
                                                       const MaterialField* materials) {
  std::optional<MotionOptions> own;
  if (code.heights().ChangesRetraction()) own = AtHeight(given, code.heights(), layer.frame);
  const MotionOptions& options = own ? *own : given;
  const double retracted_mm = code.heights().RetractLengthMm(
      layer.frame.print_z_nm - layer.frame.height_nm, given.tool().retraction.length_mm);
  const std::vector<BuiltBlock> built = BuildBlocks(layer, options, retracted_mm);
  std::vector<LayerProgram> programs;
  for (const std::span<const BlockVisit> visits : PassesOf(layer.visits)) {
    auto program = ProgramPass(layer, built, visits, facts, options, code, materials);
    if (!program.ok()) return program.status();
    programs.push_back(*std::move(program));
  }
  return programs;
}

}  // namespace slicefarm::motion
