#pragma once

#include <vector>

#include "common/model/scene/placed_scene.h"
#include "common/stage/plates.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "processes/engrave/model/surface_mesh.h"
#include "services/coordinator/remote/stage_client.h"

namespace slicefarm::coordinator {

// Clients of the slicing service, one class per stage (stage_client.h). Each client keeps the
// bytes of the input until the answer arrives, because another replica may need them.

/// Client that slices meshes.
class RemoteSlicing : public SlicingStage {
 public:
  explicit RemoteSlicing(ReplicaSource& replicas, const RemoteOptions& options = {})
      : client_("slicing", replicas, options) {}

  absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                  const SlicingOptions& options) const override;

 private:
  const StageClient client_;
};

/// Client that places copies on plates.
class RemoteArranging : public ArrangingStage {
 public:
  explicit RemoteArranging(ReplicaSource& replicas, const RemoteOptions& options = {})
      : client_("slicing", replicas, options) {}

  absl::StatusOr<std::vector<PlatePosition>> PutOnPlates(
      const StageCall& call, SliceInput input, const SlicingOptions& options) const override;

 private:
  const StageClient client_;
};

/// Client that places meshes in the scene and reads their surfaces.
class RemotePlacing : public PlacingStage {
 public:
  explicit RemotePlacing(ReplicaSource& replicas, const RemoteOptions& options = {})
      : client_("placing", replicas, options) {}

  absl::StatusOr<PlacedScene> Place(const StageCall& call, SliceInput input,
                                    const SlicingOptions& options) const override;
  absl::StatusOr<std::vector<SurfaceMesh>> ReadSurfaces(
      const StageCall& call, SliceInput input, const SlicingOptions& options) const override;

 private:
  const StageClient client_;
};

}  // namespace slicefarm::coordinator
