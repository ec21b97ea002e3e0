#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "slicefarm/v1/geometry.pb.h"

namespace slicefarm {

// Conversion of geometry. Messages contain 32-bit nanometres. Larger values are refused with
// OUT_OF_RANGE. Inconsistent data, such as an odd number of coordinates or ring sizes that do not
// match the points, is refused with REQUEST_MALFORMED. Cost: one pass over the points.

/// Converts a point to its message and back.
absl::Status ToProto(Point point, v1::Point* proto);
Point FromProto(const v1::Point& proto);

/// Converts a set of polygons to its message and back.
absl::Status ToProto(const MultiPolygon& polygons, v1::MultiPolygon* proto);
absl::StatusOr<MultiPolygon> FromProto(const v1::MultiPolygon& proto);

/// Appends `points` as x, y, x, y, ...
absl::Status PackPoints(std::span<const Point> points,
                        google::protobuf::RepeatedField<int32_t>* xy_nm);
absl::StatusOr<std::vector<Point>> UnpackPoints(
    const google::protobuf::RepeatedField<int32_t>& xy_nm, std::string_view field);

/// Checks that `value_nm` fits in 32 bits. Errors: OUT_OF_RANGE.
absl::Status CheckCoord(Coord value_nm);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
