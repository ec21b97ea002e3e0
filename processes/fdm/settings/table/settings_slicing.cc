#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {

std::vector<SettingSpec> SlicingSettings() {
  return {
      {.key = "elefant_foot_compensation",
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "0",
       .doc = "Shrinks the first layer, which spreads under its weight",
       .field = Bind([](auto& s) -> auto& { return s.slicing.objects[0].elephant_foot_nm; })},
      {.key = "thumbnails",
       .kind = Kind::kSizes,
       .unit = "pixels",
       .standard = "32x32,300x300",
       .doc = "Pictures of the part at the head of the G-code: WIDTHxHEIGHT or WIDTHxHEIGHT/FORMAT "
              "(PNG, QOI), by commas",
       .field = Bind([](auto& s) -> auto& { return s.slicing.thumbnails; })},
      {.key = "thumbnails_format",
       .kind = Kind::kChoice,
       .standard = "PNG",
       .doc = "Format of the thumbnails that name none",
       .choices = {{"PNG", static_cast<int>(PictureFormat::kPng)},
                   {"QOI", static_cast<int>(PictureFormat::kQoi)},
                   {"JPG", static_cast<int>(PictureFormat::kJpg)},
                   {"BTT_TFT", static_cast<int>(PictureFormat::kPng), "made as PNG"},
                   {"COLPIC", static_cast<int>(PictureFormat::kPng), "made as PNG"}}},
  };
}

}  // namespace slicefarm::config::fdm
