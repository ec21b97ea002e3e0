#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "common/geometry/polygon.h"
#include "common/model/layers/layer.h"
#include "common/stage/object_layers.h"

namespace slicefarm::exposure {

/// Outlines of objects' layers without the parts above powder (z compensation). The laser melts
/// `depth` layers more than the layer on which it draws. Above powder, it would otherwise fuse this
/// powder to the part.
class DeepOutlines {
 public:
  /// Keeps a reference: `objects` must outlive this object, and must have `depth` layers below each
  /// requested layer.
  explicit DeepOutlines(const ObjectLayers& objects, int32_t depth)
      : objects_(objects), depth_(depth) {}

  /// Returns the part of `outlines` (of the section) that has the object in all of the `depth`
  /// layers below. Below the object's lowest layer is the plate, which may be melted.
  MultiPolygon Of(const ObjectSection& section, MultiPolygon outlines) const;

  /// Returns the outlines of a whole layer of an object without the parts above powder, computed
  /// once, or nullptr if the layer does not exist. The pointer is valid as long as this object.
  const MultiPolygon* Find(int32_t object, int32_t layer);

 private:
  const ObjectLayers& objects_;
  const int32_t depth_;
  /// Computed outlines, indexed by object and layer.
  std::map<std::pair<int32_t, int32_t>, MultiPolygon> made_;
};

}  // namespace slicefarm::exposure
