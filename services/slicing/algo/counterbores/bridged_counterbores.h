#pragma once

#include <span>

#include "common/base/cancel_token.h"
#include "common/model/layers/layer.h"
#include "common/model/options/slicing_options.h"

namespace slicefarm::slicing {

/// Changes the sections of one object, by layer, where holes begin over wider recesses: kPartial
/// leaves open in them the rooms of Counterbore, as far up as the holes go; kSacrificial closes the
/// holes for one layer. Holes of one layer alone stay, and so do sections that are hollow. Cost: see
/// CounterboresOver, on `threads`. Changes nothing, or only some sections, once `cancel` says so.
void BridgeCounterbores(CounterboreBridging how, std::span<ObjectSection* const> sections,
                        int threads, const CancelToken& cancel = {});

}  // namespace slicefarm::slicing
