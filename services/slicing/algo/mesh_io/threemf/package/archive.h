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

/// A file in an archive, as the archive's directory tells.
struct ArchiveEntry {
  std::string name;   ///< with `/` between folders
  int64_t bytes = 0;  ///< expanded
  uint64_t index = 0;
};

/// InvalidArgument with the part of the archive that is at fault, as text and as metadata `part`.
absl::Status PartError(std::string_view part, std::string_view reason_text, bool truncated = false);

/// The bytes of one entry, as they are expanded.
class EntryStream {
 public:
  /// Fills `into` as far as there are bytes; 0: the end, and the checksum is right. Errors:
  /// MESH_MALFORMED, MESH_TRUNCATED for data that is not what the directory says.
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

/// A ZIP archive in memory (libzip), of which nothing is believed: what is expanded is counted.
///
/// Names are looked up without regard to the case of ASCII letters, as OPC asks for. Source: PKWARE
/// APPNOTE 6.3; ECMA-376 part 2 (Open Packaging Conventions).
class Archive {
 public:
  /// Keeps a view of `bytes`. Errors: MESH_TRUNCATED without a directory at the end; MESH_MALFORMED
  /// for damaged, encrypted and duplicate entries, unknown methods, and names that lead out of the
  /// archive; MESH_TOO_LARGE beyond the limits on entries, expanded bytes and their ratio.
  static absl::StatusOr<Archive> Open(std::string_view bytes);

  const std::vector<ArchiveEntry>& entries() const { return entries_; }
  /// nullptr if there is none. A slash in front means nothing.
  const ArchiveEntry* Find(std::string_view name) const;

  absl::StatusOr<EntryStream> Stream(const ArchiveEntry& entry) const;
  /// Errors: those of the stream; MESH_TOO_LARGE beyond limits::kMaxMetadataBytes.
  absl::StatusOr<std::string> ReadAll(const ArchiveEntry& entry) const;

 private:
  struct Discarder {
    void operator()(zip* archive) const;
  };
  Archive() = default;
  absl::Status List(int64_t file_bytes);

  std::unique_ptr<zip, Discarder> zip_;
  std::vector<ArchiveEntry> entries_;
  std::vector<std::pair<std::string, size_t>> by_key_;  ///< sorted; index into entries_
};

}  // namespace slicefarm::slicing::threemf
