#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace slicefarm::gcode {

/// Rectangle on the bed, in mm.
struct BedBox {
  double min_x = 0, min_y = 0, max_x = 0, max_y = 0;
};

/// Copy of an object on a plate.
struct ArchivedObject {
  int32_t id = 0;  ///< id in the picture of ids, in the labels of the program, and in the archive
  std::string name;
  BedBox box;
  double area_mm2 = 0;  ///< area that the copy covers on the bed
};

/// Picture of a plate as a PNG file. `name`: its name in the archive with `#` for the number of the
/// plate, without a folder, such as `plate_#.png`.
struct ArchivedPicture {
  std::string name;
  std::string png;
};

/// Plate of a .gcode.3mf archive: a program, with pictures and facts for printers and farms.
struct ArchivedPlate {
  std::string title;  ///< name of the print, without an ending
  std::string gcode;
  std::vector<ArchivedPicture> pictures;
  double time_s = 0;
  double first_layer_time_s = 0;
  int64_t layers = 0;
  double filament_mm = 0;
  double filament_g = 0;
  std::string filament_type;
  std::string filament_colour;  ///< colour in the form #RRGGBB
  std::string filament_id;      ///< id of the filament at its maker, such as `GFA00`; may be empty
  std::string bed_type;         ///< plate on the bed, such as `textured_plate`; may be empty
  std::string printer_model;    ///< name of the printer, such as `Bambu Lab X1 Carbon`
  double nozzle_mm = 0;
  double layer_height_mm = 0;
  bool has_supports = false;
  bool has_labels = false;  ///< true if the program has labels by which copies can be skipped
  bool one_by_one = false;  ///< true if copies are printed one after another
  std::vector<ArchivedObject> objects;
  std::vector<std::string> warnings;
  /// Settings by their names in Bambu Studio. A list has the values of several filaments.
  std::vector<std::pair<std::string, std::string>> settings;
  std::vector<std::pair<std::string, std::vector<std::string>>> list_settings;
};

}  // namespace slicefarm::gcode
