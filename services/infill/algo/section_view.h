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
  int32_t layer = 0;  ///< layer number of the stack
  Coord height_nm = 0;
  bool on_bed = false;
  const ObjectLayers& stacks;
  const MultiPolygon& carried;  ///< areas with supports directly below the section
  Coord z_nm = 0;               ///< height of the layer's middle above the stack's bottom

  /// Returns the outline of the stack in a layer, or only the outline of its region with the row
  /// `row`. Null: the layer has none.
  const MultiPolygon* OutlineAt(int32_t own_layer, std::optional<int32_t> row = {}) const;

  /// Returns the height of a layer, or 0 if the stack has no such layer.
  Coord HeightAt(int32_t own_layer) const;
};

/// Returns the layers that decide the skins of a region: the layers of region `row`, or of the
/// whole object. Bridges depend on the whole object in either case.
Cover CoverOf(const SectionView& view, const InfillOptions& options, std::optional<int32_t> row);

/// Directions of lines in a layer.
struct FillLineAngles {
  double sparse_rad = 0;
  double solid_rad = 0;
  bool sparse_planned = false;  ///< the angle is from a template, which contains all turns
  bool solid_planned = false;
};

/// Returns the directions of lines in a layer.
FillLineAngles AnglesOf(const InfillOptions& options, int32_t layer);

}  // namespace slicefarm::infill
