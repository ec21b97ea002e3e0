#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/preset_file.h"
#include "common/config/presets/preset_set.h"
#include "services/cli/farm/jobs_client.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {

/// Files of one bundle of presets, to be imported.
struct BundleFiles {
  std::string name;
  std::vector<config::presets::PresetFile> files;
};

/// Divides files into bundles, by name. Each vendor is a bundle: VENDOR.json with the folder
/// VENDOR, or VENDOR.ini. All other files are the bundle `rest`. Characters that a bundle's name
/// may not have become `_`.
std::vector<BundleFiles> BundlesOf(std::vector<config::presets::PresetFile> files,
                                   const std::string& rest);

/// Returns the request for the import of a bundle. Files that are too large for a message are
/// packed. Errors: REQUEST_TOO_LARGE if they do not fit even so.
absl::StatusOr<v1::ImportPresetsRequest> ImportRequest(const BundleFiles& bundle);

/// Returns the presets that a job names as a message.
v1::JobPresets PresetsToProto(const PresetOptions& options);

/// Fetches the presets of bundles from the farm, each `NAME` or `NAME@REVISION`; all bundles if
/// `bundles` is empty. Errors: see JobsClient and config::presets::ReadPresets.
absl::StatusOr<config::presets::PresetSet> FetchPresets(const std::vector<std::string>& bundles,
                                                        JobsClient& client);

}  // namespace slicefarm::cli
