#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/options/slicing_options.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"
#include "services/slicing/algo/topology/topology.h"

namespace slicefarm::slicing {

/// Part of an object, ready for slicing.
struct PreparedPart {
  ConnectedMesh connected;
  PartInput input;  ///< role of the part, and its region settings
  MeshReport report;

  /// Returns true if every edge has exactly two faces. Then there are no cracks that slicing has to
  /// close. Parts that touch along an edge are not manifold, so slicing closes a narrow gap between
  /// them like a crack.
  bool IsManifold() const { return connected.closed && report.non_manifold_edges == 0; }

  /// Returns true if the part enforces or blocks seams.
  bool IsForSeams() const {
    return input.role == PartRole::kSeamEnforcer || input.role == PartRole::kSeamBlocker;
  }
  /// Returns true if the part enforces or blocks supports.
  bool IsForSupports() const {
    return input.role == PartRole::kSupportEnforcer || input.role == PartRole::kSupportBlocker;
  }
  /// Returns true if the part is an open surface with painted marks. An open surface encloses no
  /// volume.
  bool IsMarkedSurface() const { return (IsForSeams() || IsForSupports()) && !connected.closed; }
};

/// Object around its own origin. The middle of its solid parts' box is at x = y = 0. Its bottom is
/// at z = 0, or below it by the depth to which the object is sunk.
struct PreparedObject {
  std::string name;
  std::vector<PreparedPart> parts;
  std::vector<RangeInput> ranges;
  Vertex to_origin;  ///< translation added to all positions of the object's parts
  Coord top_nm = 0;
  Polygon footprint;                           ///< convex hull of the solid parts
  Transform to_plate = Transform::Identity();  ///< transform as in the input
  std::vector<Point> shifts;                   ///< one per copy on the bed, in whole micrometres
  int64_t copies_off_bed = 0;  ///< number of copies left out because they are beside the bed
};

/// Reads the files with `source`, then places, checks and connects the parts of each object. A
/// file's bytes are freed as soon as they are read, its triangles after the last part that uses
/// them.
///
/// Errors: any error of PlaceParts and Connect. With several objects, errors have the object's
/// number (from 0, also as `object` in the metadata) and its name in the message. REQUEST_MALFORMED
/// for an object without solid parts or with a reference to a missing mesh.
absl::StatusOr<std::vector<PreparedObject>> PrepareObjects(SliceInput input,
                                                           const MeshSource& source,
                                                           const SlicingOptions& options,
                                                           const CancelToken& cancel);

}  // namespace slicefarm::slicing
