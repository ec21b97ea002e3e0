#pragma once

#include <atomic>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/choose_presets.h"
#include "common/config/presets/job_presets.h"
#include "common/config/presets/preset_set.h"
#include "services/coordinator/store/jobs/profile_store.h"
#include "slicefarm/v1/presets.pb.h"

namespace slicefarm::coordinator {

/// Settings of a job with presets.
struct PresetJob {
  config::presets::PresetNames names;  ///< full names
  config::presets::JobPresets job;
  std::vector<std::string> notes;
};

/// Presets of some bundles in memory. Thread-safe.
class LoadedPresets {
 public:
  LoadedPresets(config::presets::PresetSet set, std::vector<std::string> bundles)
      : set_(std::move(set)), bundles_(std::move(bundles)) {}

  const config::presets::PresetSet& set() const { return set_; }
  /// Returns the bundles as `NAME@REVISION`.
  const std::vector<std::string>& bundles() const { return bundles_; }

  /// Returns the settings of a job with these presets. The last results are kept. Errors: as
  /// config::presets::ChoosePresets.
  absl::StatusOr<std::shared_ptr<const PresetJob>> Resolve(
      const config::presets::PresetNames& names) const;

 private:
  static constexpr size_t kKeptJobs = 64;

  const config::presets::PresetSet set_;
  const std::vector<std::string> bundles_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::shared_ptr<const PresetJob>> jobs_;  ///< jobs, by their names
};

/// Reads bundles of presets from the store, and keeps the ones that were used last in memory.
/// Thread-safe.
class PresetLibrary {
 public:
  /// Creates the library. `bundles` must outlive it.
  explicit PresetLibrary(ProfileStore& bundles) : bundles_(bundles) {}

  /// Returns the presets of bundles, each as `NAME` or `NAME@REVISION`; of all bundles if `refs` is
  /// empty. The path of each file begins with `NAME@REVISION/`. Errors: PROFILE_NOT_FOUND;
  /// REQUEST_MALFORMED for a reference; REQUEST_TOO_LARGE beyond the limits on bundles and bytes;
  /// as config::presets::ReadPresets; see ProfileStore.
  absl::StatusOr<std::shared_ptr<const LoadedPresets>> Load(const std::string& tenant,
                                                            const std::vector<std::string>& refs);

  /// Reads files that a client sends, with the limits of Load. Errors: as
  /// config::presets::ReadPresets.
  absl::StatusOr<config::presets::PresetSet> Read(const v1::PresetBundle& bundle);

  /// Number of calls of Load that found their presets in memory.
  int64_t found() const { return found_; }
  /// Number of calls of Load that read their presets from the store.
  int64_t loaded() const { return loaded_; }

  /// Drops the presets of a tenant from memory, because it has deleted some.
  void Forget(const std::string& tenant);

 private:
  static constexpr size_t kKeptSets = 8;
  struct Kept {
    std::string tenant;
    std::vector<std::string> bundles;
    std::shared_ptr<const LoadedPresets> presets;
  };

  absl::StatusOr<std::vector<std::string>> Revisions(const std::string& tenant,
                                                     const std::vector<std::string>& refs);
  std::shared_ptr<const LoadedPresets> Find(const std::string& tenant,
                                            const std::vector<std::string>& bundles);
  absl::StatusOr<config::presets::PresetSet> ReadAll(const std::string& tenant,
                                                     const std::vector<std::string>& bundles);

  ProfileStore& bundles_;
  std::mutex reading_;  ///< held while presets are read, which takes memory and up to a second
  std::atomic<int64_t> found_ = 0, loaded_ = 0;
  std::mutex mutex_;      ///< protects kept_
  std::list<Kept> kept_;  ///< the last used set first
};

/// Returns the bytes of ProfileRecord.settings for the files of a bundle.
std::string BundleBytes(const google::protobuf::RepeatedPtrField<v1::PresetFile>& files);
/// Returns the bundle with the files that the record's bytes contain. Errors: DATA_LOSS.
absl::StatusOr<v1::PresetBundle> ReadBundle(const ProfileRecord& record);

}  // namespace slicefarm::coordinator
