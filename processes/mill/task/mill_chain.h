#pragma once

#include <memory>
#include <vector>

#include "common/stage/milling_stage.h"
#include "processes/mill/task/mill_task.h"

namespace slicefarm {

/// The milling stage, local or remote. The stage must outlive the chain.
class MillChain : public MillRunner {
 public:
  explicit MillChain(const MillingStage& milling) : milling_(milling) {}

  /// Returns the chain, or null if the stage is missing.
  static std::shared_ptr<const MillChain> Over(const Stages& stages) {
    if (stages.milling == nullptr) return nullptr;
    return std::make_shared<MillChain>(*stages.milling);
  }
  static std::vector<Stage> StagesOf() { return {Stage::kMilling}; }

  absl::StatusOr<MillResult> Run(const StageCall& call, const MillTask& task) const override;

 private:
  const MillingStage& milling_;
};

}  // namespace slicefarm
