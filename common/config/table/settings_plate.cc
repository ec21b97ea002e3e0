#include "common/config/table/bind.h"
#include "common/config/table/shared_settings.h"

namespace slicefarm::config {

namespace {

/// Returns the field of best_object_pos, a point of shares.
Field PlaceField() {
  return Convert<JobSlicingOptions>(
      [](JobSlicingOptions& row, const Value& value) {
        const auto point = ParsePoint(value.text);
        if (!point.ok()) return;
        row.best_x = ToMm(point->x);
        row.best_y = ToMm(point->y);
      },
      [](const JobSlicingOptions& row) {
        return Value{.text = PrintPoint({FromMm(row.best_x), FromMm(row.best_y)})};
      });
}

}  // namespace

std::vector<SettingSpec> PlateSettings() {
  return {
      {.key = "bed_shape",
       .kind = Kind::kBedShape,
       .unit = "mm",
       .standard = "0x0,200x0,200x200,0x200",
       .doc = "Outline of the bed: corners XxY in mm, separated by commas",
       .field = Bind<&JobSlicingOptions::bed>(),
       .orca = {{"printable_area", OrcaValue::kPoints}}},
      {.key = "max_print_height",
       .unit = "mm",
       .min = 0,
       .max = 10000,
       .standard = "200",
       .doc = "Largest height that the machine can print; a higher part is refused. 0: no limit",
       .field = Bind<&JobSlicingOptions::max_print_height_nm>(),
       .orca = {{"printable_height"}}},
      {.key = "duplicate_distance",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "6",
       .doc = "Distance between copies that are arranged automatically",
       .field = Bind<&JobSlicingOptions::part_distance_nm>()},
      {.key = "best_object_pos",
       .kind = Kind::kPoint,
       .standard = "0.5x0.5",
       .doc = "Centre of automatically arranged parts on the bed, as shares of the bed's width and "
              "depth from 0 to 1; 0.5x0.5: the middle of the bed",
       .field = PlaceField(),
       .orca = {{"best_object_pos", OrcaValue::kPoint}}},
  };
}

}  // namespace slicefarm::config
