#pragma once

#include <optional>
#include <span>

#include "common/geometry/polygon.h"
#include "processes/laser/model/exposed_layer.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {

/// A vector that lies where none may.
struct StrayVector {
  ExposureKind kind = ExposureKind::kHatch;
  Point from, to;
};

/// The last check of a region's vectors, which knows nothing of how they came about: thin walls lie
/// in the outline, all others in it and beam_compensation from it. All of each vector is looked at,
/// against the edges of the outline itself.
///
/// Vectors may be kStrayNm nearer: outlines are simplified before they are cut into pieces.
/// nullopt: all are where they may be. Cost: O(edges), and a look or two a vector; a few per cent
/// of what scanning costs.
std::optional<StrayVector> FindStray(std::span<const ExposureGroup> groups,
                                     const MultiPolygon& outline, const ExposureOptions& options);

inline constexpr Coord kStrayNm = 3'000;

}  // namespace slicefarm::exposure
