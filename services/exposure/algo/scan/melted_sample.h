#pragma once

#include <cstdint>
#include <span>

#include "common/geometry/polygon.h"
#include "processes/laser/model/exposed_layer.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Measures how much of a region of a layer the laser spot melts, and with how much energy per
/// area. The measurement samples the region along a few lines, at other positions in each layer.
/// The model assumes that the spot heats evenly along each vector. In reality half of the heat's
/// spread is outside of the spot. Cost: O(edges + vectors), and a sort of the vectors that meet a
/// line.
MeltedSample SampleMelted(std::span<const ExposureGroup> groups, const MultiPolygon& outline,
                          const ExposureOptions& options, int32_t layer);

}  // namespace slicefarm::exposure
