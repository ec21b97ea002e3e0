#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "absl/status/status.h"
#include "common/model/layers/layer.h"

namespace slicefarm {

/// Index of the sections in a range of a job's layers, by stack and by the stack's own layer.
class ObjectLayers {
 public:
  /// Makes the index. `layers` must outlive it.
  explicit ObjectLayers(std::span<const SlicedLayer> layers);

  /// Returns the section of a stack in its own layer `layer`, or nullptr if the indexed layers do
  /// not contain it. Callers treat layers below the first and above the last layer of a stack as
  /// air. `stack`: id of the stack.
  const ObjectSection* Find(int32_t stack, int32_t layer) const;

 private:
  struct Sections {
    int32_t first = 0;  ///< number of sections[0] among the stack's own layers
    std::vector<const ObjectSection*> sections;
  };
  std::map<int32_t, Sections> stacks_;  ///< sections per stack id
};

/// Returns the smallest range of `layers` that contains, for each stack in `range`, `halo` more of
/// the stack's own layers below and above. `layers`: all layers of the job. Cost: O(sections in the
/// range * log layers).
LayerRange WithHalo(std::span<const SlicedLayer> layers, LayerRange range, int32_t halo);

/// Checks that `layers` contains, for each stack in the range, `halo` more of the stack's own
/// layers below and above, if they exist. Errors: REQUEST_MALFORMED.
absl::Status CheckHalo(std::span<const SlicedLayer> layers, LayerRange range, int32_t halo);

/// Returns the number of points of all outlines. Cost: O(rings).
int64_t PointsIn(std::span<const SlicedLayer> layers);

}  // namespace slicefarm
