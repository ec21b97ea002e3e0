#pragma once

#include <string>
#include <vector>

#include "services/cli/calibration/solid_builder.h"

namespace slicefarm::cli {

/// Floors of a tower, from the bottom up. Heights in mm; they are multiples of the layer height
/// above the first layer, so a floor begins with a layer.
struct Floors {
  double base_mm = 0;   ///< top of the base plate
  double floor_mm = 0;  ///< height of a floor
  std::vector<std::string> labels;

  double Bottom(size_t i) const { return base_mm + static_cast<double>(i) * floor_mm; }
};

/// Returns floors of about `floor_mm` on a base of about a millimetre.
Floors FloorsOf(double floor_mm, double first_layer_mm, double layer_mm,
                std::vector<std::string> labels);

/// Each function returns a binary STL file. The labels are on the front.

/// Two pillars with a bridge and overhangs on each floor.
std::string TemperatureTower(const Floors& floors);
/// Two pillars far apart, between which the filament oozes.
std::string PillarPair(const Floors& floors);
/// Block with the outline of an L, which has sharp corners in x and y.
std::string CornerTower(const Floors& floors);
/// Block with eight flat walls, in steps of 45 degrees.
std::string FlatWallTower(const Floors& floors);
/// Long block with round ends, on which high speeds are reached.
std::string LongTower(const Floors& floors);
/// Plate with a top surface of 30 mm, and a tab with the label.
std::string FlowPlate(const std::string& label);

}  // namespace slicefarm::cli
