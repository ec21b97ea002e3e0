#include "services/coordinator/algo/pipeline/preflight.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/geometry/measure.h"
#include "processes/fdm/job/bed_warnings.h"
#include "processes/fdm/job/pass_facts.h"
#include "processes/laser/job/exposure_estimate.h"
#include "services/coordinator/algo/pipeline/check_printable.h"
#include "services/coordinator/algo/pipeline/mesh_warnings.h"

namespace slicefarm::coordinator {
namespace {

/// Of all copies.
double AreaMm2(const SlicedLayer& layer, const std::vector<PlacedCopy>& copies) {
  double nm2 = 0;
  for (const ObjectSection& section : layer.sections) {
    const auto count = std::ranges::count(copies, section.object, &PlacedCopy::object);
    nm2 += static_cast<double>(count) * Area(OutlineOf(section));
  }
  return nm2 * 1e-12;
}

/// Plates of FDM are planned, and some of their layers made, where there is somebody to make them.
absl::StatusOr<PrintEstimate> EstimateOf(const StageCall& call, SlicedJob sliced, JobInput input,
                                         const PlanningStage& planning, const Sampling* sampling,
                                         Preflight& found) {
  const JobSettings& settings = input.settings;
  if (settings.process == Process::kLaser)
    return EstimateExposure({sliced.layers, sliced.copies}, settings.exposure);
  const bool samples = sampling != nullptr && sampling->executor.Slots(Process::kFdm) > 0;
  if (!samples && !settings.planning.sequence.complete_objects)
    return EstimatePrint({sliced.layers, sliced.copies}, settings);
  PlanningOptions options = settings.planning;
  options.infill = InfillPlansOf(settings);
  auto plan = planning.Plan(call, {sliced.layers, sliced.copies, sliced.object_names}, options);
  if (!plan.ok()) return plan.status();
  if (settings.planning.sequence.complete_objects)
    found.layers = PassesOf(sliced.layers, plan->copies).layer_count;
  if (!samples) return EstimatePrint({sliced.layers, sliced.copies}, settings);
  std::ranges::move(BedWarnings(plan->additions, options.bed, sliced.copies, sliced.object_names),
                    std::back_inserter(found.warnings));
  const std::vector<LayerEstimate> rough = EstimateLayers({sliced.layers, sliced.copies}, settings);
  const std::vector<int32_t> layers = LayersToSample(rough, plan->additions);
  const MotionOptions motion = settings.motion;
  const auto made =
      sampling->fdm.Sample(call,
                           {std::move(sliced), *std::move(plan), std::move(input.settings),
                            std::move(input.settings_text)},
                           layers, sampling->executor);
  if (!made.ok()) return made.status();
  return EstimateFrom(*made, rough, motion);
}

}  // namespace

absl::StatusOr<Preflight> LookAt(const StageCall& call, JobInput input, const SlicingStage& slicing,
                                 const PlanningStage& planning, const Sampling* sampling) {
  auto sliced = slicing.Slice(call, std::move(input.meshes), input.settings.slicing);
  if (!sliced.ok()) return sliced.status();
  if (absl::Status printable = CheckPrintable(sliced->layers); !printable.ok()) return printable;
  Preflight found;
  found.layers = static_cast<int32_t>(sliced->layers.size());
  found.first_layer_area_mm2 = AreaMm2(sliced->layers.front(), sliced->copies);
  found.meshes = std::move(sliced->meshes);
  found.orientations = std::move(sliced->orientations);
  found.warnings = std::move(input.warnings);
  for (const MeshReport& mesh : found.meshes) {
    for (std::string& warning : MeshWarnings(mesh)) found.warnings.push_back(std::move(warning));
  }
  auto estimate = EstimateOf(call, *std::move(sliced), std::move(input), planning, sampling, found);
  if (!estimate.ok()) return estimate.status();
  found.estimate = *estimate;
  return found;
}

}  // namespace slicefarm::coordinator
