#include "common/config/presets/read_presets.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/base/utf8.h"
#include "common/config/presets/flat_json.h"
#include "common/config/presets/orca_presets.h"
#include "common/config/presets/prusa_bundle.h"

namespace slicefarm::config::presets {
namespace {

constexpr std::string_view kJson = ".json";

class FileSorter {
 public:
  explicit FileSorter(int64_t max_bytes) : max_bytes_(max_bytes) {}

  absl::Status Take(PresetFile file) {
    bytes_ += static_cast<int64_t>(file.bytes.size());
    ++count_;
    if (count_ > kMaxPresetFiles)
      return LimitError(Reason::kRequestTooLarge, "files of presets", kMaxPresetFiles, count_);
    if (bytes_ > max_bytes_)
      return LimitError(Reason::kRequestTooLarge, "bytes of presets", max_bytes_, bytes_);
    files_.push_back(std::move(file));
    return absl::OkStatus();
  }

  std::vector<PresetFile> Sorted() && {
    std::ranges::stable_sort(files_, {}, &PresetFile::path);
    return std::move(files_);
  }

 private:
  const int64_t max_bytes_;
  std::vector<PresetFile> files_;
  int64_t bytes_ = 0;
  int64_t count_ = 0;
};

/// Returns all files, with the files of archives instead of the archives.
absl::StatusOr<std::vector<PresetFile>> Unpacked(std::vector<PresetFile> files, int64_t max_bytes,
                                                 PresetSet& set) {
  FileSorter sorter(max_bytes);
  for (PresetFile& file : files) {
    if (!IsArchive(file.bytes)) {
      if (absl::Status ok = sorter.Take(std::move(file)); !ok.ok()) return ok;
      continue;
    }
    auto unpacked = UnpackArchive(file, max_bytes);
    if (!unpacked.ok()) {
      set.AddProblem(std::string(unpacked.status().message()));
      continue;
    }
    for (PresetFile& each : *unpacked)
      if (absl::Status ok = sorter.Take(std::move(each)); !ok.ok()) return ok;
  }
  return std::move(sorter).Sorted();
}

/// Vendor of OrcaSlicer: its folder, and the files that its list names.
struct VendorFolder {
  std::string folder;  ///< path that ends with `/`
  std::vector<std::string> paths;
  int32_t scope = 0;
};

class Reader {
 public:
  explicit Reader(PresetSet& set) : set_(set) {}

  void Read(std::vector<PresetFile> files) {
    for (const PresetFile& file : files) ReadFile(file);
    for (const VendorFolder& vendor : vendors_) AddVendor(vendor);
    AddUsers();
  }

 private:
  void Problem(const std::string& path, const absl::Status& status) {
    set_.AddProblem(path + ": " + std::string(status.message()));
  }

  void ReadFile(const PresetFile& file) {
    if (!file.path.ends_with(kJson)) {
      if (!file.path.ends_with(".ini")) return;
      if (!IsUtf8(file.bytes)) return set_.AddProblem(file.path + ": is not UTF-8 text");
      if (absl::Status status = AddIni(file, set_); !status.ok()) Problem(file.path, status);
      return;
    }
    auto json = ReadFlatJson(file.bytes);
    if (!json.ok()) return Problem(file.path, json.status());
    if (!IsVendorList(*json)) {
      json_.emplace(file.path, *std::move(json));
      return;
    }
    auto paths = PathsOfVendorList(file.bytes);
    if (!paths.ok()) return Problem(file.path, paths.status());
    const std::string base = file.path.substr(0, file.path.size() - kJson.size());
    const std::string name = base.substr(base.rfind('/') + 1);
    vendors_.push_back({base + "/", *std::move(paths), set_.AddScope({.vendor = name})});
  }

  /// Adds the presets in the order of the vendor's list. The remaining files of its folder are not
  /// used, as in OrcaSlicer.
  void AddVendor(const VendorFolder& vendor) {
    for (const std::string& path : vendor.paths) {
      const auto found = json_.find(vendor.folder + path);
      if (found == json_.end()) {
        set_.AddProblem(vendor.folder + path +
                        ": this file is in the vendor's list, but it is missing or not JSON");
        continue;
      }
      Add(found->first, std::move(found->second), vendor.scope, true);
      json_.erase(found);
    }
    const auto first = json_.lower_bound(vendor.folder);
    auto last = first;
    while (last != json_.end() && last->first.starts_with(vendor.folder)) ++last;
    json_.erase(first, last);
  }

  void AddUsers() {
    if (json_.empty()) return;
    const int32_t scope = set_.AddScope({});
    for (auto& [path, json] : json_) Add(path, std::move(json), scope, false);
  }

  void Add(const std::string& path, FlatJson json, int32_t scope, bool of_vendor) {
    const std::vector<std::string> ignored = std::move(json.ignored);
    OrcaFile file = ReadOrcaFile(path, std::move(json), of_vendor);
    if (file.is == OrcaFile::Is::kOther) return;
    for (const std::string& key : ignored)
      set_.AddProblem(fmt::format("{}: {} is neither a text nor a list of texts, and is ignored",
                                  path, ReplaceControls(key, '?')));
    if (file.is == OrcaFile::Is::kModel) {
      file.model.scope = scope;
      set_.Add(std::move(file.model));
    } else if (file.is == OrcaFile::Is::kPreset) {
      file.preset.scope = scope;
      set_.Add(std::move(file.preset));
    }
  }

  PresetSet& set_;
  std::map<std::string, FlatJson> json_;  ///< JSON files that are no vendor's list, by path
  std::vector<VendorFolder> vendors_;
};

}  // namespace

absl::StatusOr<PresetSet> ReadPresets(std::vector<PresetFile> files, int64_t max_bytes) {
  PresetSet set;
  auto unpacked = Unpacked(std::move(files), max_bytes, set);
  if (!unpacked.ok()) return unpacked.status();
  Reader(set).Read(*std::move(unpacked));
  if (!set.presets().empty()) return set;
  const std::string why = set.problems().empty() ? "" : "; " + set.problems().front();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   "there are no presets in the given files" + why);
}

}  // namespace slicefarm::config::presets
