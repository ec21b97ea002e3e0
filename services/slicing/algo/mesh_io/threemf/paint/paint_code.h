#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/vector.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing::threemf {

/// Each level halves edges: from 10 m down to nanometres are 34.
inline constexpr int64_t kMaxPaintLevels = 64;

/// What a piece of a triangle is painted with. States beyond these are other paint's: kNone.
enum class PaintState : uint8_t { kNone, kEnforcer, kBlocker };

using Facet = std::array<Vector3, 3>;

/// A piece of a painted triangle that is painted evenly; its corners run as the triangle's do.
struct PaintedPiece {
  Facet corners;
  PaintState state = PaintState::kNone;
};

/// The pieces that the paint of `triangle` divides it into, those without paint as well: together
/// they are the triangle, and their number depends on `code` alone. Pieces of triangles that share
/// an edge have the same points on it.
///
/// `code`: as the slicers write it: hexadecimal digits, from the last to the first. The low two
/// bits of a digit are the number of edges that are halved. If 0, it is a piece, and the high two
/// are its state, where 3 says that the state less 3 follows (in digits, each 15 says that there is
/// one more). Else they are the corner that the division begins at, and the parts of the division
/// follow, from the last on.
/// Errors: MESH_MALFORMED for what is no such code, and for more than kMaxPaintLevels levels.
/// Cost: O(digits). Source: PrusaSlicer, TriangleSelector.cpp (the format).
absl::StatusOr<std::vector<PaintedPiece>> PaintedPieces(std::string_view code,
                                                        const Facet& triangle);

}  // namespace slicefarm::slicing::threemf
