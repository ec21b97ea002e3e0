#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

struct zip;
struct zip_file;

namespace slicefarm::slicing::threemf {

/// File in an archive, as listed in the directory of the archive.
struct ArchiveEntry {
  std::string name;   ///< name, with `/` between folders
  int64_t bytes = 0;  ///< expanded size
  uint64_t index = 0;
};

/// Returns InvalidArgument with `part`, the name of the faulty file in the archive, in the text and
/// in the metadata. `truncated`: MESH_TRUNCATED instead of MESH_MALFORMED.
absl::Status PartError(std::string_view part, std::string_view reason_text, bool truncated = false);

/// Stream of the expanded bytes of one entry.
class EntryStream {
 public:
  /// Fills `into` as far as bytes are available, and returns their number. At the end of the entry
  /// it checks the checksum and returns 0. Errors: MESH_MALFORMED and MESH_TRUNCATED if the data do
  /// not match the directory.
  absl::StatusOr<size_t> Read(std::span<char> into);

 private:
  friend class Archive;
  struct Closer {
    void operator()(zip_file* file) const;
  };
  EntryStream(zip_file* file, std::string part, int64_t bytes)
      : file_(file), part_(std::move(part)), left_(bytes) {}

  std::unique_ptr<zip_file, Closer> file_;
  std::string part_;
  int64_t left_;
};

/// ZIP archive in memory, read with libzip. It does not trust the sizes in the archive's directory,
/// but counts the decompressed bytes.
///
/// Names are looked up regardless of the case of ASCII letters, as OPC requires. Source: PKWARE
/// APPNOTE 6.3; ECMA-376 part 2 (Open Packaging Conventions).
class Archive {
 public:
  /// Opens an archive and keeps a view of `bytes`. Errors: MESH_TRUNCATED without a directory at
  /// the end; MESH_MALFORMED for damaged, encrypted and duplicate entries, unknown methods, and
  /// names that lead out of the archive; MESH_TOO_LARGE beyond the limits (limits.h) on the number
  /// of entries, the expanded bytes and the compression ratio.
  static absl::StatusOr<Archive> Open(std::string_view bytes);

  /// Returns the entries in the order of the directory.
  const std::vector<ArchiveEntry>& entries() const { return entries_; }
  /// Returns the entry of this name, or nullptr. A leading slash is ignored.
  const ArchiveEntry* Find(std::string_view name) const;

  /// Opens the stream of an entry.
  absl::StatusOr<EntryStream> Stream(const ArchiveEntry& entry) const;
  /// Returns all bytes of an entry. Errors: as EntryStream::Read; MESH_TOO_LARGE beyond
  /// limits::kMaxMetadataBytes.
  absl::StatusOr<std::string> ReadAll(const ArchiveEntry& entry) const;

 private:
  struct Discarder {
    void operator()(zip* archive) const;
  };
  Archive() = default;
  absl::Status List(int64_t file_bytes);

  std::unique_ptr<zip, Discarder> zip_;
  std::vector<ArchiveEntry> entries_;
  /// Lower-case names with indices into `entries_`, sorted.
  std::vector<std::pair<std::string, size_t>> by_key_;
};

}  // namespace slicefarm::slicing::threemf
