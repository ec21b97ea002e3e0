#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::gcode {

/// A block of a file of binary G-code (.bgcode).
struct BinaryBlock {
  uint16_t type = 0;   ///< a BlockType
  int64_t offset = 0;  ///< of its first byte in the file
  /// Of a thumbnail its format, width and height; of others the encoding.
  std::array<uint16_t, 3> parameters = {};
  std::string data;  ///< not compressed any more
};

/// Returns true if the file begins as binary G-code does.
bool IsBinaryGcode(std::string_view file);

/// Reads a file of binary G-code that comes in pieces, checks the checksums, and holds one block at
/// a time. Cost: O(bytes).
class BinaryGcodeReader {
 public:
  using Take = std::function<absl::Status(const BinaryBlock& block)>;

  explicit BinaryGcodeReader(Take take) : take_(std::move(take)) {}

  /// Errors: InvalidArgument for bytes that are none of a version 1 file, with the block's offset;
  /// those of `take`.
  absl::Status Add(std::string_view bytes);

  /// To be called when all bytes were added. Errors: InvalidArgument for a file that ends within a
  /// block.
  absl::Status End() const;

 private:
  absl::Status TakeBlocks();
  absl::Status TakeHeader();

  const Take take_;
  std::string held_;
  int64_t held_at_ = 0;  ///< where held_ begins in the file
  bool has_header_ = false;
  bool has_checksums_ = false;
};

/// Returns the lines of a block of G-code. Comments behind commands and empty lines are gone for
/// good; the blanks between the words of moves are put back. Errors: InvalidArgument.
absl::StatusOr<std::string> TextOf(const BinaryBlock& block);

/// Returns the file as G-code text, with metadata and thumbnails as slicefarm writes them.
/// Errors: those of BinaryGcodeReader and TextOf.
absl::StatusOr<std::string> TextOfBinaryGcode(std::string_view file);

}  // namespace slicefarm::gcode
