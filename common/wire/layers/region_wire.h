#pragma once

#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "slicefarm/v1/layer.pb.h"

namespace slicefarm {

// Conversion of regions, and of positions of sections within an object's layers. Errors: see
// geometry_wire.h; REQUEST_MALFORMED for numbers that no job can have.

/// Converts a region to its message and back.
absl::Status ToProto(const Region& region, v1::Region* proto);
absl::StatusOr<Region> FromProto(const v1::Region& proto);

/// Converts the area of an infill to its message and back.
absl::Status ToProto(const FillArea& area, v1::FillArea* proto);
absl::StatusOr<FillArea> FromProto(const v1::FillArea& proto);

/// Converts a stack to its message and back.
void ToProto(const Stack& stack, v1::Stack* proto);
absl::StatusOr<Stack> FromProto(const v1::Stack& proto);
/// Checks that a number is a valid id of a stack. Errors: REQUEST_MALFORMED.
absl::Status CheckStack(std::string_view field, int32_t id);

/// Converts a mark to its message and back.
absl::Status ToProto(const Mark& mark, v1::Mark* proto);
absl::StatusOr<Mark> FromProto(const v1::Mark& proto);

/// Checks the number of a layer within its stack, and the height of its beads. Errors:
/// REQUEST_MALFORMED.
absl::Status CheckSection(int32_t layer, int64_t height_nm);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
