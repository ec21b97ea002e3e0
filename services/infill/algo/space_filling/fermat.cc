#include "services/infill/algo/space_filling/fermat.h"

#include <algorithm>
#include <iterator>

#include "common/geometry/offset/clean_offset.h"
#include "services/infill/algo/space_filling/depth_rings.h"

namespace slicefarm::infill {

absl::StatusOr<std::vector<Polyline>> FermatFill(const PolygonWithHoles& region,
                                                 const FermatOptions& options) {
  const Coord spacing = options.spacing_nm;
  if (absl::Status status = CheckRingSpacing(region, spacing); !status.ok()) return status;
  std::vector<Polyline> paths;
  for (const PolygonWithHoles& part :
       FastOffset({region}, -FirstLineDepth(options.first_line, spacing))) {
    std::vector<Polyline> linked =
        LinkRings(RingsFrom({part}, spacing), static_cast<double>(spacing));
    std::move(linked.begin(), linked.end(), std::back_inserter(paths));
  }
  return paths;
}

}  // namespace slicefarm::infill
