#include "services/cli/farm/farm_presets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

#include "common/base/error.h"
#include "common/base/revision_ref.h"
#include "common/config/presets/flat_json.h"
#include "common/config/presets/orca_presets.h"
#include "common/config/presets/read_presets.h"

namespace slicefarm::cli {
namespace {

namespace presets = config::presets;

/// Bytes of a message that an import may use; the rest is for paths and framing.
constexpr int64_t kMessageBytes = 3 << 20;

std::string BundleName(std::string_view text) {
  std::string name(text);
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '.') c = '_';
  return name;
}

std::string FolderOf(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

/// Returns the folders of vendors, ending with `/`. A list of the same name is beside each.
std::set<std::string> VendorFolders(const std::vector<presets::PresetFile>& files) {
  constexpr std::string_view kJson = ".json";
  std::set<std::string> folders;
  for (const presets::PresetFile& file : files) {
    if (!file.path.ends_with(kJson)) continue;
    const auto json = presets::ReadFlatJson(file.bytes);
    if (json.ok() && presets::IsVendorList(*json))
      folders.insert(file.path.substr(0, file.path.size() - kJson.size()) + "/");
  }
  return folders;
}

/// Returns true for a bundle of PrusaSlicer, and false for the preset of a user, which is in a
/// folder of its kind.
bool IsVendorIni(const std::string& path) {
  if (!path.ends_with(".ini")) return false;
  constexpr std::string_view kFoldersOfUsers[] = {"/print/", "/filament/", "/printer/"};
  const std::string folder = "/" + FolderOf(path);
  return std::ranges::none_of(kFoldersOfUsers,
                              [&](std::string_view each) { return folder.ends_with(each); });
}

int64_t BytesOf(const std::vector<presets::PresetFile>& files) {
  int64_t bytes = 0;
  for (const presets::PresetFile& file : files)
    bytes += std::ssize(file.path) + std::ssize(file.bytes);
  return bytes;
}

absl::StatusOr<v1::PresetBundle> FetchBundle(const std::string& ref, JobsClient& client) {
  const auto of = ParseRevisionRef(ref);
  if (!of.ok()) return of.status();
  v1::GetPresetBundleRequest get;
  get.set_name(of->name);
  get.set_revision(of->revision);
  return client.GetPresetBundle(get);
}

}  // namespace

std::vector<BundleFiles> BundlesOf(std::vector<presets::PresetFile> files,
                                   const std::string& rest) {
  const std::set<std::string> folders = VendorFolders(files);
  std::map<std::string, std::vector<presets::PresetFile>> bundles;
  for (presets::PresetFile& file : files) {
    const std::string base = file.path.substr(0, file.path.rfind('.'));
    std::string folder = folders.contains(base + "/") ? base + "/" : "";
    for (const std::string& each : folders)
      if (file.path.starts_with(each)) folder = each;
    std::string name = rest;
    if (!folder.empty()) {
      const std::string above = FolderOf(folder.substr(0, folder.size() - 1));
      name = folder.substr(above.size(), folder.size() - above.size() - 1);
      file.path = file.path.substr(above.size());
    } else if (IsVendorIni(file.path)) {
      name = presets::FileStem(file.path);
      file.path = file.path.substr(FolderOf(file.path).size());
    }
    bundles[BundleName(name)].push_back(std::move(file));
  }
  std::vector<BundleFiles> all;
  for (auto& [name, of_bundle] : bundles) {
    std::ranges::sort(of_bundle, {}, &presets::PresetFile::path);
    all.push_back({name, std::move(of_bundle)});
  }
  return all;
}

absl::StatusOr<v1::ImportPresetsRequest> ImportRequest(const BundleFiles& bundle) {
  v1::ImportPresetsRequest request;
  request.set_name(bundle.name);
  const auto add = [&](const std::string& path, const std::string& bytes) {
    v1::PresetFile& file = *request.add_files();
    file.set_path(path);
    file.set_content(bytes);
  };
  if (BytesOf(bundle.files) <= kMessageBytes) {
    for (const presets::PresetFile& file : bundle.files) add(file.path, file.bytes);
    return request;
  }
  const auto packed = presets::PackArchive(bundle.files);
  if (!packed.ok()) return packed.status();
  if (std::ssize(*packed) > kMessageBytes)
    return LimitError(Reason::kRequestTooLarge,
                      fmt::format("bytes of the bundle {}, packed", bundle.name), kMessageBytes,
                      std::ssize(*packed));
  add(bundle.name + ".zip", *packed);
  return request;
}

v1::JobPresets PresetsToProto(const PresetOptions& options) {
  v1::JobPresets names;
  names.set_printer(options.printer);
  names.set_process(options.process);
  names.set_filament(options.filament);
  names.mutable_bundles()->Assign(options.bundles.begin(), options.bundles.end());
  return names;
}

absl::StatusOr<presets::PresetSet> FetchPresets(const std::vector<std::string>& bundles,
                                                JobsClient& client) {
  std::vector<std::string> refs = bundles;
  v1::ListPresetBundlesRequest list;
  do {
    if (!bundles.empty()) break;
    const auto page = client.ListPresetBundles(list);
    if (!page.ok()) return page.status();
    for (const v1::PresetBundle& each : page->bundles())
      refs.push_back(fmt::format("{}@{}", each.name(), each.revision()));
    list.set_page_token(page->next_page_token());
  } while (!list.page_token().empty());
  if (refs.empty())
    return MakeError(absl::StatusCode::kNotFound, Reason::kProfileNotFound,
                     "the farm has no presets: import some with `slicefarm presets import "
                     "DIR|FILE`, or read them from files with --presets DIR|FILE");
  std::vector<presets::PresetFile> files;
  for (const std::string& ref : refs) {
    const auto bundle = FetchBundle(ref, client);
    if (!bundle.ok()) return bundle.status();
    for (const v1::PresetFile& file : bundle->files())
      files.push_back({fmt::format("{}@{}/{}", bundle->name(), bundle->revision(), file.path()),
                       file.content()});
  }
  return presets::ReadPresets(std::move(files));
}

}  // namespace slicefarm::cli
