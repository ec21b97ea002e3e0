#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>

namespace slicefarm::config {

/// OrcaSlicer's settings for probing the bed only where the print stands.
struct BedMesh {
  std::array<double, 2> min = {-99'999, -99'999};  ///< mm: what the probe reaches
  std::array<double, 2> max = {99'999, 99'999};
  std::array<double, 2> probe_distance = {50, 50};  ///< mm from one point to the next
  double margin = 0;                                ///< mm around the first layer
  bool klipper = false;                             ///< whose bicubic mesh needs 4 points a side
};

/// G-code that defines what it names of adaptive_bed_mesh_min, adaptive_bed_mesh_max,
/// bed_mesh_probe_count and bed_mesh_algo before its first line; else as it is. These follow from
/// the bounds of the first layer, which are known when G-code is written.
std::string WithBedMesh(std::string gcode, const BedMesh& mesh);

}  // namespace slicefarm::config
