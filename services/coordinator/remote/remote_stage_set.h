#pragma once

#include <memory>

#include "common/stage/stage_list.h"
#include "services/coordinator/remote/remote_milling.h"
#include "services/coordinator/remote/remote_planning.h"
#include "services/coordinator/remote/remote_slicing.h"
#include "services/coordinator/remote/remote_stages.h"
#include "services/coordinator/remote/remote_texture.h"

namespace slicefarm::coordinator {

/// Clients of the stages that run as services.
class RemoteStageSet {
 public:
  /// Creates the client of a stage. A slicing service is also the placing service. `replicas` must
  /// outlive the set. REQUIRES: the stage was not added before.
  void Add(Stage stage, ReplicaSource& replicas);

  /// Returns the stages that were added.
  Stages all() const;

 private:
  std::unique_ptr<RemoteSlicing> slicing_;
  std::unique_ptr<RemotePlacing> placing_;
  std::unique_ptr<RemotePlanning> planning_;
  std::unique_ptr<RemoteBeading> beading_;
  std::unique_ptr<RemoteInfill> infill_;
  std::unique_ptr<RemoteOrdering> ordering_;
  std::unique_ptr<RemoteMotion> motion_;
  std::unique_ptr<RemoteExposure> exposure_;
  std::unique_ptr<RemoteMilling> milling_;
  std::unique_ptr<RemoteTexture> texture_;
};

}  // namespace slicefarm::coordinator
