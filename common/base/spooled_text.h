#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/spool_file.h"

namespace slicefarm {

/// Text that may be larger than the memory: a sequence of pieces, some of them in a spool file.
class SpooledText {
 public:
  /// Function that receives the next bytes of the text. If the function returns an error,
  /// ForEachBlock stops and returns this error.
  using Visit = std::function<absl::Status(std::string_view bytes)>;

  /// Size of the blocks that ForEachBlock passes to `visit`.
  static constexpr int64_t kBlockBytes = 1 << 20;

  SpooledText() = default;
  explicit SpooledText(std::string text) { Add(std::move(text)); }
  /// Makes an empty text. Its pieces may be in memory or in this spool file.
  explicit SpooledText(std::unique_ptr<const SpoolFile> spool) : spool_(std::move(spool)) {}

  void Add(std::string text);
  /// Appends a piece that is in the spool file. REQUIRES: the text has a spool file.
  void Add(SpoolFile::Chunk chunk);

  int64_t size() const { return size_; }

  /// Calls `visit` with consecutive blocks of kBlockBytes, from the text's start to its end; the
  /// last block may be shorter. Errors: the first error of `visit`; STORE_FAILED.
  absl::Status ForEachBlock(const Visit& visit) const;

  /// Returns `limit` bytes from `offset` on, or fewer if the text ends earlier. Errors:
  /// STORE_FAILED. REQUIRES: offset >= 0, limit >= 0. Cost: O(number of pieces before the end of
  /// the read + limit).
  absl::StatusOr<std::string> Read(int64_t offset, int64_t limit) const;

  /// Returns the whole text. Only for texts that fit into memory. Errors: STORE_FAILED.
  absl::StatusOr<std::string> Whole() const;

 private:
  using Piece = std::variant<std::string, SpoolFile::Chunk>;

  absl::Status Append(const Piece& piece, int64_t offset, int64_t count, std::string& text) const;

  std::unique_ptr<const SpoolFile> spool_;
  std::vector<Piece> pieces_;
  int64_t size_ = 0;
};

}  // namespace slicefarm
