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

/// Best size of the pieces in which blobs are written and read. Pieces begin at multiples of this
/// size. A piece is one row of a database and one message of an answer.
inline constexpr int64_t kBlobPieceBytes = 1 << 20;

/// Size of a blob or an upload in a store.
struct BlobStatus {
  int64_t committed_size = 0;  ///< number of stored bytes, from the beginning of the blob
  bool complete = false;       ///< true if all bytes are stored and their digest is the blob's name
};

/// Entry of a listing: a blob or an upload.
struct BlobEntry {
  std::string digest;
  int64_t size = 0;
  bool complete = false;
  double idle_s = 0;  ///< seconds since the last use: an Append, Put, Finish or Keep
};

/// Blob that is open for reading.
class BlobReader {
 public:
  virtual ~BlobReader() = default;
  /// Returns the size of the blob.
  virtual int64_t size() const = 0;
  /// Returns up to `limit` bytes from `offset` on; fewer only at the end. Errors: STORE_FAILED,
  /// with the code DATA_LOSS if bytes have disappeared since the blob was opened.
  absl::StatusOr<std::string> Read(int64_t offset, int64_t limit);

 private:
  /// Returns `count` bytes from `offset` on. Returns fewer if the blob has become shorter.
  /// REQUIRES: all bytes are within size().
  virtual absl::StatusOr<std::string> ReadWithin(int64_t offset, int64_t count) = 0;
};

/// Store of byte sequences, named by their SHA-256 (64 lower-case hex digits). A complete blob is
/// on disk and never changes. Thread-safe.
///
/// Errors of all functions: STORE_FAILED, DISK_FULL; CANCELLED by the thread's CancelScope in
/// stores that wait for a network; REQUEST_MALFORMED for a name that is no digest.
class BlobStore {
 public:
  virtual ~BlobStore() = default;

  /// Returns the size of a blob or an upload; zero if the store does not have it.
  virtual absl::StatusOr<BlobStatus> Status(const std::string& digest) = 0;

  /// Returns the status as Status does. Marks a complete blob as used now.
  virtual absl::StatusOr<BlobStatus> Keep(const std::string& digest) = 0;

  /// Adds bytes to an upload. Bytes that are already stored may be sent again and are skipped. The
  /// upload survives a restart. Errors: UPLOAD_OFFSET (metadata `committed_size`) if `offset` is
  /// beyond the stored bytes.
  virtual absl::StatusOr<BlobStatus> Append(const std::string& digest, int64_t offset,
                                            std::string_view bytes) = 0;

  /// Ends an upload of `size` bytes; afterwards the blob is complete. Does nothing if the blob is
  /// already complete. Errors: UPLOAD_OFFSET if bytes are missing; BLOB_DIGEST_MISMATCH if the
  /// bytes do not match the name. After BLOB_DIGEST_MISMATCH the upload is dropped.
  virtual absl::StatusOr<BlobStatus> Finish(const std::string& digest, int64_t size) = 0;

  /// Stores the text and returns its digest. Only one block at a time is in memory. Errors: also
  /// errors of reading the spooled text.
  virtual absl::StatusOr<std::string> PutText(const SpooledText& text) = 0;

  /// Stores bytes from memory and returns their digest.
  absl::StatusOr<std::string> Put(std::string bytes) {
    return PutText(SpooledText(std::move(bytes)));
  }

  /// Opens a blob for reading. Checks the content against the blob's name when this program first
  /// opens it, and again if the blob was written since. Errors: BLOB_NOT_FOUND;
  /// BLOB_DIGEST_MISMATCH (DATA_LOSS) if the bytes have changed. A changed blob is put aside: it is
  /// kept for inspection, and a new upload can use its name.
  virtual absl::StatusOr<std::unique_ptr<BlobReader>> Open(const std::string& digest) = 0;

  /// Opens a blob without checking its content. The caller must check it, as OpenToStream does.
  virtual absl::StatusOr<std::unique_ptr<BlobReader>> OpenUnchecked(const std::string& digest) = 0;

  /// Returns all bytes of a blob. Checks them and has the same errors as Open.
  virtual absl::StatusOr<std::string> Get(const std::string& digest) = 0;

  /// Removes a blob or an upload, unless it was used in the last `idle_s` seconds. Returns false if
  /// nothing was removed.
  virtual absl::StatusOr<bool> Delete(const std::string& digest, double idle_s) = 0;

  /// Returns the total size of all blobs and uploads, except damaged blobs. Cost: reads the list of
  /// blobs; a directory store reads it only for the first call.
  virtual absl::StatusOr<int64_t> KeptBytes() = 0;

  /// Removes damaged blobs that were put aside at least `aside_s` seconds ago. Returns their total
  /// size.
  virtual absl::StatusOr<int64_t> DropDamaged(double aside_s) = 0;

  /// Calls `visit` for each blob and upload, in no particular order. Blobs that are added or
  /// removed meanwhile may be missing.
  virtual absl::Status ForEach(const std::function<void(const BlobEntry&)>& visit) = 0;
};

}  // namespace slicefarm::coordinator
