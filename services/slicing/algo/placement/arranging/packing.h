#pragma once

#include <optional>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// Footprint in one of its allowed rotations, prepared for packing.
struct ShapeVariant {
  double rotation_deg = 0;
  Polygon hull;
  Box box;
  std::vector<Polygon> parts;     ///< convex pieces of the footprint
  std::vector<Polygon> mirrored;  ///< pieces mirrored at the origin and grown by the distance
  /// convex regions of translations that would put a piece into an excluded area
  std::vector<Polygon> kept_off;
};
/// Makes a variant of a footprint. `excluded`: convex pieces of the bed's excluded areas. REQUIRES:
/// the footprint is not empty.
ShapeVariant MakeVariant(const Polygon& footprint, double rotation_deg, Coord distance_nm,
                         std::span<const Polygon> excluded = {});

/// Returns the translations that put one of the convex `parts` into an excluded area: one polygon
/// for each pair of a part and an area.
std::vector<Polygon> KeptOff(std::span<const Polygon> parts, std::span<const Polygon> excluded);

/// Variants of one footprint, the preferred rotation first.
using Shape = std::vector<ShapeVariant>;

/// Part with a fixed position on a plate.
struct StandingPart {
  std::vector<Polygon> parts;
  int plate = 0;
};

/// Input of Pack.
struct PackingTask {
  Polygon bed;                         ///< bed, convex, counter-clockwise
  std::vector<Polygon> excluded = {};  ///< convex areas of the bed where nothing may be placed
  std::vector<Shape> shapes;
  /// index in `shapes` of each item, in the order in which items are placed
  std::vector<size_t> sequence;
  std::vector<StandingPart> standing;  ///< fixed parts on plates 0, 1, ...
  int max_plates = 0;                  ///< largest number of plates; 0: no limit
};

/// Position of an item in a packing.
struct PackedItem {
  int plate = 0;
  size_t variant = 0;
  Point translation;
};
/// Result of Pack.
struct Packing {
  /// position of each item, in the order of PackingTask::sequence; nullopt: it fits on no plate
  std::vector<std::optional<PackedItem>> items;
  int plates = 0;  ///< number of plates with an item or a fixed part
};

/// Preferred position of an item on a plate.
enum class PackingOrder {
  kFromMiddle,  ///< nearest to the bed's middle
  kFromFront,   ///< farthest to the front, then farthest to the left
};

/// Packs greedily: each item goes to the first plate that has a free position for it. Of the free
/// positions on that plate (FreePositions), `order` decides. Items that fit on no plate get no
/// position.
///
/// Errors: CANCELLED. Cost: O(k m) per item, for the k parts with m corners each on the item's
/// plate. If consecutive items in the sequence have different shapes, the second one costs at worst
/// O(k^2 m^2) for each plate that is tried.
absl::StatusOr<Packing> Pack(const PackingTask& task, PackingOrder order,
                             const CancelToken& cancel);

}  // namespace slicefarm::slicing
