#include "processes/laser/settings/laser_settings.h"

#include <algorithm>
#include <iterator>

#include "common/config/row_table.h"
#include "common/config/table/shared_settings.h"
#include "common/macro/exposure_code.h"
#include "processes/laser/model/exposure_settings.h"
#include "processes/laser/settings/check_settings.h"
#include "processes/laser/settings/derive.h"
#include "processes/laser/settings/settings_exposure.h"

namespace slicefarm::config::laser {
namespace {

/// Returns settings with the default heights of powder and resin layers, which are thinner than
/// layers of beads.
std::vector<SettingSpec> ThinLayers() {
  std::vector<SettingSpec> all = LayerSettings();
  for (SettingSpec& spec : all) {
    if (spec.key != "layer_height" && spec.key != "first_layer_height") continue;
    spec.standard = "0.05";
    spec.doc = spec.key == "layer_height" ? "Height of a layer of powder or resin"
                                          : "Height of the first layer of powder or resin";
    spec.min = 0.001;
  }
  return all;
}

class ExposureTableRows : public RegionRows {
 public:
  absl::StatusOr<int32_t> RowOf(const JobRows& settings) override {
    return table_.Add(ExposureOf(settings).region);
  }
  int64_t size() const override { return std::ssize(table_.rows()); }
  void PutInto(JobSettings& plate) const override { ExposureOf(plate).regions = table_.rows(); }

 private:
  RowTable<ExposureOptions> table_;
};

class LaserSettings : public ProcessSettings {
 public:
  JobRows Standards() const override {
    return {.slicing = {}, .object = {}, .own = ExposureRows()};
  }
  ProcessValue PlateOf(const ProcessValue& job) const override {
    return ExposureSettings{{}, job.As<ExposureRows>().output};
  }
  std::vector<SettingSpec> Table() const override {
    constexpr SettingGroup kGroups[] = {
        {"exposure", ExposureTable}, {"layers", ThinLayers}, {"machine", PlateSettings}};
    return TableOf(kGroups);
  }
  absl::Status Derive(SettingValues& draft, ResolvedSettings& /*result*/) const override {
    return laser::Derive(draft);
  }
  absl::Status Check(const SettingValues& draft) const override { return CheckSettings(draft); }
  absl::Status Finish(const SettingValues& /*draft*/, ResolvedSettings& result) const override {
    return macro::CheckExposureCode(ExposureOf(result.settings).output, result.effective_text);
  }
  std::unique_ptr<RegionRows> NewRows() const override {
    return std::make_unique<ExposureTableRows>();
  }
  ResultWords Words() const override { return {.to_make = "to expose"}; }
  std::string_view Example() const override {
    return "slicefarm slice part.stl -o part.cli --machine laser --set scan_strategy=stripes";
  }
  std::vector<FileFormat> FileFormats() const override {
    constexpr std::string_view kKey = "output_format";
    return {{".cli", kKey, "cli", true},
            {.suffix = ".cli", .key = kKey, .value = "cli_binary", .chosen_by_name = false},
            {".nc", kKey, "grbl"},
            {".gcode", kKey, "marlin"},
            {".svg", kKey, "svg", true},
            {".dxf", kKey, "dxf", true}};
  }
};

}  // namespace

const ProcessSettings& Settings() {
  static const LaserSettings settings;
  return settings;
}

}  // namespace slicefarm::config::laser
