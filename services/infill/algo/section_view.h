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

/// A section as all its fill areas see it.
struct SectionView {
  Stack stack;
  int32_t layer = 0;  ///< of the stack's own
  Coord height_nm = 0;
  bool on_bed = false;
  const ObjectLayers& stacks;
  const MultiPolygon& carried;  ///< supports lie right below the section here
  Coord z_nm = 0;               ///< of the layer's middle, above the stack's bottom

  /// Of the stack, or of its region of a row alone. Null: it has none there.
  const MultiPolygon* OutlineAt(int32_t own_layer, std::optional<int32_t> row = {}) const;

  /// 0: the stack has no such layer.
  Coord HeightAt(int32_t own_layer) const;
};

/// The layers that skins of a region look at: `row` alone, or the whole object's. Bridges are where
/// the whole object is bare.
Cover CoverOf(const SectionView& view, const InfillOptions& options, std::optional<int32_t> row);

/// Which way lines run in a layer.
struct FillLineAngles {
  double sparse_rad = 0;
  double solid_rad = 0;
  bool sparse_planned = false;  ///< by a template, which says all that turns
  bool solid_planned = false;
};

FillLineAngles AnglesOf(const InfillOptions& options, int32_t layer);

}  // namespace slicefarm::infill
