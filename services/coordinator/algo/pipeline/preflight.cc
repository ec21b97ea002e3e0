#include "services/coordinator/algo/pipeline/preflight.h"

#include <algorithm>
#include <utility>

#include "common/geometry/measure.h"
#include "services/coordinator/algo/pipeline/check_printable.h"
#include "services/coordinator/algo/pipeline/exposure_estimate.h"
#include "services/coordinator/algo/pipeline/mesh_warnings.h"
#include "services/coordinator/algo/pipeline/pass_facts.h"

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

/// Only complete_objects changes the number of layers; what else planning refuses comes with the
/// job.
absl::StatusOr<int32_t> CountLayers(const StageCall& call, const SlicedJob& job,
                                    const PlanningOptions& options,
                                    const PlanningStage& planning) {
  if (!options.sequence.complete_objects) return static_cast<int32_t>(job.layers.size());
  const auto plan = planning.Plan(call, {job.layers, job.copies, job.object_names}, options);
  if (!plan.ok()) return plan.status();
  return PassesOf(job.layers, plan->copies).layer_count;
}

}  // namespace

absl::StatusOr<Preflight> LookAt(const StageCall& call, JobInput input,
                                 const SlicingStage& slicing, const PlanningStage& planning) {
  auto sliced = slicing.Slice(call, std::move(input.meshes), input.settings.slicing);
  if (!sliced.ok()) return sliced.status();
  if (absl::Status printable = CheckPrintable(sliced->layers); !printable.ok()) return printable;
  Preflight found;
  const auto layers = CountLayers(call, *sliced, input.settings.planning, planning);
  if (!layers.ok()) return layers.status();
  found.layers = *layers;
  found.first_layer_area_mm2 = AreaMm2(sliced->layers.front(), sliced->copies);
  found.estimate = input.settings.process == Process::kLaser
                       ? EstimateExposure({sliced->layers, sliced->copies}, input.settings.exposure)
                       : EstimatePrint({sliced->layers, sliced->copies}, input.settings);
  found.meshes = std::move(sliced->meshes);
  found.orientations = std::move(sliced->orientations);
  found.warnings = std::move(input.warnings);
  for (const MeshReport& mesh : found.meshes) {
    for (std::string& warning : MeshWarnings(mesh)) found.warnings.push_back(std::move(warning));
  }
  return found;
}

}  // namespace slicefarm::coordinator
