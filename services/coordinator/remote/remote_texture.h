#pragma once

#include <vector>

#include "common/base/shared/shared.h"
#include "common/stage/stages.h"
#include "common/stage/texture_stage.h"
#include "processes/engrave/model/engrave_input.h"
#include "processes/engrave/model/engraved_layer.h"
#include "services/coordinator/remote/stage_client.h"

namespace slicefarm::coordinator {

/// Client of the texture service (stage_client.h).
class RemoteTexture : public TextureStage {
 public:
  explicit RemoteTexture(ReplicaSource& replicas, const RemoteOptions& options = {})
      : client_("texture", replicas, options) {}

  absl::StatusOr<MappedSurface> Map(const StageCall& call,
                                    const Shared<SurfaceInput>& surface) const override;
  absl::StatusOr<EngraveLayout> LayOut(const StageCall& call,
                                       const Shared<EngraveInput>& input) const override;
  absl::StatusOr<std::vector<EngravedLayer>> Engrave(const StageCall& call,
                                                     const Shared<EngraveInput>& input,
                                                     LayerRange range) const override;

 private:
  const StageClient client_;
};

}  // namespace slicefarm::coordinator
