#pragma once

#include <span>

#include "common/base/cancel_token.h"
#include "common/model/layers/layer.h"
#include "common/model/options/slicing_options.h"

namespace slicefarm::slicing {

/// Changes the sections of one object where holes begin over a wider recess, so that no wall begins
/// in the air. `sections`: one per layer, bottom up.
///
/// kPartial leaves only the areas Counterbore::open_areas open, in as many layers as `open_areas`
/// has areas. kSacrificial closes the holes for one layer. Holes that are only one layer high do
/// not change, nor do hollow sections.
///
/// If `cancel` is set, none or only some of the sections are changed. Cost: see CounterboresOver,
/// on `threads` threads.
void BridgeCounterbores(CounterboreBridging how, std::span<ObjectSection* const> sections,
                        int threads, const CancelToken& cancel = {});

}  // namespace slicefarm::slicing
