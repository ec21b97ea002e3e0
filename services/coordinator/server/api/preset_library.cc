#include "services/coordinator/server/api/preset_library.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "common/base/error.h"
#include "common/config/presets/read_presets.h"
#include "common/model/limits.h"
#include "services/coordinator/server/api/profile_settings.h"

namespace slicefarm::coordinator {
namespace {

namespace presets = config::presets;

void AddFiles(const v1::PresetBundle& bundle, const std::string& prefix,
              std::vector<presets::PresetFile>& files) {
  for (const v1::PresetFile& file : bundle.files())
    files.push_back({prefix + file.path(), file.content()});
}

absl::Status NoBundles() {
  return MakeError(absl::StatusCode::kNotFound, Reason::kProfileNotFound,
                   "the farm has no presets of this tenant: import them with `slicefarm presets "
                   "import`");
}

}  // namespace

absl::StatusOr<std::shared_ptr<const PresetJob>> LoadedPresets::Resolve(
    const presets::PresetNames& names) const {
  const std::string key = names.printer + '\n' + names.process + '\n' + names.filament;
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = jobs_.find(key); found != jobs_.end()) return found->second;
  }
  auto chosen = ChoosePresets(set_, names);
  if (!chosen.ok()) return chosen.status();
  auto job = SettingsOfPresets(set_, *chosen);
  if (!job.ok()) return job.status();
  auto made = std::make_shared<PresetJob>();
  made->names = {chosen->printer->name, chosen->process->name, chosen->filament->name};
  made->job = *std::move(job);
  made->notes = std::move(chosen->notes);
  const std::lock_guard lock(mutex_);
  if (jobs_.size() >= kKeptJobs) jobs_.clear();
  return jobs_[key] = std::move(made);
}

absl::StatusOr<std::vector<std::string>> PresetLibrary::Revisions(
    const std::string& tenant, const std::vector<std::string>& refs) {
  constexpr auto kMost = static_cast<int32_t>(limits::kMaxPresetBundles);
  const auto newest = bundles_.List(tenant, "", kMost + 1);
  if (!newest.ok()) return newest.status();
  std::vector<std::string> revisions;
  if (refs.empty()) {
    if (newest->empty()) return NoBundles();
    for (const ProfileRecord& record : *newest)
      revisions.push_back(fmt::format("{}@{}", record.name, record.revision));
  }
  for (const std::string& text : refs) {
    const auto ref = ParseProfileRef(text);
    if (!ref.ok()) return ref.status();
    int64_t revision = ref->revision;
    const auto found = std::ranges::find(*newest, ref->name, &ProfileRecord::name);
    if (revision == 0 && found != newest->end()) revision = found->revision;
    if (revision == 0) return bundles_.Get(tenant, ref->name, 0).status();
    revisions.push_back(fmt::format("{}@{}", ref->name, revision));
  }
  if (std::ssize(revisions) > limits::kMaxPresetBundles)
    return LimitError(Reason::kRequestTooLarge, "bundles of presets", limits::kMaxPresetBundles,
                      std::ssize(revisions));
  return revisions;
}

std::shared_ptr<const LoadedPresets> PresetLibrary::Find(const std::string& tenant,
                                                         const std::vector<std::string>& bundles) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find_if(
      kept_, [&](const Kept& each) { return each.tenant == tenant && each.bundles == bundles; });
  if (found == kept_.end()) return nullptr;
  kept_.splice(kept_.begin(), kept_, found);
  ++found_;
  return kept_.front().presets;
}

absl::StatusOr<presets::PresetSet> PresetLibrary::ReadAll(const std::string& tenant,
                                                          const std::vector<std::string>& bundles) {
  std::vector<presets::PresetFile> files;
  int64_t bytes = 0;
  for (const std::string& each : bundles) {
    const auto ref = ParseProfileRef(each);
    if (!ref.ok()) return ref.status();
    const auto record = bundles_.Get(tenant, ref->name, ref->revision);
    if (!record.ok()) return record.status();
    bytes += std::ssize(record->settings);
    if (bytes > limits::kMaxJobPresetBytes)
      return LimitError(Reason::kRequestTooLarge, "bytes of a job's presets",
                        limits::kMaxJobPresetBytes, bytes);
    const auto bundle = ReadBundle(*record);
    if (!bundle.ok()) return bundle.status();
    AddFiles(*bundle, each + "/", files);
  }
  return presets::ReadPresets(std::move(files), limits::kMaxJobPresetBytes);
}

absl::StatusOr<std::shared_ptr<const LoadedPresets>> PresetLibrary::Load(
    const std::string& tenant, const std::vector<std::string>& refs) {
  auto bundles = Revisions(tenant, refs);
  if (!bundles.ok()) return bundles.status();
  if (auto found = Find(tenant, *bundles)) return found;
  const std::lock_guard reading(reading_);
  if (auto found = Find(tenant, *bundles)) return found;  // another call has read them
  ++loaded_;
  auto set = ReadAll(tenant, *bundles);
  if (!set.ok()) return set.status();
  auto loaded = std::make_shared<const LoadedPresets>(*std::move(set), *bundles);
  const std::lock_guard lock(mutex_);
  kept_.push_front({tenant, *std::move(bundles), loaded});
  if (kept_.size() > kKeptSets) kept_.pop_back();
  return loaded;
}

absl::StatusOr<presets::PresetSet> PresetLibrary::Read(const v1::PresetBundle& bundle) {
  std::vector<presets::PresetFile> files;
  AddFiles(bundle, "", files);
  const std::lock_guard reading(reading_);
  return presets::ReadPresets(std::move(files), limits::kMaxJobPresetBytes);
}

void PresetLibrary::Forget(const std::string& tenant) {
  const std::lock_guard lock(mutex_);
  std::erase_if(kept_, [&](const Kept& each) { return each.tenant == tenant; });
}

std::string BundleBytes(const google::protobuf::RepeatedPtrField<v1::PresetFile>& files) {
  v1::PresetBundle bundle;
  *bundle.mutable_files() = files;
  return bundle.SerializeAsString();
}

absl::StatusOr<v1::PresetBundle> ReadBundle(const ProfileRecord& record) {
  v1::PresetBundle bundle;
  if (!bundle.ParseFromString(record.settings)) {
    return MakeError(absl::StatusCode::kDataLoss, Reason::kStoreFailed,
                     fmt::format("presets {}@{} cannot be read", record.name, record.revision));
  }
  bundle.set_name(record.name);
  bundle.set_revision(record.revision);
  bundle.set_digest(record.settings_digest);
  bundle.mutable_create_time()->set_seconds(record.create_us / 1'000'000);
  bundle.mutable_create_time()->set_nanos(static_cast<int32_t>(record.create_us % 1'000'000) *
                                          1'000);
  return bundle;
}

}  // namespace slicefarm::coordinator
