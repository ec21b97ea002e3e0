#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"

namespace slicefarm {

/// Geometry as text, for tests and error messages; lengths in millimetres.
///
///   line or ring    (0 0, 10 0, 10 10)
///   island          (outer ring) (hole) (hole)
///   islands         island ; island
///
/// A ring turns the right way by itself: the first of an island is made counter-clockwise, the rest
/// clockwise. Errors: InvalidArgument with the offset of what could not be read.
absl::StatusOr<Polyline> ParseLine(std::string_view text);
absl::StatusOr<MultiPolygon> ParseMultiPolygon(std::string_view text);

std::string ToText(Point point);
std::string ToText(const Polyline& line);
std::string ToText(const PolygonWithHoles& polygon);
std::string ToText(const MultiPolygon& polygons);

/// For literals in tests: dies on text that cannot be read.
Polyline MakeLineOrDie(std::string_view text);
MultiPolygon MakePolygonsOrDie(std::string_view text);

}  // namespace slicefarm
