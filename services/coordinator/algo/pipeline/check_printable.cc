#include "services/coordinator/algo/pipeline/check_printable.h"

#include <algorithm>

#include "common/base/error.h"

namespace slicefarm::coordinator {

absl::Status CheckPrintable(std::span<const SlicedLayer> layers) {
  const bool printable = std::any_of(layers.begin(), layers.end(), [](const SlicedLayer& layer) {
    return std::ranges::any_of(
        layer.sections, [](const ObjectSection& section) { return !section.regions.empty(); });
  });
  if (printable) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
                   "no layer of the meshes has an outline to print");
}

}  // namespace slicefarm::coordinator
