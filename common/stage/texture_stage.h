#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/shared/shared.h"
#include "common/model/layers/layer.h"
#include "common/stage/stage_call.h"
#include "processes/engrave/model/engrave_input.h"
#include "processes/engrave/model/engraved_layer.h"

namespace slicefarm {

/// Surfaces to textures on them. Any ranges of a job's layers can be made apart.
class TextureStage {
 public:
  virtual ~TextureStage() = default;
  /// Lays the surface flat. Made once for all who ask with the same value.
  virtual absl::StatusOr<MappedSurface> Map(const StageCall& call,
                                            const Shared<SurfaceInput>& surface) const = 0;
  virtual absl::StatusOr<EngraveLayout> LayOut(const StageCall& call,
                                               const Shared<EngraveInput>& input) const = 0;
  /// One for each layer of the range, in order of work. REQUEST_MALFORMED for a range that the job
  /// has not.
  virtual absl::StatusOr<std::vector<EngravedLayer>> Engrave(const StageCall& call,
                                                             const Shared<EngraveInput>& input,
                                                             LayerRange range) const = 0;
};

}  // namespace slicefarm
