#pragma once

#include <vector>

#include "common/base/shared/shared.h"
#include "common/model/engraving/engrave_input.h"
#include "common/model/engraving/engraved_layer.h"
#include "common/stage/stages.h"
#include "common/stage/texture_stage.h"
#include "services/coordinator/remote/remote_call.h"
#include "services/coordinator/remote/replica_source.h"
#include "services/coordinator/remote/shared_sends.h"

namespace slicefarm::coordinator {

/// The texture stage as a client of its service, as those of remote_stages.h.
class RemoteTexture : public TextureStage {
 public:
  explicit RemoteTexture(ReplicaSource& replicas, const RemoteOptions& options = {})
      : replicas_(replicas), options_(options), sends_(options.deadline) {}

  absl::StatusOr<MappedSurface> Map(const StageCall& call,
                                    const Shared<SurfaceInput>& surface) const override;
  absl::StatusOr<EngraveLayout> LayOut(const StageCall& call,
                                       const Shared<EngraveInput>& input) const override;
  absl::StatusOr<std::vector<EngravedLayer>> Engrave(const StageCall& call,
                                                     const Shared<EngraveInput>& input,
                                                     LayerRange range) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
  mutable SharedSends sends_;  // what is under way
};

}  // namespace slicefarm::coordinator
