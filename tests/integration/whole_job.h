#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "absl/status/statusor.h"
#include "common/stage/motion_stage.h"
#include "common/stage/planning_stage.h"
#include "common/stage/slice_input.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"

namespace slicefarm {

/// Returns a job of the corpus: a box with letters on it, about 150 layers.
SliceInput TextBox();

/// Slices the text box with these stages and returns its G-code. `layers_done` receives the number
/// of finished layers.
absl::StatusOr<std::string> GcodeOf(const SlicingStage& slicing, const PlanningStage& planning,
                                    const MotionStage& motion, coordinator::Dispatcher& dispatcher,
                                    const std::function<void(int32_t)>& layers_done = {});

/// Returns the G-code of the text box, made in this program by one runner with one slot. Every
/// other configuration must make the same G-code.
const std::string& GcodeOfThisProcess();

}  // namespace slicefarm
