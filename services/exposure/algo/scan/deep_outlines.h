#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "common/geometry/polygon.h"
#include "common/model/layers/layer.h"
#include "common/stage/object_layers.h"

namespace slicefarm::exposure {

/// Outlines of layers without the areas that are less than `depth` layers above powder (z
/// compensation). The laser melts `depth` layers more than the layer on which it draws. In these
/// areas, it would fuse powder below the part to the part.
class DeepOutlines {
 public:
  /// Keeps a reference: `objects` must outlive this object, and must have `depth` layers below each
  /// requested layer.
  explicit DeepOutlines(const ObjectLayers& objects, int32_t depth)
      : objects_(objects), depth_(depth) {}

  /// Returns the area of `outlines` (of the section) that is covered by the object in each of the
  /// `depth` layers below. The plate below the object's lowest layer counts as covered, because it
  /// may be melted.
  MultiPolygon Of(const ObjectSection& section, MultiPolygon outlines) const;

  /// Returns the outlines of a whole layer of an object without the areas above powder, or nullptr
  /// if the layer does not exist. Each layer is computed once. The pointer is valid as long as this
  /// object.
  const MultiPolygon* Find(int32_t object, int32_t layer);

 private:
  const ObjectLayers& objects_;
  const int32_t depth_;
  /// Outlines computed so far; the key is object and layer.
  std::map<std::pair<int32_t, int32_t>, MultiPolygon> made_;
};

}  // namespace slicefarm::exposure
