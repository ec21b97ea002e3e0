#include "processes/mill/job/mill_job_report.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace slicefarm::coordinator {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::array kPhaseNames = {"roughing", "finishing", "rest"};
static_assert(kPhaseNames.size() == kMillPhaseCount);

std::array<double, 3> Numbers(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

OrderedJson Box(const Eigen::AlignedBox3d& box) {
  return {{"min_mm", Numbers(box.min())}, {"max_mm", Numbers(box.max())}};
}

OrderedJson Phases(const MillReport& report, const MillLayout& layout) {
  OrderedJson phases = OrderedJson::object();
  for (int i = 0; i < kMillPhaseCount; ++i) {
    const auto phase = static_cast<MillPhase>(i);
    const PhaseReport& sums = report.phases[static_cast<size_t>(i)];
    phases[kPhaseNames[static_cast<size_t>(i)]] = {
        {"steps", std::ranges::count(layout.steps, phase, &MillStep::phase)},
        {"cut_mm", sums.cut_mm},
        {"rapid_mm", sums.rapid_mm},
        {"time_s", sums.seconds},
        {"moves", sums.moves},
        {"arcs", sums.arcs}};
  }
  return phases;
}

}  // namespace

void MillJobReport::AddTo(nlohmann::ordered_json& json) const {
  double cut = 0, rapid = 0;
  for (const PhaseReport& phase : report.phases) {
    cut += phase.cut_mm;
    rapid += phase.rapid_mm;
  }
  json["milling"] = {{"cutter", cutter},
                     {"part", Box(layout.part_mm)},
                     {"stock", Box(layout.stock_mm)},
                     {"loops", report.passes},
                     {"cut_mm", cut},
                     {"rapid_mm", rapid},
                     {"time_s", report.Seconds()},
                     {"removed_mm3", report.removed_mm3},
                     {"phases", Phases(report, layout)},
                     {"gouge_check", {{"places", report.checked}, {"gouges", report.gouges}}}};
  if (report.gouges > 0)
    json["milling"]["gouge_check"]["first_mm"] = Numbers(report.first_gouge_mm);
}

}  // namespace slicefarm::coordinator
