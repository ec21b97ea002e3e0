#include "common/wire/milling/milled_wire.h"

#include <cmath>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/geometry_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

static_assert(v1::MILL_PHASE_REST == static_cast<int>(MillPhase::kRest) + 1);

/// Largest coordinate of the tip, equal to the limit for outlines.
constexpr double kMostRunMm = static_cast<double>(limits::kMaxCoord) / 1e6;

using Numbers = google::protobuf::RepeatedField<double>;

bool AreFinite(const Numbers& numbers) {
  for (const double number : numbers)
    if (!std::isfinite(number)) return false;
  return true;
}

void PutPoint(const Eigen::Vector3d& p, Numbers* numbers) {
  for (const double c : {p.x(), p.y(), p.z()}) numbers->Add(c);
}

Eigen::Vector3d PointAt(const Numbers& numbers, int i) {
  return {numbers[i], numbers[i + 1], numbers[i + 2]};
}

absl::Status ToProto(const CutArea& area, v1::CutArea* proto) {
  absl::Status status = slicefarm::ToProto(MultiPolygon{area.area}, proto->mutable_area());
  MultiPolygon passes;
  for (const Polygon& path : area.passes) passes.push_back({path, {}});
  status.Update(slicefarm::ToProto(passes, proto->mutable_passes()));
  return status;
}

absl::StatusOr<CutArea> AreaOf(const v1::CutArea& proto) {
  absl::StatusOr<MultiPolygon> area = FromProto(proto.area());
  if (!area.ok()) return Within("area", area.status());
  if (area->size() != 1) return Malformed("area", "is not one island");
  absl::StatusOr<MultiPolygon> passes = FromProto(proto.passes());
  if (!passes.ok()) return Within("passes", passes.status());
  CutArea cut{std::move(area->front()), {}};
  for (PolygonWithHoles& path : *passes) {
    if (!path.holes.empty()) return Malformed("passes", "a pass has holes");
    cut.passes.push_back(std::move(path.outer));
  }
  return cut;
}

absl::StatusOr<RestRun> RunOf(const v1::RestRun& proto) {
  if (proto.xyz_mm_size() % 3 != 0) return Malformed("xyz_mm", "not three numbers a point");
  if (!AreFinite(proto.xyz_mm())) return Malformed("xyz_mm", "is not finite");
  if (proto.xyz_mm_size() < 6) return Malformed("xyz_mm", "fewer than two points");
  for (const double number : proto.xyz_mm())
    if (std::abs(number) > kMostRunMm) return Malformed("xyz_mm", "is out of range");
  RestRun run;
  for (int i = 0; i < proto.xyz_mm_size(); i += 3) run.push_back(PointAt(proto.xyz_mm(), i));
  return run;
}

void PutBox(const Eigen::AlignedBox3d& box, Numbers* numbers) {
  PutPoint(box.min(), numbers);
  PutPoint(box.max(), numbers);
}

absl::StatusOr<Eigen::AlignedBox3d> BoxOf(const Numbers& numbers, std::string_view field) {
  if (numbers.size() != 6 || !AreFinite(numbers)) return Malformed(field, "not six numbers");
  return Eigen::AlignedBox3d(PointAt(numbers, 0), PointAt(numbers, 3));
}

absl::StatusOr<MillStep> StepOf(v1::MillPhase proto, double at_mm) {
  const auto phase = EnumFromProto<MillPhase>(proto, kMillPhaseCount, "phase");
  if (!phase.ok()) return phase.status();
  if (!std::isfinite(at_mm)) return Malformed("at_mm", "is not finite");
  return MillStep{*phase, at_mm};
}

}  // namespace

absl::Status ToProto(const MilledStep& step, v1::MilledStep* proto) {
  proto->set_phase(EnumToProto<v1::MillPhase>(step.step.phase));
  proto->set_at_mm(step.step.at_mm);
  for (const CutArea& area : step.areas)
    if (absl::Status put = ToProto(area, proto->add_areas()); !put.ok()) return put;
  for (const RestRun& run : step.runs) {
    Numbers* numbers = proto->add_runs()->mutable_xyz_mm();
    for (const Eigen::Vector3d& p : run) PutPoint(p, numbers);
  }
  return absl::OkStatus();
}

