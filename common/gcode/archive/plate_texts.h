#pragma once

#include <string>
#include <string_view>

#include "common/gcode/archive/archived_plate.h"

namespace slicefarm::gcode {

/// Elements and files that describe one plate of an archive, as Bambu Studio writes them.
/// Characters that XML cannot contain are replaced.

/// Returns the element of a plate in Metadata/slice_info.config: time, weight, filament, objects.
std::string SliceInfoPlate(const ArchivedPlate& plate, int number);
/// Returns the element of a plate in Metadata/model_settings.config: names of its files.
std::string ModelSettingsPlate(int number, std::string_view title);
/// Returns Metadata/plate_N.json: places of the objects on the bed.
std::string PlateJson(const ArchivedPlate& plate);
/// Returns Metadata/project_settings.config.
std::string ProjectSettingsJson(const ArchivedPlate& plate);

/// Returns the documents with the elements of all plates.
std::string SliceInfoDocument(std::string_view plates);
std::string ModelSettingsDocument(std::string_view plates);
/// Returns the relations of model_settings.config to the programs of `count` plates.
std::string ModelSettingsRelations(int count);
/// Returns 3D/3dmodel.model. It has no meshes, as in all sliced archives.
std::string ModelDocument(std::string_view title);
std::string ContentTypesDocument();
/// Returns _rels/.rels, which names the model and the pictures of the first plate.
std::string RelationsDocument();

/// Returns the id of a printer of Bambu Lab, which its firmware compares; empty for other printers.
std::string_view PrinterModelId(std::string_view printer_model);

}  // namespace slicefarm::gcode
