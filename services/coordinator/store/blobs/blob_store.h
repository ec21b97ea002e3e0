#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/spooled_text.h"

namespace slicefarm::coordinator {

/// Blobs are best written and read in pieces of so many bytes that begin at multiples of it: each
/// is then one row of a database, and one answer.
inline constexpr int64_t kBlobPieceBytes = 1 << 20;

struct BlobStatus {
  int64_t committed_size = 0;  ///< bytes that are here
  bool complete = false;       ///< all are, and their digest is the blob's name
};

/// A blob or an upload in a listing.
struct BlobEntry {
  std::string digest;
  int64_t size = 0;
  bool complete = false;
  double idle_s = 0;  ///< since it was last used: written, put or finished again, kept
};

/// A blob that was opened.
class BlobReader {
 public:
  virtual ~BlobReader() = default;
  virtual int64_t size() const = 0;
  /// Up to `limit` bytes from `offset` on; fewer only at the end. Errors: STORE_FAILED; the same as
  /// DATA_LOSS if bytes are gone that were there when it was opened.
  absl::StatusOr<std::string> Read(int64_t offset, int64_t limit);

 private:
  /// `count` bytes from `offset` on, which lie within size(); fewer if the others are gone.
  virtual absl::StatusOr<std::string> ReadWithin(int64_t offset, int64_t count) = 0;
};

/// Bytes by their SHA-256 (64 lower-case hex digits). A blob that is complete is on disk and never
/// changes. Thread-safe.
///
/// Errors of all: STORE_FAILED, DISK_FULL; CANCELLED by the thread's CancelScope, of stores that
/// wait for a network; REQUEST_MALFORMED for a name that is no digest.
class BlobStore {
 public:
  virtual ~BlobStore() = default;

  /// What is there of a blob; of an unknown one, nothing.
  virtual absl::StatusOr<BlobStatus> Status(const std::string& digest) = 0;

  /// The same; a complete blob counts as used just now.
  virtual absl::StatusOr<BlobStatus> Keep(const std::string& digest) = 0;

  /// Adds bytes to an upload. What is there already may be sent again and is skipped. Survives a
  /// restart. Errors: UPLOAD_OFFSET (metadata `committed_size`) if `offset` lies beyond what is
  /// there.
  virtual absl::StatusOr<BlobStatus> Append(const std::string& digest, int64_t offset,
                                            std::string_view bytes) = 0;

  /// Ends an upload of `size` bytes: afterwards the blob is complete. Does nothing to a complete
  /// one. Errors: UPLOAD_OFFSET if fewer bytes are there; BLOB_DIGEST_MISMATCH if they are others,
  /// and the upload is dropped.
  virtual absl::StatusOr<BlobStatus> Finish(const std::string& digest, int64_t size) = 0;

  /// Keeps the text, and gives its digest. In memory is a block at a time. Errors also: the
  /// spool's.
  virtual absl::StatusOr<std::string> PutText(const SpooledText& text) = 0;

  /// The same with what is in memory.
  absl::StatusOr<std::string> Put(std::string bytes) {
    return PutText(SpooledText(std::move(bytes)));
  }

  /// The content is checked against its name: once while the process lives, and again if the blob
  /// was written since. Errors: BLOB_NOT_FOUND; BLOB_DIGEST_MISMATCH (DATA_LOSS) if the bytes have
  /// changed: the blob is put aside.
  virtual absl::StatusOr<std::unique_ptr<BlobReader>> Open(const std::string& digest) = 0;

  /// Open, but nothing is read yet: for who checks the content, as OpenToStream does.
  virtual absl::StatusOr<std::unique_ptr<BlobReader>> OpenUnchecked(const std::string& digest) = 0;

  /// Open, and all of its bytes.
  virtual absl::StatusOr<std::string> Get(const std::string& digest) = 0;

  /// Removes a blob or an upload, unless it was used in the last `idle_s` seconds. False: nothing
  /// was removed.
  virtual absl::StatusOr<bool> Delete(const std::string& digest, double idle_s) = 0;

  /// Of all blobs and uploads, damaged ones apart. Cost: reads the list of blobs, or a directory's
  /// the first time only.
  virtual absl::StatusOr<int64_t> KeptBytes() = 0;

  /// Removes damaged blobs that were put aside so long ago. Returns their bytes.
  virtual absl::StatusOr<int64_t> DropDamaged(double aside_s) = 0;

  /// Calls visit for each blob and upload, in no particular order; those that come or go meanwhile
  /// may be missing.
  virtual absl::Status ForEach(const std::function<void(const BlobEntry&)>& visit) = 0;
};

}  // namespace slicefarm::coordinator
