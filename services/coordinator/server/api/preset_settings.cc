#include "services/coordinator/server/api/preset_settings.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/presets/overlay_names.h"
#include "common/config/presets/setting_sources.h"
#include "common/wire/options/given_settings_wire.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/server/api/profile_settings.h"
#include "services/coordinator/server/messages/jobs_wire.h"

namespace slicefarm::coordinator {
namespace {

using Sources = std::vector<SettingSource>;

/// Returns the sources of all settings of the spec, the last ones last.
Sources AllSources(const v1::JobSpec& given, const v1::JobSpec& spec, const PresetJob* presets) {
  using config::presets::SourceOfAll;
  const int of_client = given.setting_sources_size();
  Sources all;
  if (of_client == 0) {
    all.push_back(SourceOfAll("project", SettingsFromProto(given.project_settings())));
    std::erase(all.back().keys, "creation_time");  // programs add it for templates
  }
  const Sources known = SourcesFromProto(spec.setting_sources());
  std::copy_n(known.begin(), of_client, std::back_inserter(all));
  if (presets != nullptr) std::ranges::copy(presets->job.sources, std::back_inserter(all));
  std::copy(known.begin() + of_client, known.end(), std::back_inserter(all));
  SettingSource config = {"config", {}}, job = {"job", {}};
  for (const v1::Setting& setting : given.settings())
    (setting.from_profile() ? config : job).keys.push_back(setting.key());
  all.push_back(std::move(config));
  all.push_back(std::move(job));
  return config::presets::LastSources(all);
}

void AddPresets(const LoadedPresets& loaded, const PresetJob& presets, v1::JobSpec& spec) {
  google::protobuf::RepeatedPtrField<v1::Setting> settings;
  SettingsToProto(presets.job.settings, &settings);
  settings.MergeFrom(spec.settings());
  spec.mutable_settings()->Swap(&settings);
  v1::JobPresets& named = *spec.mutable_presets();
  named.set_printer(presets.names.printer);
  named.set_process(presets.names.process);
  named.set_filament(presets.names.filament);
  named.mutable_bundles()->Assign(loaded.bundles().begin(), loaded.bundles().end());
  const auto warn = [&](const std::string& line) {
    const std::string text = ReplaceControls(line, '?');
    const bool is_noted = std::ranges::any_of(
        spec.notes(), [&](const v1::ProjectNote& note) { return note.text() == text; });
    if (!is_noted) spec.add_notes()->set_text(text);
  };
  for (const std::string& note : presets.notes) warn(note);
  for (const std::string& line : presets.job.of_print) warn(line + ": not supported yet");
  for (const auto* lines : {&presets.job.of_print, &presets.job.others})
    for (const std::string& line : *lines) {
      std::string text = ReplaceControls(line, '?');
      if (std::ranges::find(spec.without_effect(), text) == spec.without_effect().end())
        spec.add_without_effect(std::move(text));
    }
}

/// Presets that a spec names; both members are null if it names none.
struct NamedPresets {
  std::shared_ptr<const LoadedPresets> loaded;
  std::shared_ptr<const PresetJob> job;
};

absl::StatusOr<NamedPresets> PresetsOf(const v1::JobSpec& spec, const std::string& tenant,
                                       PresetLibrary& library) {
  if (!spec.has_presets()) return NamedPresets();
  if (spec.process() != v1::PROCESS_UNSPECIFIED && spec.process() != v1::PROCESS_FDM)
    return Malformed("spec.presets", "are only for jobs of the process FDM");
  const v1::JobPresets& named = spec.presets();
  auto loaded = library.Load(tenant, {named.bundles().begin(), named.bundles().end()});
  if (!loaded.ok()) return AsPrecondition(loaded.status());
  auto job = (*loaded)->Resolve({named.printer(), named.process(), named.filament()});
  if (!job.ok()) return AsPrecondition(job.status());
  return NamedPresets{*std::move(loaded), *std::move(job)};
}

/// Inserts the stored overlays of the presets before the profiles that the spec names.
absl::Status AddOverlays(const config::presets::PresetNames& names, const std::string& tenant,
                         ProfileStore& profiles, v1::JobSpec& spec) {
  const auto newest = [&](const std::string& name) -> absl::StatusOr<int64_t> {
    const auto record = profiles.Get(tenant, name, 0);
    if (!record.ok()) return record.status();
    return record->revision;
  };
  const auto all = config::presets::WithOverlays(
      names, {spec.profiles().begin(), spec.profiles().end()}, newest);
  if (!all.ok()) return all.status();
  spec.mutable_profiles()->Assign(all->begin(), all->end());
  return absl::OkStatus();
}

}  // namespace

bool ReportsSources(const v1::JobSpec& spec) {
  return spec.has_presets() || spec.setting_sources_size() > 0;
}

absl::StatusOr<v1::JobSpec> WithAllSettings(v1::JobSpec given, const std::string& tenant,
                                            const std::string& default_profile,
                                            ProfileStore& profiles, PresetLibrary& library) {
  const auto presets = PresetsOf(given, tenant, library);
  if (!presets.ok()) return presets.status();
  if (presets->job != nullptr)
    if (absl::Status ok = AddOverlays(presets->job->names, tenant, profiles, given); !ok.ok())
      return ok;
  auto spec = WithMachine(given, tenant, default_profile, profiles);
  if (!spec.ok() || !ReportsSources(given)) return spec;
  if (presets->job != nullptr) AddPresets(*presets->loaded, *presets->job, *spec);
  const Sources sources = AllSources(given, *spec, presets->job.get());
  spec->clear_setting_sources();
  SourcesToProto(sources, spec->mutable_setting_sources());
  return spec;
}

}  // namespace slicefarm::coordinator
