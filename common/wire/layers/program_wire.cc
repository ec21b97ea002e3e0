#include "common/wire/layers/program_wire.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "common/model/limits.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/support/amounts.h"
#include "common/wire/support/box_wire.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/geometry_wire.h"
#include "common/wire/support/mesh_wire.h"
#include "common/wire/support/repeated_wire.h"

namespace slicefarm {

static_assert(v1::MACHINE_MODE_FAN == static_cast<int>(MachineMode::kFan) + 1);
static_assert(v1::MACHINE_MODE_JERK == static_cast<int>(MachineMode::kJerk) + 1);
static_assert(v1::MachineMode_MAX == kMachineModes);

void ToProto(const FeatureUse& use, v1::FeatureUse* proto) {
  proto->set_time_s(use.time_s);
  proto->set_length_mm(use.length_mm);
  proto->set_filament_mm(use.filament_mm);
  proto->set_volume_mm3(use.volume_mm3);
}

absl::StatusOr<FeatureUse> FromProto(const v1::FeatureUse& proto) {
  if (!AreAmounts({proto.time_s(), proto.length_mm(), proto.filament_mm(), proto.volume_mm3()})) {
    return Malformed("time_s, length_mm, filament_mm, volume_mm3", "not all are amounts");
  }
  return FeatureUse{proto.time_s(), proto.length_mm(), proto.filament_mm(), proto.volume_mm3()};
}

namespace {

constexpr int kMostEdgeMoves = 1000;

v1::EdgeMove ToProto(const EdgeMove& move) {
  v1::EdgeMove proto;
  proto.set_x_um(move.x_um);
  proto.set_y_um(move.y_um);
  proto.set_z_um(move.z_um);
  proto.set_filament(move.filament);
  proto.set_feed_rate(move.feed_rate);
  proto.set_acceleration_mm_s2(move.acceleration_mm_s2);
  proto.set_jerk_mm_s(move.jerk_mm_s);
  proto.set_feature(EnumToProto<v1::Feature>(move.feature));
  proto.set_copy(move.copy);
  return proto;
}

absl::StatusOr<EdgeMove> FromProto(const v1::EdgeMove& proto) {
  if (!IsAmount(proto.acceleration_mm_s2()) || !IsAmount(proto.jerk_mm_s()) ||
      proto.feed_rate() < 0)
    return Malformed("acceleration_mm_s2, jerk_mm_s, feed_rate", "not all are amounts");
  const auto feature = EnumFromProto<Feature>(proto.feature(), kFeatureCount, "feature");
  if (!feature.ok()) return feature.status();
  if (proto.copy() < kNoCopy) return Malformed("copy", "is no copy");
  return EdgeMove{proto.x_um(),      proto.y_um(),      proto.z_um(),
                  proto.filament(),  proto.feed_rate(), proto.acceleration_mm_s2(),
                  proto.jerk_mm_s(), *feature,          proto.copy()};
}

v1::LayerEdges ToProto(const LayerEdges& edges) {
  v1::LayerEdges proto;
  for (const EdgeMove& move : edges.head) *proto.add_head() = ToProto(move);
  for (const EdgeMove& move : edges.tail) *proto.add_tail() = ToProto(move);
  proto.set_approach(edges.approach);
  proto.set_acceleration_mm_s2(edges.acceleration_mm_s2);
  return proto;
}

absl::StatusOr<LayerEdges> FromProto(const v1::LayerEdges& proto) {
  if (proto.head_size() > kMostEdgeMoves || proto.tail_size() > kMostEdgeMoves)
    return Malformed("head, tail", fmt::format("more than {} moves", kMostEdgeMoves));
  LayerEdges edges;
  absl::Status status;
  for (int i = 0; i < proto.head_size(); ++i) {
    const auto move = FromProto(proto.head(i));
    if (!move.ok()) return Within("head", i, move.status());
    edges.head.push_back(*move);
  }
  for (int i = 0; i < proto.tail_size(); ++i) {
    const auto move = FromProto(proto.tail(i));
    if (!move.ok()) return Within("tail", i, move.status());
    edges.tail.push_back(*move);
  }
  if (proto.approach() < 0 || proto.approach() > proto.head_size())
    return Malformed("approach", "is no move of the head");
  if (!IsAmount(proto.acceleration_mm_s2())) return Malformed("acceleration_mm_s2", "is not one");
  edges.approach = proto.approach();
  edges.acceleration_mm_s2 = proto.acceleration_mm_s2();
  return edges;
}

v1::ModeLine ToProto(const ModeLine& line) {
  v1::ModeLine proto;
  proto.set_at(line.at);
  proto.set_size(line.size);
  proto.set_mode(EnumToProto<v1::MachineMode>(line.mode));
  proto.set_value(line.value);
  return proto;
}

/// Converts lines, which must be consecutive within `gcode_bytes` bytes.
absl::StatusOr<std::vector<ModeLine>> FromProto(
    const google::protobuf::RepeatedPtrField<v1::ModeLine>& protos, int64_t gcode_bytes) {
  std::vector<ModeLine> lines;
  int64_t done = 0;
  for (const v1::ModeLine& proto : protos) {
    const auto mode = EnumFromProto<MachineMode>(proto.mode(), kMachineModes, "mode_lines.mode");
    if (!mode.ok()) return mode.status();
    if (proto.at() < done || proto.size() < 0 || proto.size() > gcode_bytes - proto.at())
      return Malformed("mode_lines", "are no lines of the G-code, one after the other");
    done = proto.at() + proto.size();
    lines.push_back({proto.at(), proto.size(), *mode, proto.value()});
  }
  return lines;
}

absl::StatusOr<std::optional<ModeValues>> ModesAtEnd(const v1::LayerProgram& proto) {
  if (!proto.has_modes_at_end()) return std::nullopt;
  if (proto.modes_at_end().values_size() != kMachineModes)
    return Malformed("modes_at_end.values", fmt::format("not {} of them", kMachineModes));
  ModeValues values;
  std::ranges::copy(proto.modes_at_end().values(), values.begin());
  return values;
}

v1::CopyUse ToProto(const CopyUse& copy) {
  v1::CopyUse proto;
  proto.set_copy(copy.copy);
  ToProto(copy.use, proto.mutable_use());
  return proto;
}

/// Converts totals, which must be in ascending order of their copies.
absl::StatusOr<std::vector<CopyUse>> FromProto(
    const google::protobuf::RepeatedPtrField<v1::CopyUse>& protos) {
  std::vector<CopyUse> copies;
  for (const v1::CopyUse& proto : protos) {
    const int32_t before = copies.empty() ? kNoCopy : copies.back().copy;
    if (proto.copy() <= before || proto.copy() >= limits::kMaxObjects)
      return Malformed("copies", "are not in the order of the job's copies");
    const auto use = FromProto(proto.use());
    if (!use.ok()) return Within("copies", static_cast<int>(copies.size()), use.status());
    copies.push_back({proto.copy(), *use});
  }
  return copies;
}

v1::PrintTimes ToProto(const PrintTimes& times) {
  v1::PrintTimes proto;
  proto.mutable_feature_s()->Assign(times.feature_s.begin(), times.feature_s.end());
  proto.set_travel_s(times.travel_s);
  proto.set_retract_s(times.retract_s);
  proto.set_custom_s(times.custom_s);
  proto.set_dwell_s(times.dwell_s);
  proto.set_heating_s(times.heating_s);
  proto.set_homings(times.homings);
  proto.set_heat_waits(times.heat_waits);
  proto.set_tool_changes(times.tool_changes);
  proto.set_before_s(times.before_s);
  proto.mutable_layer_s()->Assign(times.layer_s.begin(), times.layer_s.end());
  proto.set_after_s(times.after_s);
  proto.mutable_copy_s()->Assign(times.copy_s.begin(), times.copy_s.end());
  return proto;
}

absl::StatusOr<PrintTimes> FromProto(const v1::PrintTimes& proto) {
  if (proto.feature_s_size() != kFeatureCount)
    return Malformed("feature_s", fmt::format("not {} of them", kFeatureCount));
  const bool amounts =
      AreAmounts({proto.travel_s(), proto.retract_s(), proto.custom_s(), proto.dwell_s(),
                  proto.heating_s(), proto.before_s(), proto.after_s()}) &&
      std::ranges::all_of(proto.feature_s(), IsAmount) &&
      std::ranges::all_of(proto.layer_s(), IsAmount) &&
      std::ranges::all_of(proto.copy_s(), IsAmount);
  if (!amounts || proto.homings() < 0 || proto.heat_waits() < 0 || proto.tool_changes() < 0)
    return Malformed("times", "not all are amounts");
  PrintTimes times;
  std::ranges::copy(proto.feature_s(), times.feature_s.begin());
  times.travel_s = proto.travel_s();
  times.retract_s = proto.retract_s();
  times.custom_s = proto.custom_s();
  times.dwell_s = proto.dwell_s();
  times.heating_s = proto.heating_s();
  times.homings = proto.homings();
  times.heat_waits = proto.heat_waits();
  times.tool_changes = proto.tool_changes();
  times.before_s = proto.before_s();
  times.layer_s.assign(proto.layer_s().begin(), proto.layer_s().end());
  times.after_s = proto.after_s();
  times.copy_s.assign(proto.copy_s().begin(), proto.copy_s().end());
  return times;
}

}  // namespace

absl::Status ToProto(const LayerSummary& layer, v1::LayerSummary* proto) {
  ToProto(layer.frame, proto->mutable_frame());
  proto->set_time_s(layer.time_s);
  proto->set_empty(layer.empty);
  proto->set_pass(layer.pass);
  *proto->mutable_edges() = ToProto(layer.edges);
  proto->set_filament_mm(layer.filament_mm);
  proto->set_silent_time_s(layer.silent_time_s);
  if (absl::Status status = PackPoints(layer.footprint, proto->mutable_footprint_xy_nm());
      !status.ok())
    return Within("footprint_xy_nm", status);
  if (absl::Status status = ToProto(layer.entry, proto->mutable_entry()); !status.ok()) {
    return Within("entry", status);
  }
  return ToProto(layer.exit, proto->mutable_exit());
}

absl::StatusOr<LayerSummary> FromProto(const v1::LayerSummary& proto) {
  absl::StatusOr<LayerFrame> frame = FromProto(proto.frame());
  if (!frame.ok()) return frame.status();
  if (!IsAmount(proto.time_s())) return Malformed("time_s", "is not a time");
  if (!IsAmount(proto.silent_time_s())) return Malformed("silent_time_s", "is not a time");
  if (!IsAmount(proto.filament_mm())) return Malformed("filament_mm", "is not an amount");
  if (proto.pass() < 0) return Malformed("pass", "is negative");
  absl::StatusOr<LayerEdges> edges = FromProto(proto.edges());
  if (!edges.ok()) return Within("edges", edges.status());
  auto footprint = UnpackPoints(proto.footprint_xy_nm(), "footprint_xy_nm");
  if (!footprint.ok()) return footprint.status();
  return LayerSummary{*frame,
                      proto.pass(),
                      FromProto(proto.entry()),
                      FromProto(proto.exit()),
                      proto.time_s(),
                      proto.empty(),
                      *std::move(edges),
                      proto.filament_mm(),
                      *std::move(footprint),
                      proto.silent_time_s()};
}

absl::Status ToProto(const ProgramStats& stats, v1::ProgramStats* proto) {
  for (const FeatureUse& use : stats.features) ToProto(use, proto->add_features());
  proto->set_travel_time_s(stats.travel_time_s);
  proto->set_retract_time_s(stats.retract_time_s);
  proto->set_travel_mm(stats.travel_mm);
  proto->set_travels(stats.travels);
  proto->set_retractions(stats.retractions);
  return BoxToProto(stats.bounds, proto);
}

absl::StatusOr<ProgramStats> FromProto(const v1::ProgramStats& proto) {
  if (proto.features_size() != kFeatureCount) {
    return Malformed("features", fmt::format("not {} of them", kFeatureCount));
  }
  if (!AreAmounts({proto.travel_time_s(), proto.retract_time_s(), proto.travel_mm()}) ||
      proto.travels() < 0 || proto.retractions() < 0) {
    return Malformed("travel_time_s, travel_mm, travels, retractions", "not all are amounts");
  }
  const absl::StatusOr<Box> bounds = BoxFromProto(proto);
  if (!bounds.ok()) return bounds.status();
  ProgramStats stats;
  for (int i = 0; i < kFeatureCount; ++i) {
    absl::StatusOr<FeatureUse> use = FromProto(proto.features(i));
    if (!use.ok()) return Within("features", i, use.status());
    stats.features[i] = *use;
  }
  stats.travel_time_s = proto.travel_time_s();
  stats.retract_time_s = proto.retract_time_s();
  stats.travel_mm = proto.travel_mm();
  stats.travels = proto.travels();
  stats.retractions = proto.retractions();
  stats.bounds = *bounds;
  return stats;
}

absl::Status ToProto(LayerProgram program, v1::LayerProgram* proto) {
  ToProto(program.frame, proto->mutable_frame());
  proto->set_gcode(std::move(program.gcode));
  proto->set_pass(program.pass);
  *proto->mutable_edges() = ToProto(program.edges);
  proto->mutable_code_at()->Assign(program.code_at.begin(), program.code_at.end());
  for (const ModeLine& line : program.mode_lines) *proto->add_mode_lines() = ToProto(line);
  if (program.modes_at_end)
    proto->mutable_modes_at_end()->mutable_values()->Assign(program.modes_at_end->begin(),
                                                            program.modes_at_end->end());
  proto->set_ends_retracted(program.ends_retracted);
  proto->set_silent_time_s(program.silent_time_s);
  for (const CopyUse& copy : program.copies) *proto->add_copies() = ToProto(copy);
  if (absl::Status status = PackPoints(program.footprint, proto->mutable_footprint_xy_nm());
      !status.ok())
    return Within("footprint_xy_nm", status);
  if (absl::Status status = ToProto(program.entry, proto->mutable_entry()); !status.ok()) {
    return Within("entry", status);
  }
  if (absl::Status status = ToProto(program.exit, proto->mutable_exit()); !status.ok()) {
    return Within("exit", status);
  }
  return ToProto(program.stats, proto->mutable_stats());
}

absl::StatusOr<LayerProgram> FromProto(v1::LayerProgram proto) {
  absl::StatusOr<LayerFrame> frame = FromProto(proto.frame());
  if (!frame.ok()) return frame.status();
  absl::StatusOr<ProgramStats> stats = FromProto(proto.stats());
  if (!stats.ok()) return Within("stats", stats.status());
  if (proto.pass() < 0) return Malformed("pass", "is negative");
  absl::StatusOr<LayerEdges> edges = FromProto(proto.edges());
  if (!edges.ok()) return Within("edges", edges.status());
  const auto gcode_bytes = static_cast<int64_t>(proto.gcode().size());
  const bool places = std::ranges::is_sorted(proto.code_at()) &&
                      std::ranges::all_of(proto.code_at(),
                                          [&](int64_t at) { return 0 <= at && at <= gcode_bytes; });
  if (!places || (proto.code_at_size() != 0 && proto.code_at_size() != kCodesOfALayer))
    return Malformed("code_at", "are no places in the G-code");
  if (!IsAmount(proto.silent_time_s())) return Malformed("silent_time_s", "is not a time");
  auto mode_lines = FromProto(proto.mode_lines(), gcode_bytes);
  if (!mode_lines.ok()) return mode_lines.status();
  auto modes_at_end = ModesAtEnd(proto);
  if (!modes_at_end.ok()) return modes_at_end.status();
  auto footprint = UnpackPoints(proto.footprint_xy_nm(), "footprint_xy_nm");
  if (!footprint.ok()) return footprint.status();
  auto copies = FromProto(proto.copies());
  if (!copies.ok()) return copies.status();
  return LayerProgram{*frame,
                      proto.pass(),
                      std::move(*proto.mutable_gcode()),
                      FromProto(proto.entry()),
                      FromProto(proto.exit()),
                      *stats,
                      *std::move(edges),
                      {proto.code_at().begin(), proto.code_at().end()},
                      *std::move(mode_lines),
                      *std::move(modes_at_end),
                      proto.ends_retracted(),
                      *std::move(footprint),
                      proto.silent_time_s(),
                      *std::move(copies)};
}

v1::StageTimes ToProto(const StageTimes& times) {
  v1::StageTimes proto;
  for (const StageInfo& info : kStages)
    if (times[info.stage] != 0)
      (*proto.mutable_seconds())[std::string(info.name)] = times[info.stage];
  return proto;
}

absl::StatusOr<StageTimes> FromProto(const v1::StageTimes& proto) {
  StageTimes times;
  for (const auto& [name, seconds] : proto.seconds()) {
    const std::optional<Stage> stage = FindStage(name);
    if (!stage || !AreAmounts({seconds})) return Malformed("times", "not all are times of stages");
    times[*stage] = seconds;
  }
  return times;
}

v1::LayerWarning ToProto(const LayerWarning& warning) {
  v1::LayerWarning proto;
  proto.set_layer(warning.layer);
  proto.set_plain_islands(warning.plain_islands);
  return proto;
}

absl::StatusOr<LayerWarning> FromProto(const v1::LayerWarning& proto) {
  if (proto.layer() < 0 || proto.layer() >= limits::kMaxLayers || proto.plain_islands() < 0) {
    return Malformed("warning", "is of no layer");
  }
  return LayerWarning{proto.layer(), proto.plain_islands()};
}

absl::Status ToProto(const ProgramSummary& summary, v1::ProgramEnvelopeRequest* proto) {
  if (absl::Status status = AllToProto(summary.layers, "layers", proto->mutable_layers());
      !status.ok()) {
    return status;
  }
  if (absl::Status status = ToProto(summary.total, proto->mutable_total()); !status.ok()) {
    return Within("total", status);
  }
  for (const Thumbnail& thumbnail : summary.thumbnails) {
    *proto->add_thumbnails() = ToProto(thumbnail);
  }
  for (size_t i = 0; i < summary.copies.size(); ++i) {
    v1::CopySummary* copy = proto->add_copies();
    *copy->mutable_name() = ToProto(summary.copies[i].name);
    absl::Status status = PackPoints(summary.copies[i].footprint, copy->mutable_footprint_xy_nm());
    if (!status.ok()) return Within("copies", i, status);
    ToProto(summary.copies[i].use, copy->mutable_use());
  }
  proto->set_settings_text(summary.settings_text);
  return absl::OkStatus();
}

absl::StatusOr<ProgramSummary> FromProto(const v1::ProgramEnvelopeRequest& proto) {
  ProgramSummary summary;
  if (proto.layers_size() > limits::kMaxLayerPrograms) {
    return Malformed("layers", fmt::format("more than {}", limits::kMaxLayerPrograms));
  }
  if (absl::Status status = AllFromProto(proto.layers(), "layers", &summary.layers); !status.ok()) {
    return status;
  }
  absl::StatusOr<ProgramStats> total = FromProto(proto.total());
  if (!total.ok()) return Within("total", total.status());
  summary.total = *total;
  if (absl::Status status = AllFromProto(proto.thumbnails(), "thumbnails", &summary.thumbnails);
      !status.ok()) {
    return status;
  }
  if (proto.copies_size() > limits::kMaxObjects) {
    return Malformed("copies", fmt::format("more than {}", limits::kMaxObjects));
  }
  for (int i = 0; i < proto.copies_size(); ++i) {
    absl::StatusOr<CopyName> name = FromProto(proto.copies(i).name());
    if (!name.ok()) return Within("copies", i, name.status());
    auto footprint = UnpackPoints(proto.copies(i).footprint_xy_nm(), "footprint_xy_nm");
    if (!footprint.ok()) return Within("copies", i, footprint.status());
    const auto use = FromProto(proto.copies(i).use());
    if (!use.ok()) return Within("copies", i, use.status());
    summary.copies.push_back({*std::move(name), *std::move(footprint), *use});
  }
  summary.settings_text = proto.settings_text();
  return summary;
}

v1::ProgramEnvelope ToProto(ProgramEnvelope envelope) {
  v1::ProgramEnvelope proto;
  proto.set_prologue(std::move(envelope.prologue));
  for (std::string& prefix : envelope.layer_prefixes) proto.add_layer_prefixes(std::move(prefix));
  proto.set_epilogue(std::move(envelope.epilogue));
  *proto.mutable_times() = ToProto(envelope.times);
  proto.set_travel_mm(envelope.travel_mm);
  for (std::string& code : envelope.layer_code) proto.add_layer_code(std::move(code));
  proto.set_head(std::move(envelope.head));
  proto.set_tail(std::move(envelope.tail));
  proto.set_file_name(std::move(envelope.file_name));
  return proto;
}

absl::StatusOr<ProgramEnvelope> FromProto(v1::ProgramEnvelope proto) {
  if (!IsAmount(proto.travel_mm())) return Malformed("travel_mm", "is not an amount");
  absl::StatusOr<PrintTimes> times = FromProto(proto.times());
  if (!times.ok()) return Within("times", times.status());
  ProgramEnvelope envelope;
  envelope.prologue = std::move(*proto.mutable_prologue());
  for (std::string& prefix : *proto.mutable_layer_prefixes()) {
    envelope.layer_prefixes.push_back(std::move(prefix));
  }
  envelope.epilogue = std::move(*proto.mutable_epilogue());
  envelope.times = *std::move(times);
  envelope.travel_mm = proto.travel_mm();
  for (std::string& code : *proto.mutable_layer_code())
    envelope.layer_code.push_back(std::move(code));
  envelope.head = std::move(*proto.mutable_head());
  envelope.tail = std::move(*proto.mutable_tail());
  envelope.file_name = std::move(*proto.mutable_file_name());
  return envelope;
}

}  // namespace slicefarm
