#pragma once

#include <span>
#include <vector>

#include "common/base/shared/shared.h"
#include "common/model/layers/job_plan.h"
#include "common/model/scene/placed_scene.h"
#include "common/stage/beading_stage.h"
#include "common/stage/exposure_stage.h"
#include "common/stage/infill_stage.h"
#include "common/stage/motion_stage.h"
#include "common/stage/neighbourhood.h"
#include "common/stage/ordering_stage.h"
#include "common/stage/planning_stage.h"
#include "common/stage/plates.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "processes/laser/model/exposed_program.h"
#include "services/coordinator/remote/stage_client.h"

namespace slicefarm {
struct ExposureSettings;

struct ExposureJob;
struct MotionJob;
struct MotionOptions;
struct OrderingJob;
}  // namespace slicefarm

namespace slicefarm::coordinator {

// Clients of the stages that work on ranges of layers (stage_client.h).

/// Client that makes beads from outlines.
class RemoteBeading : public BeadingStage {
 public:
  explicit RemoteBeading(ReplicaSource& replicas, const RemoteOptions& options = {})
      : client_("beading", replicas, options) {}

  absl::StatusOr<std::vector<WalledLayer>> Bead(const StageCall& call,
                                                const Neighbourhood& neighbourhood,
                                                const Shared<BeadingTable>& regions) const override;

 private:
  const StageClient client_;
};

/// Client that fills layers.
class RemoteInfill : public InfillStage {
 public:
  explicit RemoteInfill(ReplicaSource& replicas, const RemoteOptions& options = {})
      : client_("infill", replicas, options) {}

  absl::StatusOr<std::vector<FilledLayer>> Fill(const StageCall& call,
                                                std::vector<WalledLayer> walled,
                                                const Neighbourhood& neighbourhood,
                                                std::span<const LayerPlan> plans,
                                                const Shared<InfillTable>& regions) const override;

 private:
  const StageClient client_;
};

/// Client that orders the paths of layers.
class RemoteOrdering : public OrderingStage {
 public:
  explicit RemoteOrdering(ReplicaSource& replicas, const RemoteOptions& options = {})
      : client_("ordering", replicas, options) {}

  absl::StatusOr<std::vector<OrderedLayer>> Order(const StageCall& call,
                                                  std::vector<FilledLayer> layers,
                                                  std::span<const LayerPlan> plans,
                                                  const Shared<OrderingJob>& job) const override;

 private:
  const StageClient client_;
};

/// Client that makes G-code from ordered layers.
class RemoteMotion : public MotionStage {
 public:
  explicit RemoteMotion(ReplicaSource& replicas, const RemoteOptions& options = {})
      : client_("motion", replicas, options) {}

  absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall& call,
                                                    std::vector<OrderedLayer> layers,
                                                    const Shared<MotionJob>& job) const override;
  absl::StatusOr<ProgramEnvelope> Envelope(const StageCall& call, const ProgramSummary& summary,
                                           const MotionOptions& options) const override;

 private:
  const StageClient client_;
};

/// Client that makes exposures of layers.
class RemoteExposure : public ExposureStage {
 public:
  explicit RemoteExposure(ReplicaSource& replicas, const RemoteOptions& options = {})
      : client_("exposure", replicas, options) {}

  absl::StatusOr<std::vector<ExposedProgram>> Expose(const StageCall& call,
                                                     const Neighbourhood& neighbourhood,
                                                     const Shared<ExposureJob>& job) const override;
  absl::StatusOr<ExposureEnvelope> Envelope(const StageCall& call, const ExposureSummary& summary,
                                            const ExposureSettings& settings) const override;

 private:
  const StageClient client_;
};

}  // namespace slicefarm::coordinator
