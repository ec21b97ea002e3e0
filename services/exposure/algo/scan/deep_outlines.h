#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "common/geometry/polygon.h"
#include "common/model/layers/layer.h"
#include "common/stage/object_layers.h"

namespace slicefarm::exposure {

/// Outlines of objects' layers without what lies over powder: a laser that melts `depth` layers
/// deeper than the one it draws on would melt that powder to the part (z compensation).
class DeepOutlines {
 public:
  /// `objects` must outlive it, and have `depth` layers below each that is asked for.
  explicit DeepOutlines(const ObjectLayers& objects, int32_t depth)
      : objects_(objects), depth_(depth) {}

  /// What of `outlines`, which belong to the section, has the part in all of the `depth` layers
  /// below. Below the object's lowest layer is the plate, which may be melted.
  MultiPolygon Of(const ObjectSection& section, MultiPolygon outlines) const;

  /// The same of a whole layer of an object, made once; nullptr: there is none. The reference holds
  /// as long as this.
  const MultiPolygon* Find(int32_t object, int32_t layer);

 private:
  const ObjectLayers& objects_;
  const int32_t depth_;
  std::map<std::pair<int32_t, int32_t>, MultiPolygon> made_;  ///< by object and layer
};

}  // namespace slicefarm::exposure
