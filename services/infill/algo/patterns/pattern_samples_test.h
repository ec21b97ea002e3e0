#pragma once

#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

/// Returns the region of the pattern tests: 48 x 48 mm around the origin.
inline MultiPolygon SampleBox() { return MakePolygonsOrDie("(-24 -24, 24 -24, 24 24, -24 24)"); }

/// Returns the length of all pieces, in nm.
inline double LengthOf(const std::vector<Piece>& pieces) {
  double length = 0;
  for (const Piece& piece : pieces)
    length += piece.closed ? Perimeter(piece.points) : Length(piece.points);
  return length;
}

}  // namespace slicefarm::infill
