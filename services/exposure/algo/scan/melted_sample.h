#pragma once

#include <cstdint>
#include <span>

#include "common/geometry/polygon.h"
#include "processes/laser/model/exposed_layer.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Samples a region of a layer along a few lines at positions that differ in each layer. Measures
/// how much of the region the laser spot melts, and with how much energy per area. The model
/// assumes that the spot is evenly hot along each vector. In reality half of the heat's spread is
/// outside of the spot. Cost: O(edges + vectors), and a sort of the vectors that meet a line.
MeltedSample SampleMelted(std::span<const ExposureGroup> groups, const MultiPolygon& outline,
                          const ExposureOptions& options, int32_t layer);

}  // namespace slicefarm::exposure
