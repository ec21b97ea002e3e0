#pragma once

#include <cstdint>
#include <optional>

#include "common/model/layers/layer.h"
#include "common/stage/object_layers.h"
#include "services/infill/algo/skins/skins.h"

namespace slicefarm {
struct InfillOptions;
}  // namespace slicefarm

namespace slicefarm::infill {

/// Data of a section that all its fill areas share.
struct SectionView {
  Stack stack;
  int32_t layer = 0;  ///< layer number in the stack
  Coord height_nm = 0;
  bool on_bed = false;
  const ObjectLayers& stacks;
  const MultiPolygon& carried;  ///< areas directly above supports
  Coord z_nm = 0;               ///< height of the layer's middle above the stack's bottom

  /// Returns the outline of the stack in a layer, or, with `row`, only the outline of the region
  /// with these settings. Null: the stack or the region is not in the layer.
  const MultiPolygon* OutlineAt(int32_t own_layer, std::optional<int32_t> row = {}) const;

  /// Returns the height of a layer, or 0 if the stack has no such layer.
  Coord HeightAt(int32_t own_layer) const;
};

/// Returns the outlines of the layers that decide the skins of a region. `row`: only this region's
/// outlines count; none: the outlines of the whole object. Bridges depend on the whole object in
/// either case.
Cover CoverOf(const SectionView& view, const InfillOptions& options, std::optional<int32_t> row);

/// Directions of lines in a layer.
struct FillLineAngles {
  double sparse_rad = 0;
  double solid_rad = 0;
  /// True if the angle is from a template, which already contains the rotation of each layer.
  bool sparse_planned = false;
  bool solid_planned = false;
};

/// Returns the directions of lines in a layer.
FillLineAngles AnglesOf(const InfillOptions& options, int32_t layer);

}  // namespace slicefarm::infill
