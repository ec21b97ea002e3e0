#include "services/coordinator/server/api/profile_settings.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "absl/strings/ascii.h"
#include "common/base/error.h"
#include "common/config/machine_named.h"
#include "common/model/limits.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/server/api/preset_settings.h"
#include "services/coordinator/server/messages/jobs_wire.h"

namespace slicefarm::coordinator {
namespace {

bool IsNameCharacter(char c) {
  return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.';
}

/// Adds a profile to the sources of the job's settings.
void AddSource(const v1::Profile& profile, v1::JobSpec& spec) {
  v1::SettingSource& source = *spec.add_setting_sources();
  source.set_source(fmt::format("profile {}@{}", profile.name(), profile.revision()));
  for (const v1::Setting& setting : profile.settings()) source.add_keys(setting.key());
}

}  // namespace

absl::Status AsPrecondition(const absl::Status& status) {
  if (!absl::IsNotFound(status)) return status;
  return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kProfileNotFound,
                   {status.message().data(), status.message().size()}, DetailOf(status).metadata);
}

absl::Status CheckProfileName(const std::string& name) {
  if (name.empty()) return Malformed("name", "is missing");
  if (std::ssize(name) > limits::kMaxNameBytes) {
    return LimitError(Reason::kRequestTooLarge, "bytes of a profile's name", limits::kMaxNameBytes,
                      std::ssize(name));
  }
  if (std::ranges::all_of(name, IsNameCharacter)) return absl::OkStatus();
  return Malformed("name", "may contain only letters, digits, '-', '_' and '.'");
}

absl::StatusOr<RevisionRef> ParseProfileRef(const std::string& text) {
  auto ref = ParseRevisionRef(text);
  if (!ref.ok()) return Within("name", ref.status());
  if (absl::Status named = CheckProfileName(ref->name); !named.ok()) return named;
  return ref;
}

absl::StatusOr<v1::JobSpec> WithProfiles(v1::JobSpec spec, const std::string& tenant,
                                         ProfileStore& profiles) {
  if (spec.profiles_size() > limits::kMaxJobProfiles) {
    return LimitError(Reason::kRequestTooLarge, "profiles of a job", limits::kMaxJobProfiles,
                      spec.profiles_size());
  }
  google::protobuf::RepeatedPtrField<v1::Setting> settings;
  int64_t bytes = 0;
  for (int i = 0; i < spec.profiles_size(); ++i) {
    const auto ref = ParseProfileRef(spec.profiles(i));
    if (!ref.ok()) return Within("spec.profiles", i, ref.status());
    const auto record = profiles.Get(tenant, ref->name, ref->revision);
    if (!record.ok()) return AsPrecondition(record.status());
    bytes += std::ssize(record->settings);
    if (bytes > limits::kMaxSpecBytes) {
      return LimitError(Reason::kRequestTooLarge, "bytes of a job's profiles",
                        limits::kMaxSpecBytes, bytes);
    }
    auto profile = ReadProfile(*record);
    if (!profile.ok()) return profile.status();
    settings.MergeFrom(profile->settings());
    if (ReportsSources(spec)) AddSource(*profile, spec);
    spec.set_profiles(i, fmt::format("{}@{}", record->name, record->revision));
  }
  settings.MergeFrom(spec.settings());
  spec.mutable_settings()->Swap(&settings);
  return spec;
}

absl::StatusOr<v1::JobSpec> WithMachine(const v1::JobSpec& spec, const std::string& tenant,
                                        const std::string& default_profile,
                                        ProfileStore& profiles) {
  auto all = WithProfiles(spec, tenant, profiles);
  if (!all.ok() || default_profile.empty() || spec.generic() || spec.has_presets()) return all;
  const auto request = FromProto(*all);
  if (!request.ok()) return Within("spec", request.status());
  if (config::CheckMachineNamed(request->settings, request->process).ok()) return all;
  v1::JobSpec with_default = spec;
  with_default.mutable_profiles()->Clear();
  with_default.add_profiles(default_profile);
  with_default.mutable_profiles()->MergeFrom(spec.profiles());
  return WithProfiles(std::move(with_default), tenant, profiles);
}

std::string ProfileBytes(const google::protobuf::RepeatedPtrField<v1::Setting>& settings) {
  v1::Profile profile;
  *profile.mutable_settings() = settings;
  return profile.SerializeAsString();
}

absl::StatusOr<v1::Profile> ReadProfile(const ProfileRecord& record) {
  v1::Profile profile;
  if (!profile.ParseFromString(record.settings)) {
    return MakeError(absl::StatusCode::kDataLoss, Reason::kStoreFailed,
                     fmt::format("profile {}@{} cannot be read", record.name, record.revision));
  }
  profile.set_name(record.name);
  profile.set_revision(record.revision);
  profile.set_settings_digest(record.settings_digest);
  profile.mutable_create_time()->set_seconds(record.create_us / 1'000'000);
  profile.mutable_create_time()->set_nanos(static_cast<int32_t>(record.create_us % 1'000'000) *
                                           1'000);
  return profile;
}

}  // namespace slicefarm::coordinator
