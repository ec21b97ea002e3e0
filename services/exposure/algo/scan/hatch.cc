#include "services/exposure/algo/scan/hatch.h"

#include "processes/laser/model/exposure_options.h"
#include "services/exposure/algo/scan/cell_lines.h"
#include "services/exposure/algo/scan/serpentines.h"

namespace slicefarm::exposure {

absl::StatusOr<std::vector<Point>> Hatch(const HatchRegion& region, double angle_deg,
                                         const ExposureOptions& options, Point from) {
  auto blocks = options.strategy == ScanStrategy::kHatch
                    ? SerpentineBlocks(region, angle_deg, options)
                    : CellBlocks(region, angle_deg, options);
  if (!blocks.ok()) return blocks.status();
  return InOrder(*blocks, options, from);
}

}  // namespace slicefarm::exposure
