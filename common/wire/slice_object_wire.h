#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/slicing.pb.h"

namespace slicefarm {

/// Converts an ObjectInput, an object of the input of slicing. Errors: OUT_OF_RANGE for values that
/// do not fit in 32-bit nanometres; REQUEST_MALFORMED, with the path to the field, for numbers that
/// are not finite and for negative indices.
absl::Status ToProto(const ObjectInput& object, v1::SliceObject* proto);
absl::StatusOr<ObjectInput> FromProto(const v1::SliceObject& proto);

/// Writes the elements of a transform's matrix, row by row.
void PutTransform(const Transform& transform, google::protobuf::RepeatedField<double>* proto);
absl::StatusOr<Transform> TakeTransform(const google::protobuf::RepeatedField<double>& proto,
                                        std::string_view field);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