absl::StatusOr<MilledStep> FromProto(const v1::MilledStep& proto) {
  const absl::StatusOr<MillStep> step = StepOf(proto.phase(), proto.at_mm());
  if (!step.ok()) return step.status();
  MilledStep milled{*step, {}, {}};
  for (int i = 0; i < proto.areas_size(); ++i) {
    absl::StatusOr<CutArea> area = AreaOf(proto.areas(i));
    if (!area.ok()) return Within("areas", i, area.status());
    milled.areas.push_back(*std::move(area));
  }
  for (int i = 0; i < proto.runs_size(); ++i) {
    absl::StatusOr<RestRun> run = RunOf(proto.runs(i));
    if (!run.ok()) return Within("runs", i, run.status());
    milled.runs.push_back(*std::move(run));
  }
  return milled;
}

absl::Status ToProto(const MillLayout& layout, v1::MillLayout* proto) {
  for (const MillStep& step : layout.steps) {
    proto->add_phases(EnumToProto<v1::MillPhase>(step.phase));
    proto->add_at_mm(step.at_mm);
  }
  for (const int32_t weight : layout.weights) proto->add_weights(weight);
  PutBox(layout.part_mm, proto->mutable_part_mm());
  PutBox(layout.stock_mm, proto->mutable_stock_mm());
  return absl::OkStatus();
}

absl::StatusOr<MillLayout> FromProto(const v1::MillLayout& proto) {
  if (proto.phases_size() > limits::kMaxMillSteps)
    return LimitError(Reason::kRequestTooLarge, "levels and rows", limits::kMaxMillSteps,
                      proto.phases_size());
  if (proto.at_mm_size() != proto.phases_size() || proto.weights_size() != proto.phases_size())
    return Malformed("at_mm, weights", "are not one for each step");
  MillLayout layout;
  for (int i = 0; i < proto.phases_size(); ++i) {
    const absl::StatusOr<MillStep> step = StepOf(proto.phases(i), proto.at_mm(i));
    if (!step.ok()) return step.status();
    layout.steps.push_back(*step);
    if (proto.weights(i) < 1 || proto.weights(i) > limits::kMaxMillWeight)
      return Malformed("weights", "not all are weights");
    layout.weights.push_back(proto.weights(i));
  }
  const auto part = BoxOf(proto.part_mm(), "part_mm"), stock = BoxOf(proto.stock_mm(), "stock_mm");
  if (!part.ok()) return part.status();
  if (!stock.ok()) return stock.status();
  layout.part_mm = *part;
  layout.stock_mm = *stock;
  return layout;
}

absl::Status ToProto(const MillReport& report, v1::MillReport* proto) {
  for (const PhaseReport& phase : report.phases) {
    v1::PhaseReport* to = proto->add_phases();
    to->set_cut_mm(phase.cut_mm);
    to->set_rapid_mm(phase.rapid_mm);
    to->set_seconds(phase.seconds);
    to->set_moves(phase.moves);
    to->set_arcs(phase.arcs);
  }
  proto->set_passes(report.passes);
  proto->set_removed_mm3(report.removed_mm3);
  proto->set_checked(report.checked);
  proto->set_gouges(report.gouges);
  PutPoint(report.first_gouge_mm, proto->mutable_first_gouge_mm());
  return absl::OkStatus();
}

absl::StatusOr<MillReport> FromProto(const v1::MillReport& proto) {
  if (proto.phases_size() != kMillPhaseCount) return Malformed("phases", "not one for each");
  if (proto.first_gouge_mm_size() != 3) return Malformed("first_gouge_mm", "not three numbers");
  MillReport report;
  for (int i = 0; i < kMillPhaseCount; ++i) {
    const v1::PhaseReport& phase = proto.phases(i);
    for (const double amount : {phase.cut_mm(), phase.rapid_mm(), phase.seconds()})
      if (!(amount >= 0) || !std::isfinite(amount)) return Malformed("phases", "no amount");
    report.phases[static_cast<size_t>(i)] = {phase.cut_mm(), phase.rapid_mm(), phase.seconds(),
                                             phase.moves(), phase.arcs()};
  }
  report.passes = proto.passes();
  report.removed_mm3 = proto.removed_mm3();
  report.checked = proto.checked();
  report.gouges = proto.gouges();
  report.first_gouge_mm = PointAt(proto.first_gouge_mm(), 0);
  return report;
}

v1::StepRange ToProto(StepRange range) {
  v1::StepRange proto;
  proto.set_first(range.first);
  proto.set_last(range.last);
  return proto;
}

absl::StatusOr<StepRange> FromProto(const v1::StepRange& proto) {
  const bool sound =
      0 <= proto.first() && proto.first() < proto.last() && proto.last() <= limits::kMaxMillSteps;
  if (!sound) return Malformed("range", "is no range of steps");
  return StepRange{proto.first(), proto.last()};
}

}  // namespace slicefarm
