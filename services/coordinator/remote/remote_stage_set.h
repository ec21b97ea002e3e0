#pragma once

#include <memory>

#include "common/stage/stage_list.h"
#include "services/coordinator/remote/remote_milling.h"
#include "services/coordinator/remote/remote_planning.h"
#include "services/coordinator/remote/remote_slicing.h"
#include "services/coordinator/remote/remote_stages.h"
#include "services/coordinator/remote/remote_texture.h"

namespace slicefarm::coordinator {

/// Stages as clients of services, of those that there are.
class RemoteStageSet {
 public:
  /// Makes a stage's client; slicing services place as well. `replicas` must outlive the set.
  /// REQUIRES: once a stage at most.
  void Add(Stage stage, ReplicaSource& replicas);

  /// Those that were added.
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
