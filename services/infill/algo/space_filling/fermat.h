#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm::infill {

struct FermatOptions {
  Coord spacing_nm = 450'000;  ///< of neighbouring lines
  double first_line = 0.5;     ///< how far inside the edge the outermost lies, in spacings
};

/// Fills a region with connected Fermat spirals: lines of constant depth below the edge, joined to
/// spirals that lead in and out again, and these to one path for each part of the region that is
/// connected where the first line runs. The path starts and ends at the edge, a spacing apart.
///
/// Parts that are less than two lines wide get two lines that lie nearer to each other. Length
/// times spacing is the region's area if the first line lies half a spacing inside: see RingsFrom.
///
/// Errors: those of CheckRingSpacing.
/// Source: Zhao et al., "Connected Fermat Spirals for Layered Fabrication", SIGGRAPH 2016, for the
///         idea; the joining is that of LinkRings.
absl::StatusOr<std::vector<Polyline>> FermatFill(const PolygonWithHoles& region,
                                                 const FermatOptions& options);

}  // namespace slicefarm::infill
