#pragma once

#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "slicefarm/v1/layer.pb.h"

namespace slicefarm {

/// Regions, and where sections stand among an object's layers. Errors are those of geometry_wire.h,
/// and REQUEST_MALFORMED for numbers that no job has.

absl::Status ToProto(const Region& region, v1::Region* proto);
absl::StatusOr<Region> FromProto(const v1::Region& proto);

absl::Status ToProto(const FillArea& area, v1::FillArea* proto);
absl::StatusOr<FillArea> FromProto(const v1::FillArea& proto);

void ToProto(const Stack& stack, v1::Stack* proto);
absl::StatusOr<Stack> FromProto(const v1::Stack& proto);
/// Whether it may be the id of a stack.
absl::Status CheckStack(std::string_view field, int32_t id);

absl::Status ToProto(const Mark& mark, v1::Mark* proto);
absl::StatusOr<Mark> FromProto(const v1::Mark& proto);

/// A stack's own layer; the height of beads.
absl::Status CheckSection(int32_t layer, int64_t height_nm);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
