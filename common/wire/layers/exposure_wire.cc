#include "common/wire/layers/exposure_wire.h"

#include <utility>

#include "common/model/limits.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/support/amounts.h"
#include "common/wire/support/box_wire.h"
#include "common/wire/support/object_names.h"
#include "common/wire/support/repeated_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

v1::KindExposure ToProto(const KindExposure& kind) {
  v1::KindExposure proto;
  proto.set_vectors(kind.vectors);
  proto.set_lines(kind.lines);
  proto.set_length_mm(kind.length_mm);
  proto.set_time_s(kind.time_s);
  proto.set_energy_j(kind.energy_j);
  return proto;
}

absl::StatusOr<KindExposure> KindOf(const v1::KindExposure& proto) {
  if (proto.vectors() < 0 || proto.lines() < 0 || !IsAmount(proto.length_mm()) ||
      !IsAmount(proto.time_s()) || !IsAmount(proto.energy_j()))
    return Malformed("kinds", "not all are amounts");
  return KindExposure{proto.vectors(), proto.lines(), proto.length_mm(), proto.time_s(),
                      proto.energy_j()};
}

v1::CutCounts ToProto(const CutCounts& cuts) {
  v1::CutCounts proto;
  proto.set_pieces(cuts.pieces);
  proto.set_reflex(cuts.reflex);
  proto.set_extra_points(cuts.extra_points);
  proto.set_sharp_cuts(cuts.sharp_cuts);
  proto.set_replaced(cuts.replaced);
  return proto;
}

absl::StatusOr<CutCounts> CutsOf(const v1::CutCounts& proto) {
  for (const int64_t count :
       {proto.pieces(), proto.reflex(), proto.extra_points(), proto.sharp_cuts(), proto.replaced()})
    if (count < 0) return Malformed("cuts", "a count is negative");
  return CutCounts{proto.pieces(), proto.reflex(), proto.extra_points(), proto.sharp_cuts(),
                   proto.replaced()};
}

v1::MeltedSample ToProto(const MeltedSample& melted) {
  v1::MeltedSample proto;
  proto.set_length_mm(melted.length_mm);
  proto.set_melted_mm(melted.melted_mm);
  proto.set_energy_j_mm(melted.energy_j_mm);
  proto.set_pieces(melted.pieces);
  proto.set_least_j_mm2(melted.least_j_mm2);
  proto.set_most_j_mm2(melted.most_j_mm2);
  return proto;
}

absl::StatusOr<MeltedSample> MeltedOf(const v1::MeltedSample& proto) {
  for (const double amount : {proto.length_mm(), proto.melted_mm(), proto.energy_j_mm(),
                              proto.least_j_mm2(), proto.most_j_mm2()})
    if (!IsAmount(amount)) return Malformed("melted", "not all are amounts");
  if (proto.pieces() < 0) return Malformed("melted", "a count is negative");
  return MeltedSample{proto.length_mm(), proto.melted_mm(),   proto.energy_j_mm(),
                      proto.pieces(),    proto.least_j_mm2(), proto.most_j_mm2()};
}

absl::Status CheckSummary(const v1::ExposureEnvelopeRequest& proto) {
  if (proto.layers_size() > limits::kMaxLayers) return Malformed("layers", "too many");
  if (!IsAmount(proto.time_s())) return Malformed("time_s", "is no amount");
  return CheckObjectNames(proto.object_names());
}

}  // namespace

absl::Status ToProto(const ExposureReport& report, v1::ExposureReport* proto) {
  for (const KindExposure& kind : report.kinds) *proto->add_kinds() = ToProto(kind);
  proto->set_jumps(report.jumps);
  proto->set_jump_mm(report.jump_mm);
  proto->set_jump_time_s(report.jump_time_s);
  proto->set_area_mm2(report.area_mm2);
  proto->set_volume_mm3(report.volume_mm3);
  *proto->mutable_cuts() = ToProto(report.cuts);
  *proto->mutable_melted() = ToProto(report.melted);
  return BoxToProto(report.bounds, proto);
}

