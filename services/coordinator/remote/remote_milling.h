#pragma once

#include <string_view>
#include <vector>

#include "common/base/shared/shared.h"
#include "common/stage/milling_stage.h"
#include "common/stage/stages.h"
#include "processes/mill/model/mill_input.h"
#include "processes/mill/model/milled_program.h"
#include "services/coordinator/remote/stage_client.h"

namespace slicefarm::coordinator {

/// Client of the milling service (stage_client.h).
class RemoteMilling : public MillingStage {
 public:
  explicit RemoteMilling(ReplicaSource& replicas, const RemoteOptions& options = {})
      : client_("milling", replicas, options) {}

  absl::StatusOr<MillLayout> LayOut(const StageCall& call,
                                    const Shared<MillInput>& input) const override;
  absl::StatusOr<std::vector<MilledStep>> Mill(const StageCall& call,
                                               const Shared<MillInput>& input,
                                               StepRange range) const override;
  absl::StatusOr<MilledProgram> Assemble(const StageCall& call, const Shared<MillInput>& input,
                                         std::vector<MilledStep> steps,
                                         std::string_view settings_text) const override;

 private:
  const StageClient client_;
};

}  // namespace slicefarm::coordinator
