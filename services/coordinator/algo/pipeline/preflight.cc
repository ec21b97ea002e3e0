#include "services/coordinator/algo/pipeline/preflight.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/geometry/measure.h"
#include "services/coordinator/algo/pipeline/check_printable.h"
#include "services/coordinator/algo/pipeline/mesh_warnings.h"

namespace slicefarm::coordinator {
namespace {

/// Returns the area of the layer over all copies of its objects.
double AreaMm2(const SlicedLayer& layer, const std::vector<PlacedCopy>& copies) {
  double nm2 = 0;
  for (const ObjectSection& section : layer.sections) {
    const auto count = std::ranges::count(copies, section.stack.object, &PlacedCopy::object);
    nm2 += static_cast<double>(count) * Area(OutlineOf(section));
  }
  return nm2 * 1e-12;
}

absl::Status SliceIt(const StageCall& call, const SlicingStage& slicing, JobInput& input,
                     SlicedJob& sliced, Preflight& found) {
  auto made = slicing.Slice(call, std::move(input.meshes), input.settings.slicing);
  if (!made.ok()) return made.status();
  sliced = *std::move(made);
  if (absl::Status printable = CheckPrintable(sliced.layers); !printable.ok()) return printable;
  found.layers = static_cast<int32_t>(sliced.layers.size());
  found.first_layer_area_mm2 = AreaMm2(sliced.layers.front(), sliced.copies);
  found.meshes = std::move(sliced.meshes);
  found.orientations = std::move(sliced.orientations);
  for (const MeshReport& mesh : found.meshes) {
    for (std::string& warning : MeshWarnings(mesh)) found.warnings.push_back(std::move(warning));
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<Preflight> LookAt(const StageCall& call, JobInput input, const SlicingStage& slicing,
                                 const JobPipeline& pipeline) {
  const JobProcess* process = pipeline.Find(input.settings.process());
  if (process == nullptr) return ProcessUnavailable(input.settings.process());
  Preflight found;
  found.warnings = std::move(input.warnings);
  SlicedJob sliced;
  if (process->EstimatesByOutlines()) {
    absl::Status status = SliceIt(call, slicing, input, sliced, found);
    if (!status.ok()) return status;
  }
  auto estimate = process->Estimate(call, std::move(sliced), std::move(input), pipeline.executor());
  if (!estimate.ok()) return estimate.status();
  found.layers = estimate->layers.value_or(found.layers);
  found.print_time_s = estimate->print_time_s;
  found.filament = estimate->filament;
  std::ranges::move(estimate->meshes, std::back_inserter(found.meshes));
  std::ranges::move(estimate->warnings, std::back_inserter(found.warnings));
  return found;
}

}  // namespace slicefarm::coordinator
