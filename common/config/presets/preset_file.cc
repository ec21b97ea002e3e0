#include "common/config/presets/preset_file.h"

#include <fmt/core.h>
#include <zip.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/model/limits.h"

namespace slicefarm::config::presets {
namespace {

struct CloseZip {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using ZipArchive = std::unique_ptr<zip_t, CloseZip>;

absl::Status BadArchive(std::string_view path, std::string_view why) {
  const std::string name = ReplaceControls(path, '?');
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   fmt::format("{}: {}", name, why), {{"part", name}});
}

absl::StatusOr<ZipArchive> OpenZip(const PresetFile& file) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(file.bytes.data(), file.bytes.size(), 0, &error);
  ZipArchive archive(source == nullptr ? nullptr
                                       : zip_open_from_source(source, ZIP_RDONLY, &error));
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  if (archive == nullptr) {
    if (source != nullptr) zip_source_free(source);
    return BadArchive(file.path, fmt::format("the archive is damaged ({})", why));
  }
  return archive;
}

/// Size and place of a file in an archive.
struct ZipEntry {
  std::string name;
  uint64_t index = 0;
  uint64_t bytes = 0;
};

absl::Status CheckZipEntry(const zip_stat_t& stat, const std::string& path) {
  constexpr zip_uint64_t kNeeded = ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE;
  if ((stat.valid & kNeeded) != kNeeded) return BadArchive(path, "a file has no size or name");
  if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE)
    return BadArchive(path, "a file is encrypted");
  if (stat.size > static_cast<zip_uint64_t>(kMaxPresetFileBytes))
    return LimitError(Reason::kRequestTooLarge, path + ": bytes of a file", kMaxPresetFileBytes,
                      static_cast<int64_t>(std::min<zip_uint64_t>(stat.size, INT64_MAX)));
  return absl::OkStatus();
}

/// Returns the files of the archive that may have presets.
absl::StatusOr<std::vector<ZipEntry>> ListZip(zip_t* archive, const PresetFile& file,
                                              int64_t max_bytes) {
  const zip_int64_t count = zip_get_num_entries(archive, 0);
  if (count > kMaxPresetFiles)
    return LimitError(Reason::kRequestTooLarge, file.path + ": files in the archive",
                      kMaxPresetFiles, count);
  std::vector<ZipEntry> entries;
  uint64_t all = 0;
  for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat_index(archive, i, 0, &stat) != 0)
      return BadArchive(file.path, "the archive's directory is damaged");
    if (absl::Status ok = CheckZipEntry(stat, file.path); !ok.ok()) return ok;
    if (!MayHavePresets(stat.name)) continue;
    entries.push_back({stat.name, i, stat.size});
    all += stat.size;
  }
  const int64_t most =
      std::min(max_bytes, limits::kFreeExpandedBytes + limits::kMaxCompressionRatio *
                                                           static_cast<int64_t>(file.bytes.size()));
  if (all > static_cast<uint64_t>(most))
    return LimitError(Reason::kRequestTooLarge, file.path + ": expanded bytes", most,
                      static_cast<int64_t>(all));
  return entries;
}

absl::StatusOr<std::string> ReadZipEntry(zip_t* archive, const ZipEntry& entry,
                                         const std::string& path) {
  const std::unique_ptr<zip_file_t, CloseZip> file(zip_fopen_index(archive, entry.index, 0));
  if (file == nullptr) return BadArchive(path, "the file in the archive is damaged");
  std::string bytes(entry.bytes + 1, '\0');  // one more byte to detect the end
  size_t size = 0;
  while (size < bytes.size()) {
    const zip_int64_t got = zip_fread(file.get(), bytes.data() + size, bytes.size() - size);
    if (got < 0) return BadArchive(path, "the file in the archive is damaged");
    if (got == 0) break;
    size += static_cast<size_t>(got);
  }
  if (size != entry.bytes)
    return BadArchive(path, "the file is not as long as the archive's directory says");
  bytes.resize(size);
  return bytes;
}

}  // namespace

bool MayHavePresets(std::string_view path) {
  constexpr std::string_view kEndings[] = {".json",   ".ini",     ".orca_printer", ".orca_filament",
                                           ".bbscfg", ".bbsflmt", ".zip"};
  return std::ranges::any_of(kEndings,
                             [&](std::string_view ending) { return path.ends_with(ending); });
}

std::string FileStem(std::string_view path) {
  path.remove_prefix(path.rfind('/') + 1);
  return std::string(path.substr(0, path.rfind('.')));
}

bool IsArchive(std::string_view bytes) { return bytes.starts_with("PK\x03\x04"); }

absl::StatusOr<std::vector<PresetFile>> UnpackArchive(const PresetFile& archive,
                                                      int64_t max_bytes) {
  const absl::StatusOr<ZipArchive> zip = OpenZip(archive);
  if (!zip.ok()) return zip.status();
  const absl::StatusOr<std::vector<ZipEntry>> entries = ListZip(zip->get(), archive, max_bytes);
  if (!entries.ok()) return entries.status();
  std::vector<PresetFile> files;
  for (const ZipEntry& entry : *entries) {
    std::string path = archive.path + "/" + ReplaceControls(entry.name, '?');
    std::replace(path.begin(), path.end(), '\\', '/');
    absl::StatusOr<std::string> bytes = ReadZipEntry(zip->get(), entry, path);
    if (!bytes.ok()) return bytes.status();
    files.push_back({std::move(path), *std::move(bytes)});
  }
  return files;
}

absl::StatusOr<std::string> PackArchive(const std::vector<PresetFile>& files) {
  constexpr time_t kNoTime = 315532800;  // 1980-01-01, the first time of the format
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* bytes = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_source_keep(bytes);
  zip_t* zip = zip_open_from_source(bytes, ZIP_TRUNCATE, &error);
  bool written = zip != nullptr;
  for (const PresetFile& file : files) {
    if (!written) break;
    zip_source_t* source = zip_source_buffer(zip, file.bytes.data(), file.bytes.size(), 0);
    const zip_int64_t at = zip_file_add(zip, file.path.c_str(), source, ZIP_FL_ENC_UTF_8);
    written = at >= 0 && zip_file_set_mtime(zip, static_cast<zip_uint64_t>(at), kNoTime, 0) == 0;
  }
  written = written && zip_close(zip) == 0 && zip_source_open(bytes) == 0;
  zip_stat_t stat;
  std::string archive;
  if (written && zip_source_stat(bytes, &stat) == 0) {
    archive.resize(stat.size);
    written = zip_source_read(bytes, archive.data(), archive.size()) ==
              static_cast<zip_int64_t>(archive.size());
    zip_source_close(bytes);
  }
  zip_source_free(bytes);
  zip_error_fini(&error);
  if (!written) return absl::InternalError("the archive of presets cannot be made");
  return archive;
}

}  // namespace slicefarm::config::presets
