#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/shared/shared.h"
#include "common/model/layers/layer.h"
#include "common/stage/stage_call.h"
#include "processes/engrave/model/engrave_input.h"
#include "processes/engrave/model/engraved_layer.h"

namespace slicefarm {

/// Stage that makes textures on surfaces. Each range of a job's layers can be computed on its own.
class TextureStage {
 public:
  virtual ~TextureStage() = default;
  /// Maps the surface to the plane. Calls with equal surfaces share one result.
  virtual absl::StatusOr<MappedSurface> Map(const StageCall& call,
                                            const Shared<SurfaceInput>& surface) const = 0;
  virtual absl::StatusOr<EngraveLayout> LayOut(const StageCall& call,
                                               const Shared<EngraveInput>& input) const = 0;
  /// Returns the layers of the range, in the order of work. Errors: REQUEST_MALFORMED if the job
  /// does not have all layers of the range.
  virtual absl::StatusOr<std::vector<EngravedLayer>> Engrave(const StageCall& call,
                                                             const Shared<EngraveInput>& input,
                                                             LayerRange range) const = 0;
};

}  // namespace slicefarm
