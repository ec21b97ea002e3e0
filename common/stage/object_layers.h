#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "absl/status/status.h"
#include "common/model/layers/layer.h"

namespace slicefarm {

/// Looks sections up by stack and by the stack's own layer, in a stretch of a job's layers.
class ObjectLayers {
 public:
  /// `layers` must outlive this.
  explicit ObjectLayers(std::span<const SlicedLayer> layers);

  /// `stack`: its id. nullptr: there is no such layer here. Above and below a stack is air.
  const ObjectSection* Find(int32_t stack, int32_t layer) const;

 private:
  struct Sections {
    int32_t first = 0;  ///< own layer of sections[0]
    std::vector<const ObjectSection*> sections;
  };
  std::map<int32_t, Sections> stacks_;  ///< by id
};

/// The smallest stretch of `layers` that has, for each stack in `range`, its own layers `halo`
/// below and above. `layers` are a whole job's. Cost: O(sections in the range * log layers).
LayerRange WithHalo(std::span<const SlicedLayer> layers, LayerRange range, int32_t halo);

/// REQUEST_MALFORMED unless each stack in the range comes with its `halo` layers below and above,
/// as far as the stack has them.
absl::Status CheckHalo(std::span<const SlicedLayer> layers, LayerRange range, int32_t halo);

/// How many points the outlines have. Cost: O(rings).
int64_t PointsIn(std::span<const SlicedLayer> layers);

}  // namespace slicefarm
