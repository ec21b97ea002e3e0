// Methods of JobsClient for the services Profiles and Presets.
#include "services/cli/farm/jobs_client.h"
#include "services/cli/farm/jobs_client_call.h"

namespace slicefarm::cli {
namespace {

/// Deadline of a call that reads presets: the farm may have to read thousands of files first.
constexpr std::chrono::seconds kPresetsDeadline{60};

}  // namespace

absl::StatusOr<v1::Profile> JobsClient::PutProfile(const v1::PutProfileRequest& request) {
  return Call<v1::Profile>(request, [&](auto... a) { return profiles_->AsyncPutProfile(a...); });
}

absl::StatusOr<v1::Profile> JobsClient::GetProfile(const v1::GetProfileRequest& request) {
  return Call<v1::Profile>(request, [&](auto... a) { return profiles_->AsyncGetProfile(a...); });
}

absl::StatusOr<v1::ListProfilesResponse> JobsClient::ListProfiles(
    const v1::ListProfilesRequest& request) {
  return Call<v1::ListProfilesResponse>(
      request, [&](auto... a) { return profiles_->AsyncListProfiles(a...); });
}

absl::Status JobsClient::DeleteProfile(const v1::DeleteProfileRequest& request) {
  return DeleteOnce(request, [&](auto... a) { return profiles_->AsyncDeleteProfile(a...); });
}

absl::StatusOr<v1::PresetBundle> JobsClient::ImportPresets(
    const v1::ImportPresetsRequest& request) {
  return Call<v1::PresetBundle>(
      request, [&](auto... a) { return presets_->AsyncImportPresets(a...); }, kPresetsDeadline);
}

absl::StatusOr<v1::PresetBundle> JobsClient::GetPresetBundle(
    const v1::GetPresetBundleRequest& request) {
  return Call<v1::PresetBundle>(
      request, [&](auto... a) { return presets_->AsyncGetPresetBundle(a...); }, kPresetsDeadline);
}

absl::StatusOr<v1::ListPresetBundlesResponse> JobsClient::ListPresetBundles(
    const v1::ListPresetBundlesRequest& request) {
  return Call<v1::ListPresetBundlesResponse>(
      request, [&](auto... a) { return presets_->AsyncListPresetBundles(a...); });
}

absl::StatusOr<v1::ListPresetsResponse> JobsClient::ListPresets(
    const v1::ListPresetsRequest& request) {
  return Call<v1::ListPresetsResponse>(
      request, [&](auto... a) { return presets_->AsyncListPresets(a...); }, kPresetsDeadline);
}

absl::StatusOr<v1::ResolvedPresets> JobsClient::ResolvePresets(
    const v1::ResolvePresetsRequest& request) {
  return Call<v1::ResolvedPresets>(
      request, [&](auto... a) { return presets_->AsyncResolvePresets(a...); }, kPresetsDeadline);
}

absl::Status JobsClient::DeletePresetBundle(const v1::DeletePresetBundleRequest& request) {
  return DeleteOnce(request, [&](auto... a) { return presets_->AsyncDeletePresetBundle(a...); });
}

}  // namespace slicefarm::cli
