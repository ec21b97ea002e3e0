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

/// Measured time and filament of a sample layer, for all copies. The time begins and ends at a
/// standstill.
struct LayerSample {
  int32_t layer = 0;
  double time_s = 0;
  double filament_mm = 0;

  friend bool operator==(const LayerSample&, const LayerSample&) = default;
};

/// Sample layers of a print, and the time outside of layers.
struct LayerSamples {
  std::vector<LayerSample> layers;  ///< in ascending order
  double around_s = 0;              ///< time before, between and after the layers
};

/// Returns the indexes of the layers to make as samples, ascending, each once: the first layer, the
/// lowest few layers of the plate's own stacks such as rafts, and the middles of intervals with
/// about equal times. These times are the rough estimates in `layers`, one per layer of the print.
/// REQUIRES: `layers` is not empty.
std::vector<int32_t> LayersToSample(std::span<const LayerEstimate> layers,
                                    std::span<const SlicedLayer> print);

/// Returns the estimate of the whole print. It corrects the rough estimate of each layer by the
/// error that the samples show, interpolated between samples. Cost: O(layers).
JobEstimate EstimateFrom(const LayerSamples& samples, std::span<const LayerEstimate> layers,
                         const MotionOptions& motion);

}  // namespace slicefarm::coordinator
