#pragma once

#include "common/stage/task.h"

namespace slicefarm {

/// The layer stage of lasers, local or remote. It must outlive the chain.
class LaserChain : public LaserRunner {
 public:
  explicit LaserChain(const ExposureStage& exposure) : exposure_(exposure) {}

  absl::StatusOr<LaserResult> Run(const StageCall& call, const LaserTask& task) const override;

 private:
  const ExposureStage& exposure_;
};

}  // namespace slicefarm
