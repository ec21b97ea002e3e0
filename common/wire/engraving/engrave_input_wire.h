#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/wire/engraving/surface_wire.h"
#include "common/wire/shared_wire.h"
#include "processes/engrave/model/engrave_input.h"
#include "slicefarm/v1/texture.pb.h"

namespace slicefarm {

/// Converts data that all calls of an engraving job share. The settings are sent without their
/// images, which are separate fields. The stage, not this function, checks whether the values can
/// be used. Errors: REQUEST_MALFORMED with the path to the field; any error of surface_wire.h.
absl::Status ToProto(const SurfaceInput& surface, v1::SurfaceInput* proto);
absl::StatusOr<SurfaceInput> FromProto(const v1::SurfaceInput& proto);
absl::Status ToProto(const MappedSurface& surface, v1::MappedSurface* proto);
absl::StatusOr<MappedSurface> FromProto(const v1::MappedSurface& proto);
absl::Status ToProto(const EngraveInput& input, v1::EngraveInput* proto);
absl::StatusOr<EngraveInput> FromProto(const v1::EngraveInput& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
using slicefarm::ToProto;
}  // namespace v1

template <>
struct MessageOf<SurfaceInput> {
  using Type = v1::SurfaceInput;
};
template <>
struct MessageOf<EngraveInput> {
  using Type = v1::EngraveInput;
};

}  // namespace slicefarm
