#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>

namespace slicefarm::config {

/// OrcaSlicer's settings for probing only the part of the bed under the print.
struct BedMesh {
  /// corner with the smallest x and y of the area that the probe reaches, in mm
  std::array<double, 2> min = {-99'999, -99'999};
  std::array<double, 2> max = {99'999, 99'999};
  /// largest distance between probed points in x and y, in mm
  std::array<double, 2> probe_distance = {50, 50};
  double margin = 0;     ///< margin around the first layer, in mm
  bool klipper = false;  ///< true for Klipper: its bicubic mesh needs 4 points per side
};

/// Returns the G-code, preceded by definitions of the variables that it uses. Defined are
/// adaptive_bed_mesh_min, adaptive_bed_mesh_max, bed_mesh_probe_count and bed_mesh_algo. Their
/// values depend on the bounds of the first layer, so they are expressions that are evaluated when
/// G-code is written. G-code that uses none of these variables is returned unchanged.
std::string WithBedMesh(std::string gcode, const BedMesh& mesh);

}  // namespace slicefarm::config
