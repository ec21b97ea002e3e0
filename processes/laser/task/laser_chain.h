#pragma once

#include <memory>
#include <vector>

#include "common/stage/exposure_stage.h"
#include "processes/laser/task/laser_task.h"

namespace slicefarm {

/// The exposure stage, local or remote. The stage must outlive the chain.
class LaserChain : public LaserRunner {
 public:
  explicit LaserChain(const ExposureStage& exposure) : exposure_(exposure) {}

  /// Returns the chain, or null if the stage is missing.
  static std::shared_ptr<const LaserChain> Over(const Stages& stages) {
    if (stages.exposure == nullptr) return nullptr;
    return std::make_shared<LaserChain>(*stages.exposure);
  }
  static std::vector<Stage> StagesOf() { return {Stage::kExposure}; }

  absl::StatusOr<LaserResult> Run(const StageCall& call, const LaserTask& task) const override;

 private:
  const ExposureStage& exposure_;
};

}  // namespace slicefarm
