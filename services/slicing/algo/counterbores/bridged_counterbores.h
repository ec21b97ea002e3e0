#pragma once

#include <span>

#include "common/base/cancel_token.h"
#include "common/model/layers/layer.h"
#include "common/model/options/slicing_options.h"

namespace slicefarm::slicing {

/// Changes the sections of one object (one per layer, bottom up) where holes begin over wider
/// recesses. kPartial keeps only the areas Counterbore::rooms open, in as many layers as `rooms`
/// has areas; kSacrificial closes the holes for one layer. Holes that are only one layer high stay
/// unchanged, and so do hollow sections.
///
/// If `cancel` is set, none or only some of the sections are changed. Cost: see CounterboresOver,
/// on `threads` threads.
void BridgeCounterbores(CounterboreBridging how, std::span<ObjectSection* const> sections,
                        int threads, const CancelToken& cancel = {});

}  // namespace slicefarm::slicing
