#pragma once

#include <memory>
#include <vector>

#include "common/stage/texture_stage.h"
#include "processes/engrave/task/engrave_task.h"

namespace slicefarm {

/// The engraving stage, local or remote. The stage must outlive the chain.
class EngraveChain : public EngraveRunner {
 public:
  explicit EngraveChain(const TextureStage& texture) : texture_(texture) {}

  /// Returns the chain, or null if the stage is missing.
  static std::shared_ptr<const EngraveChain> Over(const Stages& stages) {
    if (stages.texture == nullptr) return nullptr;
    return std::make_shared<EngraveChain>(*stages.texture);
  }
  static std::vector<Stage> StagesOf() { return {Stage::kTexture}; }

  absl::StatusOr<EngraveResult> Run(const StageCall& call, const EngraveTask& task) const override;

 private:
  const TextureStage& texture_;
};

}  // namespace slicefarm
