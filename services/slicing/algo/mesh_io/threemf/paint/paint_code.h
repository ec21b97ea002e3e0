#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/vector.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing::threemf {

/// Largest number of levels of division. Each level halves edges: 34 levels lead from 10 m down to
/// nanometres.
inline constexpr int64_t kMaxPaintLevels = 64;

/// State of a piece of a triangle. Paint other than enforcers and blockers is read as kNone.
enum class PaintState : uint8_t { kNone, kEnforcer, kBlocker };

/// Corners of a triangle, in mm.
using Facet = std::array<Vector3, 3>;

/// Evenly painted piece of a painted triangle. Its corners have the orientation of the triangle.
struct PaintedPiece {
  Facet corners;
  PaintState state = PaintState::kNone;
};

/// Returns the pieces into which the paint divides `triangle`, unpainted pieces included. Together
/// they cover the triangle. Their number depends on `code` alone. If two triangles share an edge,
/// the pieces on both sides have the same points on this edge.
///
/// `code` has the slicers' format: hexadecimal digits, from the last to the first. The low two bits
/// of a digit are the number of halved edges.
///
/// - Zero halved edges: the digit is a piece, and its high two bits are the state of the piece. The
///   value 3 means that the state minus 3 follows in the next digits: each digit 15 adds 15 and is
///   followed by one more digit.
/// - Otherwise the high two bits are the corner where the division begins. The parts of the
///   division follow, from the last one on.
///
/// Errors: MESH_MALFORMED for an invalid code and for more than kMaxPaintLevels levels. Cost:
/// O(digits). Source: PrusaSlicer, TriangleSelector.cpp (the format).
absl::StatusOr<std::vector<PaintedPiece>> PaintedPieces(std::string_view code,
                                                        const Facet& triangle);

}  // namespace slicefarm::slicing::threemf
