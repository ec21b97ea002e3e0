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

  /// Returns the section of a stack in its own layer `layer`, or nullptr if the range does not
  /// contain it. `stack`: id of the stack. Below and above a stack is air.
  const ObjectSection* Find(int32_t stack, int32_t layer) const;

 private:
  struct Sections {
    int32_t first = 0;  ///< own layer of sections[0]
    std::vector<const ObjectSection*> sections;
  };
  std::map<int32_t, Sections> stacks_;  ///< sections per stack id
};

/// Returns the smallest range of `layers` that has `halo` own layers below and above for each stack
/// in `range`. `layers`: all layers of the job. Cost: O(sections in the range * log layers).
LayerRange WithHalo(std::span<const SlicedLayer> layers, LayerRange range, int32_t halo);

/// Checks that each stack in the range has its `halo` layers below and above, if they exist.
/// Errors: REQUEST_MALFORMED.
absl::Status CheckHalo(std::span<const SlicedLayer> layers, LayerRange range, int32_t halo);

/// Returns the number of points of all outlines. Cost: O(rings).
int64_t PointsIn(std::span<const SlicedLayer> layers);

}  // namespace slicefarm
