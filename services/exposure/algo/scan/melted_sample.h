#pragma once

#include <cstdint>
#include <span>

#include "common/geometry/polygon.h"
#include "processes/laser/model/exposed_layer.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Samples a region of a layer along a few lines that lie elsewhere in each layer: how much of it a
/// spot melts, and with how much energy by area. Each vector's spot is taken for evenly hot; half
/// of what heat spreads to is beyond this. Cost: O(edges + vectors), and a sort of those that meet
/// a line.
MeltedSample SampleMelted(std::span<const ExposureGroup> groups, const MultiPolygon& outline,
                          const ExposureOptions& options, int32_t layer);

}  // namespace slicefarm::exposure
