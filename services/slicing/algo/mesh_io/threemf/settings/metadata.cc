#include "services/slicing/algo/mesh_io/threemf/settings/metadata.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "common/base/text.h"
#include "services/slicing/algo/mesh_io/threemf/package/file_location.h"
#include "services/slicing/algo/mesh_io/threemf/settings/height_codes.h"
#include "services/slicing/algo/mesh_io/threemf/settings/setting_list.h"

namespace slicefarm::slicing::threemf {
namespace {

/// Paths of the files of one family of slicers.
struct Names {
  std::string_view project, model, ranges, heights, profiles;
};

constexpr Names kPrusaNames = {"Metadata/Slic3r_PE.config", "Metadata/Slic3r_PE_model.config",
                               "Metadata/Prusa_Slicer_layer_config_ranges.xml",
                               "Metadata/Prusa_Slicer_custom_gcode_per_print_z.xml",
                               "Metadata/Slic3r_PE_layer_heights_profile.txt"};
constexpr Names kOrcaNames = {"Metadata/project_settings.config", "Metadata/model_settings.config",
                              "Metadata/layer_config_ranges.xml",
                              "Metadata/custom_gcode_per_layer.xml",
                              "Metadata/layer_heights_profile.txt"};

/// File of a slicer that has no effect in slicefarm. `mark`: text that the file contains if the
/// feature is in use. `words`: description for the user.
struct Idle {
  std::string_view name;
  std::string_view mark;
  std::string_view words;
};

constexpr std::array<Idle, 8> kIdle = {{
    {"Metadata/Prusa_Slicer_custom_gcode_per_print_z.xml", "type=\"2\"",
     "changes of tool at certain heights"},
    {"Metadata/custom_gcode_per_layer.xml", "type=\"2\"", "changes of tool at certain heights"},
    {"Metadata/brim_ear_points.txt", "object_id", "brim ears"},
    {"Metadata/Slic3r_PE_sla_support_points.txt", "object_id", "support points of resin printers"},
    {"Metadata/Slic3r_PE_sla_drain_holes.txt", "object_id", "drain holes of resin printers"},
    {"Metadata/Prusa_Slicer_cut_information.xml", "<connector", "connectors of cut objects"},
    {"Metadata/cut_information.xml", "<connector", "connectors of cut objects"},
    {"Metadata/SuperSlicer_model.config", "key=\"print_extrusion_multiplier\"",
     "flows of single objects (print_extrusion_multiplier of SuperSlicer)"},
}};

template <typename T, typename Read>
absl::StatusOr<T> ReadIfThere(const Archive& archive, std::string_view name, const Read& read) {
  const ArchiveEntry* entry = archive.Find(name);
  if (entry == nullptr) return T();
  const absl::StatusOr<std::string> text = archive.ReadAll(*entry);
  if (!text.ok()) return text.status();
  return read(*text, entry->name);
}

/// Returns the number of beds, from the positions of the wipe tower that PrusaSlicer 2.9 stores for
/// each bed. The file has one element per bed and no root, so it is no valid XML.
size_t CountBeds(std::string_view wipe_towers) {
  constexpr int kMostBeds = 9;  // limit of PrusaSlicer
  for (int index = kMostBeds - 1; index > 0; --index)
    if (wipe_towers.find(fmt::format("bed_idx=\"{}\"", index)) != std::string_view::npos)
      return static_cast<size_t>(index) + 1;
  return 1;
}

absl::StatusOr<std::vector<PlateSettings>> ReadBeds(const Archive& archive) {
  const auto count =
      ReadIfThere<size_t>(archive, "Metadata/Prusa_Slicer_wipe_tower_information.xml",
                          [](std::string_view text, const std::string&) -> absl::StatusOr<size_t> {
                            return CountBeds(text);
                          });
  if (!count.ok()) return count.status();
  std::vector<PlateSettings> beds(*count > 1 ? *count : 0);
  for (size_t i = 0; i < beds.size(); ++i) beds[i].number = static_cast<int64_t>(i) + 1;
  return beds;
}

/// Adds the codes at heights as a setting of their plate, or of the project if there are no plates.
absl::Status AddHeightCodes(const PlateHeightCodes& codes, Metadata& metadata) {
  constexpr std::string_view kKey = "custom_gcode_per_print_z";
  std::vector<PlateSettings>& plates =
      metadata.beds.empty() ? metadata.model.plates : metadata.beds;
  if (plates.empty()) {
    const auto first = codes.find(1);
    if (first == codes.end()) return absl::OkStatus();
    return AddSetting(kKey, PrintHeightCodes(first->second), metadata.project.settings);
  }
  for (PlateSettings& plate : plates) {
    const auto own = codes.find(plate.number);
    if (own == codes.end()) continue;
    absl::Status added = AddSetting(kKey, PrintHeightCodes(own->second), plate.settings);
    if (!added.ok()) return added;
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<Metadata> ReadMetadata(const Archive& archive) {
  Metadata metadata;
  const bool orca =
      archive.Find(kOrcaNames.project) != nullptr || archive.Find(kOrcaNames.model) != nullptr;
  metadata.dialect = orca ? SettingsDialect::kOrca : SettingsDialect::kPrusa;
  const Names& names = orca ? kOrcaNames : kPrusaNames;
  metadata.has_printer = archive.Find(names.project) != nullptr;
  absl::StatusOr<ProjectSettings> project = ReadIfThere<ProjectSettings>(
      archive, names.project, orca ? ReadOrcaSettings : ReadPrusaSettings);
  if (!project.ok()) return project.status();
  absl::StatusOr<ModelSettings> model =
      ReadIfThere<ModelSettings>(archive, names.model, ReadModelSettings);
  if (!model.ok()) return model.status();
  absl::StatusOr<std::vector<PlateSettings>> beds = std::vector<PlateSettings>();
  if (!orca) beds = ReadBeds(archive);
  if (!beds.ok()) return beds.status();
  metadata.beds = *std::move(beds);
  absl::StatusOr<HeightRanges> ranges =
      ReadIfThere<HeightRanges>(archive, names.ranges, ReadHeightRanges);
  if (!ranges.ok()) return ranges.status();
  metadata.project = *std::move(project);
  metadata.model = *std::move(model);
  metadata.ranges = *std::move(ranges);
  absl::StatusOr<HeightProfiles> profiles =
      ReadIfThere<HeightProfiles>(archive, names.profiles, ReadHeightProfiles);
  if (!profiles.ok()) return profiles.status();
  metadata.profiles = *std::move(profiles);
  const auto heights = ReadIfThere<PlateHeightCodes>(archive, names.heights, ReadHeightCodes);
  if (!heights.ok()) return heights.status();
  absl::Status added = AddHeightCodes(*heights, metadata);
  if (!added.ok()) return WithLocation({std::string(names.heights), 1}, added);
  return metadata;
}

absl::StatusOr<std::vector<std::string>> FilesWithoutEffect(const Archive& archive) {
  std::vector<std::string> words;
  for (const Idle& idle : kIdle) {
    const ArchiveEntry* entry = archive.Find(idle.name);
    if (entry == nullptr || entry->bytes == 0) continue;
    const absl::StatusOr<std::string> text = archive.ReadAll(*entry);
    if (!text.ok()) return text.status();
    if (text->find(idle.mark) != std::string::npos) words.emplace_back(idle.words);
  }
  const auto is_cura = [](const ArchiveEntry& entry) { return entry.name.starts_with("Cura/"); };
  if (std::ranges::any_of(archive.entries(), is_cura))
    words.emplace_back(
        "settings of this Cura project, which are not read (use a profile with --config)");
  const auto is_gcode = [](const ArchiveEntry& entry) { return entry.name.ends_with(".gcode"); };
  if (std::ranges::any_of(archive.entries(), is_gcode))
    words.emplace_back("G-code in the project: the parts are sliced again");
  return words;
}

}  // namespace slicefarm::slicing::threemf
