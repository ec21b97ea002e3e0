#include "services/slicing/algo/mesh_io/threemf/package/archive.h"

#include <fmt/core.h>
#include <zip.h>

#include <algorithm>
#include <new>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/model/limits.h"

namespace slicefarm::slicing::threemf {
namespace {

/// Calls the new handler and then throws, as operator new does. Needed because C libraries return
/// an error when no memory is left, without calling the handler.
[[noreturn]] void OutOfMemory() {
  if (const std::new_handler handler = std::get_new_handler()) handler();
  throw std::bad_alloc();
}

std::string Printable(std::string_view part) {
  constexpr size_t kMostBytes = 128;
  return ReplaceControls(part.substr(0, kMostBytes), '?');
}

/// Returns the error for a libzip code that means damaged or unsupported data.
absl::Status ZipError(std::string_view part, int code) {
  switch (code) {
    case ZIP_ER_MEMORY:
      OutOfMemory();
    case ZIP_ER_NOZIP:
      return PartError(
          part, "the archive has no directory at its end: it is incomplete, or not a ZIP file",
          true);
    case ZIP_ER_READ:
    case ZIP_ER_EOF:
      return PartError(part, "ends before the size in the archive's directory", true);
    case ZIP_ER_CRC:
      return PartError(part, "is damaged: its checksum is wrong");
    default:
      break;
  }
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  absl::Status status = PartError(part, fmt::format("is damaged ({})", zip_error_strerror(&error)));
  zip_error_fini(&error);
  return status;
}

char LowerCase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string KeyOf(std::string_view name) {
  if (name.starts_with('/')) name.remove_prefix(1);
  std::string key(name);
  std::transform(key.begin(), key.end(), key.begin(), LowerCase);
  return key;
}

bool LeadsOut(std::string_view name) {
  if (name.empty() || name[0] == '/' || (name.size() > 1 && name[1] == ':')) return true;
  const std::vector<std::string_view> folders = Split(name, "/");
  return std::find(folders.begin(), folders.end(), "..") != folders.end();
}

absl::Status CheckName(std::string_view name) {
  if (std::any_of(name.begin(), name.end(), IsControl))
    return PartError(name, "has control characters in its name");
  if (LeadsOut(name)) return PartError(name, "has a name that points outside the archive");
  return absl::OkStatus();
}

/// Checks the ratio of `expanded` to `packed` bytes against the limit.
absl::Status CheckRatio(std::string_view part, int64_t expanded, int64_t packed) {
  const int64_t most = limits::kFreeExpandedBytes + limits::kMaxCompressionRatio * packed;
  if (expanded <= most) return absl::OkStatus();
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kMeshTooLarge,
      fmt::format("{} claims to expand from {} to {} bytes; at most {} times is accepted",
                  Printable(part), packed, expanded, limits::kMaxCompressionRatio),
      {{"limit", std::to_string(most)},
       {"got", std::to_string(expanded)},
       {"part", Printable(part)}});
}

absl::Status CheckEntry(const zip_stat_t& stat, int64_t file_bytes) {
  constexpr zip_uint64_t kNeeded = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD;
  if ((stat.valid & kNeeded) != kNeeded) return PartError(stat.name, "has no size");
  if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE)
    return PartError(stat.name, "is encrypted");
  if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE)
    return PartError(stat.name,
                     fmt::format("is packed by method {}, not deflate", stat.comp_method));
  if (stat.comp_size > static_cast<zip_uint64_t>(file_bytes))
    return PartError(stat.name, "is larger than the archive", true);
  if (stat.size > static_cast<zip_uint64_t>(limits::kMaxExpandedArchiveBytes))
    return LimitError(Reason::kMeshTooLarge, "bytes of the archive, expanded",
                      limits::kMaxExpandedArchiveBytes,
                      static_cast<int64_t>(std::min<zip_uint64_t>(stat.size, INT64_MAX)));
  return CheckRatio(stat.name, static_cast<int64_t>(stat.size),
                    static_cast<int64_t>(stat.comp_size));
}

}  // namespace

absl::Status PartError(std::string_view part, std::string_view reason_text, bool truncated) {
  return MakeError(absl::StatusCode::kInvalidArgument,
                   truncated ? Reason::kMeshTruncated : Reason::kMeshMalformed,
                   fmt::format("{}: {}", Printable(part), reason_text),
                   {{"part", Printable(part)}});
}

void EntryStream::Closer::operator()(zip_file* file) const { zip_fclose(file); }

