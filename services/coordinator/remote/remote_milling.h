#pragma once

#include <string_view>
#include <vector>

#include "common/base/shared/shared.h"
#include "common/model/milling/mill_input.h"
#include "common/model/milling/milled_program.h"
#include "common/stage/milling_stage.h"
#include "common/stage/stages.h"
#include "services/coordinator/remote/remote_call.h"
#include "services/coordinator/remote/replica_source.h"
#include "services/coordinator/remote/shared_sends.h"

namespace slicefarm::coordinator {

/// The milling stage as a client of its service, as those of remote_stages.h.
class RemoteMilling : public MillingStage {
 public:
  explicit RemoteMilling(ReplicaSource& replicas, const RemoteOptions& options = {})
      : replicas_(replicas), options_(options), sends_(options.deadline) {}

  absl::StatusOr<MillLayout> LayOut(const StageCall& call,
                                    const Shared<MillInput>& input) const override;
  absl::StatusOr<std::vector<MilledStep>> Mill(const StageCall& call,
                                               const Shared<MillInput>& input,
                                               StepRange range) const override;
  absl::StatusOr<MilledProgram> Assemble(const StageCall& call, const Shared<MillInput>& input,
                                         std::vector<MilledStep> steps,
                                         std::string_view settings_text) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
  mutable SharedSends sends_;  // what is under way
};

}  // namespace slicefarm::coordinator
