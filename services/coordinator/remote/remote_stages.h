#pragma once

#include <vector>

#include "common/base/shared/shared.h"
#include "common/model/exposed_program.h"
#include "common/model/job_plan.h"
#include "common/model/options/exposure_settings.h"
#include "common/model/options/motion_options.h"
#include "common/model/options/planning_options.h"
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
#include "services/coordinator/remote/remote_call.h"
#include "services/coordinator/remote/replica_source.h"
#include "services/coordinator/remote/shared_sends.h"

namespace slicefarm::coordinator {

/// The stages as clients of their services. Each call goes to one of `replicas`, which must outlive
/// the stage; it has a deadline, and its cancellation reaches the algorithm at the other end.
/// Errors: the stage's own; Unavailable, DeadlineExceeded, Cancelled; Internal for an answer that
/// does not fit the call.

class RemoteSlicing : public SlicingStage {
 public:
  explicit RemoteSlicing(ReplicaSource& replicas, const RemoteOptions& options = {})
      : replicas_(replicas), options_(options) {}

  /// Keeps the bytes until the answer is there: another replica may need them.
  absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                  const SlicingOptions& options) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
};

/// The slicing service puts on plates as well.
class RemoteArranging : public ArrangingStage {
 public:
  explicit RemoteArranging(ReplicaSource& replicas, const RemoteOptions& options = {})
      : replicas_(replicas), options_(options) {}

  absl::StatusOr<std::vector<PlatePlace>> PutOnPlates(const StageCall& call, SliceInput input,
                                                      const SlicingOptions& options) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
};

/// And it places.
class RemotePlacing : public PlacingStage {
 public:
  explicit RemotePlacing(ReplicaSource& replicas, const RemoteOptions& options = {})
      : replicas_(replicas), options_(options) {}

  absl::StatusOr<PlacedScene> Place(const StageCall& call, SliceInput input,
                                    const SlicingOptions& options) const override;
  absl::StatusOr<std::vector<SurfaceMesh>> ReadSurfaces(
      const StageCall& call, SliceInput input, const SlicingOptions& options) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
};

class RemotePlanning : public PlanningStage {
 public:
  explicit RemotePlanning(ReplicaSource& replicas, const RemoteOptions& options = {})
      : replicas_(replicas), options_(options) {}

  absl::StatusOr<JobPlan> Plan(const StageCall& call, const SlicedOutlines& job,
                               const PlanningOptions& options) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
};

class RemoteBeading : public BeadingStage {
 public:
  explicit RemoteBeading(ReplicaSource& replicas, const RemoteOptions& options = {})
      : replicas_(replicas), options_(options), sends_(options.deadline) {}

  absl::StatusOr<std::vector<WalledLayer>> Bead(const StageCall& call,
                                                const Neighbourhood& neighbourhood,
                                                const Shared<BeadingTable>& regions) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
  mutable SharedSends sends_;  // what is under way
};

class RemoteInfill : public InfillStage {
 public:
  explicit RemoteInfill(ReplicaSource& replicas, const RemoteOptions& options = {})
      : replicas_(replicas), options_(options), sends_(options.deadline) {}

  absl::StatusOr<std::vector<FilledLayer>> Fill(const StageCall& call,
                                                std::vector<WalledLayer> walled,
                                                const Neighbourhood& neighbourhood,
                                                std::span<const LayerPlan> plans,
                                                const Shared<InfillTable>& regions) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
  mutable SharedSends sends_;  // what is under way
};

class RemoteOrdering : public OrderingStage {
 public:
  explicit RemoteOrdering(ReplicaSource& replicas, const RemoteOptions& options = {})
      : replicas_(replicas), options_(options), sends_(options.deadline) {}

  absl::StatusOr<std::vector<OrderedLayer>> Order(const StageCall& call,
                                                  std::vector<FilledLayer> layers,
                                                  std::span<const LayerPlan> plans,
                                                  const Shared<OrderingJob>& job) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
  mutable SharedSends sends_;  // what is under way
};

class RemoteMotion : public MotionStage {
 public:
  explicit RemoteMotion(ReplicaSource& replicas, const RemoteOptions& options = {})
      : replicas_(replicas), options_(options), sends_(options.deadline) {}

  absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall& call,
                                                    std::vector<OrderedLayer> layers,
                                                    const Shared<MotionJob>& job) const override;
  absl::StatusOr<ProgramEnvelope> Envelope(const StageCall& call, const ProgramSummary& summary,
                                           const MotionOptions& options) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
  mutable SharedSends sends_;  // what is under way
};

class RemoteExposure : public ExposureStage {
 public:
  explicit RemoteExposure(ReplicaSource& replicas, const RemoteOptions& options = {})
      : replicas_(replicas), options_(options), sends_(options.deadline) {}

  absl::StatusOr<std::vector<ExposedProgram>> Expose(const StageCall& call,
                                                     const Neighbourhood& neighbourhood,
                                                     const Shared<ExposureJob>& job) const override;
  absl::StatusOr<ExposureEnvelope> Envelope(const StageCall& call, const ExposureSummary& summary,
                                            const ExposureSettings& settings) const override;

 private:
  ReplicaSource& replicas_;
  const RemoteOptions options_;
  mutable SharedSends sends_;  // what is under way
};

}  // namespace slicefarm::coordinator
