#include "processes/engrave/settings/engrave_settings.h"

#include "processes/engrave/model/engrave_settings.h"
#include "processes/engrave/settings/engrave_table.h"

namespace slicefarm::config::engrave {
namespace {

class OfEngraving : public ProcessSettings {
 public:
  /// Returns the default rows. The bed is so large that any readable surface fits, because surfaces
  /// keep the positions that they have in their files.
  JobRows Standards() const override {
    JobRows standards{.slicing = {}, .object = {}, .own = EngraveSettings()};
    constexpr Coord kRoom = 2'000'000'000;
    standards.slicing.bed = {{-kRoom, -kRoom}, {kRoom, -kRoom}, {kRoom, kRoom}, {-kRoom, kRoom}};
    standards.slicing.thumbnails = {};
    return standards;
  }
  ProcessValue PlateOf(const ProcessValue& job) const override { return job.As<EngraveSettings>(); }
  std::vector<SettingSpec> Table() const override {
    constexpr SettingGroup kGroups[] = {{"engraving", EngraveTable}};
    return TableOf(kGroups);
  }
  absl::Status Derive(SettingValues& /*draft*/, ResolvedSettings& /*result*/) const override {
    return absl::OkStatus();
  }
  absl::Status Check(const SettingValues& /*draft*/) const override { return absl::OkStatus(); }
  absl::Status Finish(const SettingValues& /*draft*/, ResolvedSettings& result) const override {
    return CheckTexts(EngraveOf(result.settings));
  }
  ResultWords Words() const override { return {.to_make = "to engrave"}; }
  std::string_view Example() const override {
    return "slicefarm slice mask.obj -o mask.csv --machine engrave --texture knurl:pitch=2";
  }
  std::vector<FileFormat> FileFormats() const override {
    return {{".csv", "output_format", "csv", true}, {".nc", "output_format", "gcode"},
            {".gcode", "output_format", "gcode"},   {".stl", "output_format", "stl"},
            {".obj", "output_format", "obj"},       {".map.png", "output_format", "map_png"},
            {".png", "output_format", "png"}};
  }
};

}  // namespace

const ProcessSettings& Settings() {
  static const OfEngraving settings;
  return settings;
}

}  // namespace slicefarm::config::engrave
