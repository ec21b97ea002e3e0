#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "absl/status/status.h"
#include "common/model/layers/layer.h"

namespace slicefarm {

/// Index of the sections in consecutive layers of a job. The key is a stack and the number of one
/// of the stack's own layers.
class ObjectLayers {
 public:
  /// Makes the index. `layers` must outlive the index.
  explicit ObjectLayers(std::span<const SlicedLayer> layers);

  /// Returns the section of layer `layer` of a stack, counted among the stack's own layers. Returns
  /// nullptr if the indexed layers do not contain it. Callers treat layers below the first and
  /// above the last layer of a stack as air. `stack`: id of the stack.
  const ObjectSection* Find(int32_t stack, int32_t layer) const;

 private:
  struct Sections {
    int32_t first = 0;  ///< number of sections[0] in the stack's own count of layers
    std::vector<const ObjectSection*> sections;
  };
  std::map<int32_t, Sections> stacks_;  ///< sections per stack id
};

/// Returns the smallest range of a job's layers that contains `range` and the halo of each stack in
/// it. The halo consists of the next `halo` layers of the stack below and above, in the stack's own
/// count. `layers`: all layers of the job. Cost: O(sections in the range * log layers).
LayerRange WithHalo(std::span<const SlicedLayer> layers, LayerRange range, int32_t halo);

/// Checks that `layers` contains `range` and the halo of each stack in it (WithHalo), as far as
/// these layers exist. Errors: REQUEST_MALFORMED.
absl::Status CheckHalo(std::span<const SlicedLayer> layers, LayerRange range, int32_t halo);

/// Returns the number of points of all outlines. Cost: O(rings).
int64_t PointsIn(std::span<const SlicedLayer> layers);

}  // namespace slicefarm
