#include "common/gcode/archive/zip_bytes.h"

#include <fmt/core.h>
#include <zip.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "common/base/text.h"

namespace slicefarm::gcode {
namespace {

/// Date 1980-01-01 in the form of ZIP.
constexpr zip_uint16_t kFirstDosDate = (1 << 5) | 1;
constexpr zip_uint32_t kFileMode = 0100644;

struct DiscardZip {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_file_t* file) const { zip_fclose(file); }
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using OpenedZip = std::unique_ptr<zip_t, DiscardZip>;

std::string Shown(std::string_view name) {
  constexpr size_t kMostBytes = 128;
  return ReplaceControls(name.substr(0, kMostBytes), '?');
}

absl::Status NotWritten(const char* why) {
  return absl::InternalError(fmt::format("the ZIP archive cannot be made: {}", why));
}

absl::Status AddMember(zip_t* archive, const ZipMember& member) {
  zip_source_t* source = zip_source_buffer(archive, member.data.data(), member.data.size(), 0);
  if (source == nullptr) return NotWritten(zip_strerror(archive));
  const zip_int64_t at = zip_file_add(archive, member.name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (at < 0) {
    zip_source_free(source);
    return NotWritten(zip_strerror(archive));
  }
  const auto index = static_cast<zip_uint64_t>(at);
  constexpr zip_uint32_t kLevel = 6;  // a third of the time of level 9, and 1 % larger
  const zip_int32_t method = member.deflated ? ZIP_CM_DEFLATE : ZIP_CM_STORE;
  if (zip_set_file_compression(archive, index, method, kLevel) != 0 ||
      zip_file_set_dostime(archive, index, 0, kFirstDosDate, 0) != 0 ||
      zip_file_set_external_attributes(archive, index, 0, ZIP_OPSYS_UNIX, kFileMode << 16) != 0)
    return NotWritten(zip_strerror(archive));
  return absl::OkStatus();
}

absl::StatusOr<std::string> BytesOf(zip_source_t* source) {
  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_source_stat(source, &stat) != 0 || zip_source_open(source) != 0)
    return NotWritten("its bytes cannot be read");
  std::string bytes(stat.size, '\0');
  const zip_int64_t got = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (got != static_cast<zip_int64_t>(bytes.size())) return NotWritten("its bytes are incomplete");
  return bytes;
}

absl::StatusOr<OpenedZip> OpenZip(std::string_view bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  OpenedZip archive(source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error));
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  if (archive != nullptr) return archive;
  if (source != nullptr) zip_source_free(source);
  return absl::InvalidArgumentError(fmt::format("the ZIP archive is damaged ({})", why));
}

absl::Status DamagedEntry(const std::string& name, std::string_view why) {
  return absl::InvalidArgumentError(fmt::format("{} in the archive {}", Shown(name), why));
}

absl::Status CheckSize(const ZipEntryInfo& entry) {
  const auto most = static_cast<uint64_t>(kFreeZipBytes) +
                    static_cast<uint64_t>(kMaxZipRatio) * entry.packed_bytes;
  const uint64_t limit = std::min(most, static_cast<uint64_t>(kMaxZipMemberBytes));
  if (entry.bytes <= limit) return absl::OkStatus();
  return DamagedEntry(entry.name, fmt::format("claims to expand from {} to {} bytes; at most {} "
                                              "are accepted",
                                              entry.packed_bytes, entry.bytes, limit));
}

}  // namespace

absl::StatusOr<std::string> ZipOf(const std::vector<ZipMember>& members) {
  zip_error_t error;
  zip_error_init(&error);
  const std::unique_ptr<zip_source_t, DiscardZip> bytes(
      zip_source_buffer_create(nullptr, 0, 0, &error));
  if (bytes == nullptr) return NotWritten("out of memory");
  zip_source_keep(bytes.get());  // for the archive, which releases its source
  OpenedZip archive(zip_open_from_source(bytes.get(), ZIP_TRUNCATE, &error));
  zip_error_fini(&error);
  if (archive == nullptr) return NotWritten("out of memory");
  for (const ZipMember& member : members)
    if (absl::Status added = AddMember(archive.get(), member); !added.ok()) return added;
  if (zip_close(archive.get()) != 0) return NotWritten(zip_strerror(archive.get()));
  static_cast<void>(archive.release());
  return BytesOf(bytes.get());
}

absl::StatusOr<std::vector<ZipEntryInfo>> ZipEntries(std::string_view archive) {
  const absl::StatusOr<OpenedZip> zip = OpenZip(archive);
  if (!zip.ok()) return zip.status();
  const zip_int64_t count = zip_get_num_entries(zip->get(), 0);
  if (count > kMaxZipEntries)
    return absl::InvalidArgumentError(
        fmt::format("the archive has {} files; at most {} are accepted", count, kMaxZipEntries));
  std::vector<ZipEntryInfo> entries;
  for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
    zip_stat_t stat;
    zip_stat_init(&stat);
    constexpr zip_uint64_t kNeeded = ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE;
    if (zip_stat_index(zip->get(), i, ZIP_FL_ENC_RAW, &stat) != 0 ||
        (stat.valid & kNeeded) != kNeeded)
      return absl::InvalidArgumentError("the directory of the archive is damaged");
    entries.push_back({stat.name, i, stat.size, stat.comp_size});
  }
  return entries;
}

absl::StatusOr<std::string> ZipData(std::string_view archive, const ZipEntryInfo& entry) {
  if (absl::Status ok = CheckSize(entry); !ok.ok()) return ok;
  const absl::StatusOr<OpenedZip> zip = OpenZip(archive);
  if (!zip.ok()) return zip.status();
  const std::unique_ptr<zip_file_t, DiscardZip> file(zip_fopen_index(zip->get(), entry.index, 0));
  if (file == nullptr)
    return DamagedEntry(entry.name, fmt::format("cannot be read ({})", zip_strerror(zip->get())));
  std::string data(entry.bytes + 1, '\0');  // one more byte to detect the end
  size_t size = 0;
  while (size < data.size()) {
    const zip_int64_t got = zip_fread(file.get(), data.data() + size, data.size() - size);
    if (got < 0) return DamagedEntry(entry.name, "is damaged");
    if (got == 0) break;
    size += static_cast<size_t>(got);
  }
  if (size != entry.bytes)
    return DamagedEntry(entry.name, "is not as long as the directory of the archive says");
  data.resize(size);
  return data;
}

}  // namespace slicefarm::gcode
