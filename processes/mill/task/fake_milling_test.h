#pragma once

#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/shared/shared.h"
#include "common/stage/milling_stage.h"
#include "common/stage/stage_call.h"
#include "common/stage/stages.h"
#include "processes/mill/model/mill_input.h"
#include "processes/mill/model/milled_program.h"

namespace slicefarm {

/// Milling stage for tests. For any input it has five levels of roughing, three of finishing and
/// four rows. Its program has one word for each step.
class FakeMilling : public MillingStage {
 public:
  static std::vector<MillStep> AllSteps() {
    std::vector<MillStep> steps;
    for (const auto& [phase, count] :
         {std::pair(MillPhase::kRoughing, 5), std::pair(MillPhase::kFinishing, 3),
          std::pair(MillPhase::kRest, 4)})
      for (int i = 0; i < count; ++i) steps.push_back({phase, 10.0 - i});
    return steps;
  }

  absl::StatusOr<MillLayout> LayOut(const StageCall&,
                                    const Shared<MillInput>& input) const override {
    if (fails) return MakeError(absl::StatusCode::kInternal, Reason::kInternal, "milling");
    laid_out = *input;
    MillLayout layout;
    layout.steps = AllSteps();
    layout.weights.assign(layout.steps.size(), 2);
    layout.part_mm = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(9, 9, 3)};
    layout.stock_mm = {Eigen::Vector3d(-1, -1, 0), Eigen::Vector3d(10, 10, 4)};
    return layout;
  }
  absl::StatusOr<std::vector<MilledStep>> Mill(const StageCall&, const Shared<MillInput>&,
                                               StepRange range) const override {
    if (fails) return MakeError(absl::StatusCode::kInternal, Reason::kInternal, "milling");
    std::vector<MilledStep> milled;
    for (int32_t i = range.first; i < range.last; ++i)
      if (i != lost) milled.push_back({AllSteps()[static_cast<size_t>(i)], {}, {}});
    return milled;
  }
  absl::StatusOr<MilledProgram> Assemble(const StageCall&, const Shared<MillInput>&,
                                         std::vector<MilledStep> steps,
                                         std::string_view settings_text) const override {
    MilledProgram program;
    for (const MilledStep& step : steps)
      program.text += absl::StrCat(std::string(1, "RFW"[static_cast<int>(step.step.phase)]),
                                   step.step.at_mm, " ");
    program.text += std::string(settings_text);
    program.report.phases[0].seconds = 60;
    program.report.phases[1].seconds = 30;
    program.report.removed_mm3 = 12;
    program.report.gouges = gouges;
    return program;
  }

  bool fails = false;
  int32_t lost = -1;
  int64_t gouges = 0;
  mutable MillInput laid_out;
};

}  // namespace slicefarm
