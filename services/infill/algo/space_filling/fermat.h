#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Parameters of FermatFill.
struct FermatOptions {
  Coord spacing_nm = 450'000;  ///< spacing of neighbouring lines
  double first_line = 0.5;     ///< distance of the outermost line from the boundary, in spacings
};

/// Fills a region with connected Fermat spirals. Lines at constant distances from the boundary are
/// joined into spirals that lead inwards and outwards again. All spirals within a connected part of
/// the region are joined into one path; parts that are connected only outside of the first line
/// count as separate. The path starts and ends at the boundary; its ends are a spacing apart.
///
/// Parts less than two lines wide get two lines with a smaller distance. Length times spacing is
/// the region's area if the first line is half a spacing inside: see RingsFrom.
///
/// Errors: SETTING_OUT_OF_RANGE and REQUEST_TOO_LARGE, see CheckRingSpacing. Source: the idea is
/// from Zhao et al., "Connected Fermat Spirals for Layered Fabrication", SIGGRAPH 2016; the method
/// of joining is LinkRings.
absl::StatusOr<std::vector<Polyline>> FermatFill(const PolygonWithHoles& region,
                                                 const FermatOptions& options);

}  // namespace slicefarm::infill
