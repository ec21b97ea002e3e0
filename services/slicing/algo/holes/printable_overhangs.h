#pragma once

#include <span>

#include "common/base/cancel_token.h"
#include "common/model/layers/layer.h"
#include "common/model/options/hole_options.h"

namespace slicefarm::slicing {

/// Adds material below the overhangs of one object, so that none of them leans more than the
/// setting allows: each layer also gets the outlines of the layer above, inset by its height times
/// the tangent of the angle. So overhangs become cones. The material belongs to the region above
/// it. Holes of a layer that are not larger than the setting's area stay open. An angle of 90
/// degrees changes nothing. `sections`: one per layer, bottom up. Hollow sections do not change. If
/// `cancel` is set, none or only some of the sections are changed. Cost: an offset and a few
/// boolean operations per layer.
void MakeOverhangsPrintable(const PrintableOverhangs& options,
                            std::span<ObjectSection* const> sections,
                            const CancelToken& cancel = {});

}  // namespace slicefarm::slicing
