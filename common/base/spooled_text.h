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

/// A text that need not fit into memory: pieces in their order, some of them in a spool.
class SpooledText {
 public:
  /// What is done with the text's next bytes; an error ends the way through it.
  using Visit = std::function<absl::Status(std::string_view bytes)>;

  /// What is gone through at a time.
  static constexpr int64_t kBlockBytes = 1 << 20;

  SpooledText() = default;
  explicit SpooledText(std::string text) { Add(std::move(text)); }
  /// Of texts in this spool.
  explicit SpooledText(std::unique_ptr<const SpoolFile> spool) : spool_(std::move(spool)) {}

  void Add(std::string text);
  /// REQUIRES: the spool is there.
  void Add(SpoolFile::Place place);

  int64_t size() const { return size_; }

  /// From the beginning to the end, in blocks of kBlockBytes; the last one may be shorter. May be
  /// called again, with the same bytes. Errors: those of `visit`; STORE_FAILED.
  absl::Status ForEachBlock(const Visit& visit) const;

  /// Up to `limit` bytes from `offset` on; fewer only at the end. Cost: looks at all pieces before
  /// them. Errors: STORE_FAILED. REQUIRES: 0 <= offset, limit.
  absl::StatusOr<std::string> Read(int64_t offset, int64_t limit) const;

  /// All of it, for texts that fit into memory. Errors: STORE_FAILED.
  absl::StatusOr<std::string> Whole() const;

 private:
  using Piece = std::variant<std::string, SpoolFile::Place>;

  absl::Status Append(const Piece& piece, int64_t offset, int64_t count, std::string& text) const;

  std::unique_ptr<const SpoolFile> spool_;
  std::vector<Piece> pieces_;
  int64_t size_ = 0;
};

}  // namespace slicefarm