absl::StatusOr<size_t> EntryStream::Read(std::span<char> into) {
  const zip_int64_t got = zip_fread(file_.get(), into.data(), into.size());
  if (got < 0) return ZipError(part_, zip_error_code_zip(zip_file_get_error(file_.get())));
  left_ -= got;
  if (left_ < 0) return PartError(part_, "is larger than the size in the archive's directory");
  if (got == 0 && left_ > 0)
    return PartError(part_, "ends before the size in the archive's directory", true);
  return static_cast<size_t>(got);
}

void Archive::Discarder::operator()(zip* archive) const { zip_discard(archive); }

absl::StatusOr<Archive> Archive::Open(std::string_view bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source == nullptr) OutOfMemory();
  Archive archive;
  archive.zip_.reset(zip_open_from_source(source, ZIP_RDONLY, &error));
  const int code = zip_error_code_zip(&error);
  zip_error_fini(&error);
  if (archive.zip_ == nullptr) {
    zip_source_free(source);
    return ZipError("the 3MF file", code);
  }
  absl::Status status = archive.List(static_cast<int64_t>(bytes.size()));
  if (!status.ok()) return status;
  return archive;
}

absl::Status Archive::List(int64_t file_bytes) {
  const zip_int64_t count = zip_get_num_entries(zip_.get(), 0);
  if (count > limits::kMaxArchiveEntries)
    return LimitError(Reason::kMeshTooLarge, "files in the archive", limits::kMaxArchiveEntries,
                      count);
  int64_t expanded = 0;
  for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat_index(zip_.get(), i, ZIP_FL_ENC_RAW, &stat) != 0)
      return ZipError("the 3MF file", zip_error_code_zip(zip_get_error(zip_.get())));
    ArchiveEntry entry = {.name = stat.name, .bytes = 0, .index = i};
    std::replace(entry.name.begin(), entry.name.end(), '\\', '/');
    absl::Status status = CheckName(entry.name);
    if (status.ok()) status = CheckEntry(stat, file_bytes);
    if (!status.ok()) return status;
    entry.bytes = static_cast<int64_t>(stat.size);
    expanded += entry.bytes;
    by_key_.emplace_back(KeyOf(entry.name), entries_.size());
    entries_.push_back(std::move(entry));
  }
  std::sort(by_key_.begin(), by_key_.end());
  const auto twice =
      std::adjacent_find(by_key_.begin(), by_key_.end(),
                         [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice != by_key_.end()) return PartError(twice->first, "is in the archive twice");
  if (expanded > limits::kMaxExpandedArchiveBytes)
    return LimitError(Reason::kMeshTooLarge, "bytes of the archive, expanded",
                      limits::kMaxExpandedArchiveBytes, expanded);
  // Entries may overlap in the file. Then each entry has a small ratio, but their sum does not.
  return CheckRatio("the 3MF file", expanded, file_bytes);
}

const ArchiveEntry* Archive::Find(std::string_view name) const {
  const std::string key = KeyOf(name);
  const auto at = std::lower_bound(by_key_.begin(), by_key_.end(), std::pair(key, size_t{0}));
  return at != by_key_.end() && at->first == key ? &entries_[at->second] : nullptr;
}

absl::StatusOr<EntryStream> Archive::Stream(const ArchiveEntry& entry) const {
  zip_file_t* file = zip_fopen_index(zip_.get(), entry.index, 0);
  if (file == nullptr) return ZipError(entry.name, zip_error_code_zip(zip_get_error(zip_.get())));
  return EntryStream(file, entry.name, entry.bytes);
}

absl::StatusOr<std::string> Archive::ReadAll(const ArchiveEntry& entry) const {
  if (entry.bytes > limits::kMaxMetadataBytes)
    return LimitError(Reason::kMeshTooLarge, fmt::format("bytes of {}", Printable(entry.name)),
                      limits::kMaxMetadataBytes, entry.bytes);
  absl::StatusOr<EntryStream> stream = Stream(entry);
  if (!stream.ok()) return stream.status();
  std::string text(static_cast<size_t>(entry.bytes) + 1, '\0');  // one more byte to detect the end
  size_t size = 0;
  for (;;) {
    const absl::StatusOr<size_t> got = stream->Read(std::span(text).subspan(size));
    if (!got.ok()) return got.status();
    if (*got == 0) break;
    size += *got;
  }
  text.resize(size);
  return text;
}

}  // namespace slicefarm::slicing::threemf
