#pragma once

#include <memory>

#include "common/stage/ordering_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::ordering {

/// Returns the ordering stage that runs in this program: OrderLayer for each layer. Stateless.
std::unique_ptr<OrderingStage> MakeLocalOrdering();

}  // namespace slicefarm::ordering
