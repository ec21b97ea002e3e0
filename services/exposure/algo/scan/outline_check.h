#pragma once

#include <optional>
#include <span>

#include "common/geometry/polygon.h"
#include "processes/laser/model/exposed_layer.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {

/// Vector that is nearer to the outline than permitted.
struct StrayVector {
  ExposureKind kind = ExposureKind::kHatch;
  Point from, to;
};

/// Returns the first vector of a region that is at a forbidden position, or nullopt. Thin walls
/// must be inside the outline; all other vectors must also keep beam_compensation from it. This
/// final check does not use the code that creates the vectors. It compares the whole of each vector
/// with the edges of the outline itself.
///
/// Vectors may be nearer by kStrayNm, because outlines are simplified before they are cut into
/// pieces. Cost: O(edges), and one or two grid queries per vector; a few per cent of the cost of
/// scanning.
std::optional<StrayVector> FindStray(std::span<const ExposureGroup> groups,
                                     const MultiPolygon& outline, const ExposureOptions& options);

/// Distance in nm by which a vector may be nearer to the outline than required.
inline constexpr Coord kStrayNm = 3'000;

}  // namespace slicefarm::exposure
