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
  int64_t offset = 0;  ///< offset of the block's first byte in the file
  /// For a thumbnail: format, width and height. For any other block: the first number is the
  /// encoding.
  std::array<uint16_t, 3> parameters = {};
  std::string data;  ///< data after decompression
};

/// Returns true if the file begins like binary G-code.
bool IsBinaryGcode(std::string_view file);

/// Reads a file of binary G-code in pieces and verifies the checksums. Only one block is in memory
/// at a time. Cost: O(bytes).
class BinaryGcodeReader {
 public:
  using Take = std::function<absl::Status(const BinaryBlock& block)>;

  /// Makes a reader that passes each block to `take`.
  explicit BinaryGcodeReader(Take take) : take_(std::move(take)) {}

  /// Adds bytes. Errors: InvalidArgument for bytes that do not belong to a version 1 file, with the
  /// block's offset; any error of `take`.
  absl::Status Add(std::string_view bytes);

  /// Checks that the file is complete; call it after all bytes were added. Errors: InvalidArgument
  /// for a file that ends within a block.
  absl::Status End() const;

 private:
  absl::Status TakeBlocks();
  absl::Status TakeHeader();

  const Take take_;
  std::string held_;
  int64_t held_at_ = 0;  ///< offset of held_ in the file
  bool has_header_ = false;
  bool has_checksums_ = false;
};

/// Returns the lines of a block of G-code (kGcode). Blanks between the words of moves are restored.
/// Comments after commands and empty lines cannot be restored. Errors: InvalidArgument for a
/// malformed block.
absl::StatusOr<std::string> TextOf(const BinaryBlock& block);

/// Returns the file as G-code text, with metadata and thumbnails as slicefarm writes them. Errors:
/// any error of BinaryGcodeReader and TextOf.
absl::StatusOr<std::string> TextOfBinaryGcode(std::string_view file);

}  // namespace slicefarm::gcode
