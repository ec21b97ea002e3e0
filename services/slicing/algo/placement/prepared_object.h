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

/// A part of an object, ready to be cut.
struct PreparedPart {
  ConnectedMesh connected;
  PartInput input;  ///< what it is for, and the rows of its settings
  MeshReport report;

  /// Every edge has two faces: sections need no closing of cracks. Parts that touch along edges are
  /// not manifold: what little keeps them apart is taken for the crack that it is.
  bool IsManifold() const { return connected.closed && report.non_manifold_edges == 0; }

  bool IsForSeams() const {
    return input.role == PartRole::kSeamEnforcer || input.role == PartRole::kSeamBlocker;
  }
  bool IsForSupports() const {
    return input.role == PartRole::kSupportEnforcer || input.role == PartRole::kSupportBlocker;
  }
  /// Marks may be painted on a surface that encloses nothing.
  bool IsMarkedSurface() const { return (IsForSeams() || IsForSupports()) && !connected.closed; }
};

/// An object around its own origin: the middle of its solid parts' box lies over x = y = 0, and its
/// bottom at z = 0, or below by as much as it is sunk.
struct PreparedObject {
  std::string name;
  std::vector<PreparedPart> parts;
  std::vector<RangeInput> ranges;
  Vertex to_origin;  ///< what was added to all places of its parts
  Coord top_nm = 0;
  Polygon footprint;                           ///< convex hull of the solid parts
  Transform to_plate = Transform::Identity();  ///< as in the input
  std::vector<Point> shifts;   ///< one a copy, in whole micrometres; of those on the bed
  int64_t copies_off_bed = 0;  ///< that are left out
};

/// Reads the files by `source`, then places, checks and connects the parts of each object. A file's
/// bytes are freed as soon as they are read, its triangles after the last part that has them.
/// Errors: those of the steps; with several objects, the object's number (from 0, also as `object`
/// in the metadata) and its name in the message. REQUEST_MALFORMED for an object without solid
/// parts, or that refers to a mesh that is not there.
absl::StatusOr<std::vector<PreparedObject>> PrepareObjects(SliceInput input,
                                                           const MeshSource& source,
                                                           const SlicingOptions& options,
                                                           const CancelToken& cancel);

}  // namespace slicefarm::slicing
