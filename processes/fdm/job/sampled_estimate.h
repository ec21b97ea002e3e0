#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/model/layers/job_plan.h"
#include "processes/fdm/job/print_estimate.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::coordinator {

/// What a layer takes that was made, from rest to rest, all copies.
struct LayerSample {
  int32_t layer = 0;
  double time_s = 0;
  double filament_mm = 0;

  friend bool operator==(const LayerSample&, const LayerSample&) = default;
};

struct LayerSamples {
  std::vector<LayerSample> layers;  ///< upwards
  double around_s = 0;              ///< of the print: before, between and after its layers
};

/// Which layers to make to see what all take: the first one, those of the plate's own stacks such as
/// rafts (the lowest few), and the middles of stretches that take about as long by the rough
/// estimate, which is one a layer of the print. Upwards, each once. REQUIRES: layers.
std::vector<int32_t> LayersToSample(std::span<const LayerEstimate> layers,
                                    std::span<const SlicedLayer> print);

/// What all layers take: by how much the samples are off the rough estimate, so much, between
/// samples in proportion, the others are taken to be. Cost: O(layers).
JobEstimate EstimateFrom(const LayerSamples& samples, std::span<const LayerEstimate> layers,
                         const MotionOptions& motion);

}  // namespace slicefarm::coordinator