absl::StatusOr<ExposureReport> FromProto(const v1::ExposureReport& proto) {
  if (proto.kinds_size() != kExposureKindCount)
    return Malformed("kinds", "not one for each kind of vector");
  if (proto.jumps() < 0 || !IsAmount(proto.jump_mm()) || !IsAmount(proto.jump_time_s()) ||
      !IsAmount(proto.area_mm2()) || !IsAmount(proto.volume_mm3()))
    return Malformed("jumps, area_mm2, volume_mm3", "not all are amounts");
  ExposureReport report;
  for (int i = 0; i < kExposureKindCount; ++i) {
    const absl::StatusOr<KindExposure> kind = KindOf(proto.kinds(i));
    if (!kind.ok()) return kind.status();
    report.kinds[static_cast<size_t>(i)] = *kind;
  }
  report.jumps = proto.jumps();
  report.jump_mm = proto.jump_mm();
  report.jump_time_s = proto.jump_time_s();
  report.area_mm2 = proto.area_mm2();
  report.volume_mm3 = proto.volume_mm3();
  const absl::StatusOr<CutCounts> cuts = CutsOf(proto.cuts());
  if (!cuts.ok()) return cuts.status();
  report.cuts = *cuts;
  const absl::StatusOr<MeltedSample> melted = MeltedOf(proto.melted());
  if (!melted.ok()) return melted.status();
  report.melted = *melted;
  const absl::StatusOr<Box> bounds = BoxFromProto(proto);
  if (!bounds.ok()) return bounds.status();
  report.bounds = *bounds;
  return report;
}

absl::Status ToProto(ExposedProgram program, v1::ExposedProgram* proto) {
  ToProto(program.frame, proto->mutable_frame());
  proto->set_text(std::move(program.text));
  return ToProto(program.report, proto->mutable_report());
}

absl::StatusOr<ExposedProgram> FromProto(v1::ExposedProgram proto) {
  const absl::StatusOr<LayerFrame> frame = FromProto(proto.frame());
  if (!frame.ok()) return frame.status();
  absl::StatusOr<ExposureReport> report = FromProto(proto.report());
  if (!report.ok()) return Within("report", report.status());
  return ExposedProgram{*frame, std::move(*proto.mutable_text()), *std::move(report)};
}

absl::Status ToProto(const ExposureSummary& summary, v1::ExposureEnvelopeRequest* proto) {
  for (const LayerFrame& layer : summary.layers) ToProto(layer, proto->add_layers());
  proto->mutable_object_names()->Assign(summary.object_names.begin(), summary.object_names.end());
  proto->set_time_s(summary.time_s);
  proto->set_settings_text(summary.settings_text);
  return BoxToProto(summary.bounds, proto);
}

absl::StatusOr<ExposureSummary> FromProto(const v1::ExposureEnvelopeRequest& proto) {
  if (absl::Status status = CheckSummary(proto); !status.ok()) return status;
  ExposureSummary summary;
  if (absl::Status status = AllFromProto(proto.layers(), "layers", &summary.layers); !status.ok())
    return status;
  const absl::StatusOr<Box> bounds = BoxFromProto(proto);
  if (!bounds.ok()) return bounds.status();
  summary.bounds = *bounds;
  summary.object_names.assign(proto.object_names().begin(), proto.object_names().end());
  summary.time_s = proto.time_s();
  summary.settings_text = proto.settings_text();
  return summary;
}

v1::ExposureEnvelope ToProto(ExposureEnvelope envelope) {
  v1::ExposureEnvelope proto;
  proto.set_header(std::move(envelope.header));
  for (std::string& head : envelope.layer_heads) proto.add_layer_heads(std::move(head));
  proto.set_footer(std::move(envelope.footer));
  return proto;
}

absl::StatusOr<ExposureEnvelope> FromProto(v1::ExposureEnvelope proto) {
  ExposureEnvelope envelope;
  envelope.header = std::move(*proto.mutable_header());
  for (std::string& head : *proto.mutable_layer_heads())
    envelope.layer_heads.push_back(std::move(head));
  envelope.footer = std::move(*proto.mutable_footer());
  return envelope;
}

}  // namespace slicefarm
