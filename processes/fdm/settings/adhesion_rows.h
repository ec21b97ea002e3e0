#pragma once

#include <cstdint>

#include "common/model/options/settings.h"

namespace slicefarm::config::fdm {

/// The settings of regions that planning adds to the plate, as the settings of a job or an object
/// come to them: rows for RegionTable. `settings`: resolved; what counts is the first region.

/// Brim: closed lines as wide as the first layer's, side by side over the whole region.
JobRows BrimRow(JobRows settings);

/// A layer of a raft: straight lines.
///
///   layer        density                           lines run at support_material_angle
///   first        raft_first_layer_density          + 90 degrees if there are two base layers
///   other base   by support_material_spacing
///   interface    by its spacing                    + 90 degrees
///
/// A line runs round those that are no interface. Source: measured, PrusaSlicer 2.5.0; its
/// snug style turns the topmost interface by 45 degrees: not followed. It lays interfaces of height
/// 0.3 at the spacing of lines of layer_height, 6 % too little plastic: a spacing of 0 fills here.
JobRows RaftRow(JobRows settings, int32_t layer);

}  // namespace slicefarm::config::fdm
