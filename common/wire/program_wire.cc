#include "common/wire/program_wire.h"

#include <fmt/core.h>

#include <utility>

#include "common/model/limits.h"
#include "common/wire/amounts.h"
#include "common/wire/box_wire.h"
#include "common/wire/geometry_wire.h"
#include "common/wire/layer_wire.h"
#include "common/wire/mesh_wire.h"
#include "common/wire/plan_wire.h"
#include "common/wire/repeated_wire.h"

namespace slicefarm {
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

absl::Status ToProto(const LayerSummary& layer, v1::LayerSummary* proto) {
  ToProto(layer.frame, proto->mutable_frame());
  proto->set_time_s(layer.time_s);
  proto->set_empty(layer.empty);
  proto->set_pass(layer.pass);
  if (absl::Status status = ToProto(layer.entry, proto->mutable_entry()); !status.ok()) {
    return Within("entry", status);
  }
  return ToProto(layer.exit, proto->mutable_exit());
}

absl::StatusOr<LayerSummary> FromProto(const v1::LayerSummary& proto) {
  absl::StatusOr<LayerFrame> frame = FromProto(proto.frame());
  if (!frame.ok()) return frame.status();
  if (!IsAmount(proto.time_s())) return Malformed("time_s", "is not a time");
  if (proto.pass() < 0) return Malformed("pass", "is negative");
  return LayerSummary{*frame, proto.pass(), FromProto(proto.entry()), FromProto(proto.exit()),
                      proto.time_s(), proto.empty()};
}

absl::Status ToProto(const ProgramStats& stats, v1::ProgramStats* proto) {
  for (const FeatureUse& use : stats.features) ToProto(use, proto->add_features());
  proto->set_travel_time_s(stats.travel_time_s);
  proto->set_travel_mm(stats.travel_mm);
  proto->set_travels(stats.travels);
  proto->set_retractions(stats.retractions);
  return BoxToProto(stats.bounds, proto);
}

absl::StatusOr<ProgramStats> FromProto(const v1::ProgramStats& proto) {
  if (proto.features_size() != kFeatureCount) {
    return Malformed("features", fmt::format("not {} of them", kFeatureCount));
  }
  if (!AreAmounts({proto.travel_time_s(), proto.travel_mm()}) || proto.travels() < 0 ||
      proto.retractions() < 0) {
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
  return LayerProgram{*frame, proto.pass(), std::move(*proto.mutable_gcode()),
                      FromProto(proto.entry()), FromProto(proto.exit()), *stats};
}

v1::StageTimes ToProto(const StageTimes& times) {
  v1::StageTimes proto;
  proto.set_slicing_s(times.slicing_s);
  proto.set_beading_s(times.beading_s);
  proto.set_infill_s(times.infill_s);
  proto.set_ordering_s(times.ordering_s);
  proto.set_motion_s(times.motion_s);
  proto.set_planning_s(times.planning_s);
  proto.set_exposure_s(times.exposure_s);
  return proto;
}

absl::StatusOr<StageTimes> FromProto(const v1::StageTimes& proto) {
  if (!AreAmounts({proto.slicing_s(), proto.planning_s(), proto.beading_s(), proto.infill_s(), proto.ordering_s(),
                   proto.motion_s(), proto.exposure_s()})) {
    return Malformed("times", "not all are times");
  }
  return StageTimes{proto.slicing_s(), proto.planning_s(), proto.beading_s(),
                    proto.infill_s(),  proto.ordering_s(), proto.motion_s(), proto.exposure_s()};
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

absl::Status ToProto(const ProgramSummary& summary, v1::FrameRequest* proto) {
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
    absl::Status status =
        PackPoints(summary.copies[i].footprint, copy->mutable_footprint_xy_nm());
    if (!status.ok()) return Within("copies", i, status);
  }
  proto->set_settings_text(summary.settings_text);
  return absl::OkStatus();
}

absl::StatusOr<ProgramSummary> FromProto(const v1::FrameRequest& proto) {
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
    summary.copies.push_back({*std::move(name), *std::move(footprint)});
  }
  summary.settings_text = proto.settings_text();
  return summary;
}

v1::ProgramFrame ToProto(ProgramFrame frame) {
  v1::ProgramFrame proto;
  proto.set_prologue(std::move(frame.prologue));
  for (std::string& prefix : frame.layer_prefixes) proto.add_layer_prefixes(std::move(prefix));
  proto.set_epilogue(std::move(frame.epilogue));
  proto.set_time_s(frame.time_s);
  proto.set_travel_mm(frame.travel_mm);
  return proto;
}

absl::StatusOr<ProgramFrame> FromProto(v1::ProgramFrame proto) {
  if (!AreAmounts({proto.time_s(), proto.travel_mm()})) {
    return Malformed("time_s, travel_mm", "not all are amounts");
  }
  ProgramFrame frame;
  frame.prologue = std::move(*proto.mutable_prologue());
  for (std::string& prefix : *proto.mutable_layer_prefixes()) {
    frame.layer_prefixes.push_back(std::move(prefix));
  }
  frame.epilogue = std::move(*proto.mutable_epilogue());
  frame.time_s = proto.time_s();
  frame.travel_mm = proto.travel_mm();
  return frame;
}

}  // namespace slicefarm
