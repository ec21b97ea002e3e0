#include "services/coordinator/algo/pipeline/preflight.h"

#include <algorithm>
#include <utility>

#include "common/geometry/measure.h"
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

}  // namespace

absl::StatusOr<Preflight> LookAt(const StageCall& call, JobInput input,
                                 const SlicingStage& slicing) {
  auto sliced = slicing.Slice(call, std::move(input.meshes), input.settings.slicing);
  if (!sliced.ok()) return sliced.status();
  if (absl::Status printable = CheckPrintable(sliced->layers); !printable.ok()) return printable;
  Preflight found;
  found.layers = static_cast<int32_t>(sliced->layers.size());
  found.first_layer_area_mm2 = AreaMm2(sliced->layers.front(), sliced->copies);
  found.estimate = EstimatePrint({sliced->layers, sliced->copies}, input.settings);
  found.meshes = std::move(sliced->meshes);
  found.warnings = std::move(input.warnings);
  for (const MeshReport& mesh : found.meshes) {
    for (std::string& warning : MeshWarnings(mesh)) found.warnings.push_back(std::move(warning));
  }
  return found;
}

}  // namespace slicefarm::coordinator
