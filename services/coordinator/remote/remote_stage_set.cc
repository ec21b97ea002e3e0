#include "services/coordinator/remote/remote_stage_set.h"

namespace slicefarm::coordinator {

void RemoteStageSet::Add(Stage stage, ReplicaSource& replicas) {
  switch (stage) {
    case Stage::kSlicing:
      slicing_ = std::make_unique<RemoteSlicing>(replicas);
      placing_ = std::make_unique<RemotePlacing>(replicas);
      return;
    case Stage::kPlacing:
      return;  // has no service of its own
    case Stage::kPlanning:
      planning_ = std::make_unique<RemotePlanning>(replicas);
      return;
    case Stage::kBeading:
      beading_ = std::make_unique<RemoteBeading>(replicas);
      return;
    case Stage::kInfill:
      infill_ = std::make_unique<RemoteInfill>(replicas);
      return;
    case Stage::kOrdering:
      ordering_ = std::make_unique<RemoteOrdering>(replicas);
      return;
    case Stage::kMotion:
      motion_ = std::make_unique<RemoteMotion>(replicas);
      return;
    case Stage::kExposure:
      exposure_ = std::make_unique<RemoteExposure>(replicas);
      return;
    case Stage::kMilling:
      milling_ = std::make_unique<RemoteMilling>(replicas);
      return;
    case Stage::kTexture:
      texture_ = std::make_unique<RemoteTexture>(replicas);
      return;
  }
}

Stages RemoteStageSet::all() const {
  return {slicing_.get(), planning_.get(), beading_.get(), infill_.get(),  ordering_.get(),
          motion_.get(),  exposure_.get(), placing_.get(), milling_.get(), texture_.get()};
}

}  // namespace slicefarm::coordinator
