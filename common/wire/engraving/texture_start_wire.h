#pragma once

#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "common/stage/stage_call.h"
#include "common/stage/stages.h"
#include "slicefarm/v1/texture.pb.h"

namespace slicefarm {

/// First message of a call of the texture service. Errors: see stage_call_wire.h and layer_wire.h.
struct TextureStart {
  StageCall call;
  std::string shared;     ///< digest of a SurfaceInput or an EngraveInput (shared_wire.h)
  LayerRange range = {};  ///< layers of an EngraveLayers call
};
absl::Status ToProto(const TextureStart& start, v1::TextureStart* proto);
absl::StatusOr<TextureStart> FromProto(const v1::TextureStart& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
