#pragma once

#include <cstdint>

#include "common/model/options/settings.h"

namespace slicefarm::config::fdm {

// Rows of RegionTable for regions that planning adds to the plate. They are derived from the
// settings of a job or an object. `settings`: resolved settings; only their first region is used.

/// Returns the row of a brim: closed lines of the first layer's width, side by side over the whole
/// region.
JobRows BrimRow(JobRows settings);

/// Returns the row of the skirt: a brim's, with the skirt's own speed.
JobRows SkirtRow(JobRows settings);

/// Returns the row of a raft layer, which has straight lines:
///
///   layer        density                           direction: support_material_angle
///   first        raft_first_layer_density          + 90 degrees if there are two base layers
///   other base   by support_material_spacing
///   interface    by its spacing                    + 90 degrees
///
/// All layers except the interface also have a line along their outline. Source: measurements of
/// PrusaSlicer 2.5.0, with two differences. PrusaSlicer's snug style turns the topmost interface by
/// 45 degrees; slicefarm does not. PrusaSlicer also prints an interface of height 0.3 with the
/// spacing of lines of layer_height, which is 6 % too little plastic. Here a spacing of 0 fills the
/// area completely.
JobRows RaftRow(JobRows settings, int32_t layer);

}  // namespace slicefarm::config::fdm
