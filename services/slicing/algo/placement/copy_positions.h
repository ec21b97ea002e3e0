#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "common/model/options/slicing_options.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"
#include "services/slicing/algo/placement/arranging/arrange.h"

namespace slicefarm::slicing {

/// Object with copies that need positions.
struct ObjectToPlace {
  std::string_view name;
  const Polygon& footprint;  ///< outline relative to the middle of the object's box
  Point middle;              ///< middle of the box, relative to the object's origin
  std::span<const CopyInput> copies;
};

/// Returns `"name"`, or `object N (without a name)` if the name is empty. `object`: index from 0;
/// N is counted from 1.
std::string ObjectWords(std::string_view name, size_t object);

/// Returns the options for arranging a job's copies on any number of beds. The distance of copies
/// is the larger one of part_distance_nm and clearance_radius_nm. The bed is reduced by the
/// growth of the outlines.
ArrangeOptions ArrangeOptionsOf(const SlicingOptions& options);

/// Returns the position of the middle of each copy's box, in whole micrometres, indexed by object
/// and copy.
///
/// Copies with a given position get this position, regardless of other copies. A single copy
/// without a position is placed in the middle of the bed if no excluded area is there. Otherwise
/// the copies without a position are arranged around the copies with one.
///
/// Errors: OUT_OF_BUILD_VOLUME if not all copies fit on the bed, with the names of the objects left
/// over and the numbers of their copies; any error of Arrange. A single copy is not checked.
absl::StatusOr<std::vector<std::vector<Point>>> PlaceCopies(std::span<const ObjectToPlace> objects,
                                                            const SlicingOptions& options,
                                                            const CancelToken& cancel);

}  // namespace slicefarm::slicing
