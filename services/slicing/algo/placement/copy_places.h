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

/// An object whose copies want places.
struct ObjectToPlace {
  std::string_view name;
  const Polygon& footprint;  ///< around the middle of the object's box
  Point middle;              ///< of that box, from the object's origin
  std::span<const CopyInput> copies;
};

/// Returns `"name"`, or `object N, which has no name`, counted from 1.
std::string ObjectWords(std::string_view name, size_t object);

/// How a job's copies are arranged on any number of beds: part_distance_nm and clearance_radius_nm
/// apart, and with room on the bed for what the outlines grow by.
ArrangeOptions ArrangeOptionsOf(const SlicingOptions& options);

/// Where the middle of each object's box stands, one point a copy, by object; whole micrometres.
/// Copies with a place stand there, whatever else does. A copy that may stand anywhere is put into
/// the middle of the bed if it is alone and no excluded area is there, else arranged around those
/// with a place.
/// Errors: OUT_OF_BUILD_VOLUME if not all fit on the bed, naming each object with copies left over
/// and how many; those of Arrange. A copy alone is not checked.
absl::StatusOr<std::vector<std::vector<Point>>> PlaceCopies(std::span<const ObjectToPlace> objects,
                                                            const SlicingOptions& options,
                                                            const CancelToken& cancel);

}  // namespace slicefarm::slicing
