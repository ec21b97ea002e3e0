#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/base/error.h"

namespace slicefarm::slicing {

/// Words of a line, removed from its front one by one. Separators are space, tab, CR, LF, VT, FF
/// and the backslash of a continued line.
class Words {
 public:
  explicit Words(std::string_view rest) : rest_(rest) {}

  /// Returns the next word, or an empty view at the end of the line.
  std::string_view Next();

 private:
  std::string_view rest_;
};

/// Parses a number in C notation, independent of the locale. Returns nothing if `word` as a whole
/// is not a number. A number too large for double gives infinity, one too small gives zero.
std::optional<double> ParseNumber(std::string_view word);

/// Reader of a text line by line. Each line may end in LF, CR LF or CR, also within one file.
class LineReader {
 public:
  /// `max_line_bytes`: longer lines are refused. `joins`: a line that ends in a backslash continues
  /// in the next line.
  LineReader(std::string_view text, int64_t max_line_bytes, bool joins);

  /// Returns the next line, or nothing at the end of the text. Errors: MESH_MALFORMED with `limit`,
  /// `got` and `line` if a line is too long.
  absl::StatusOr<std::optional<std::string_view>> Next();

  /// Returns the number of the line that Next returned last, from 1.
  int64_t number() const { return number_; }

  /// Returns an InvalidArgument error that ends in "(line N)" and has `line` in its metadata.
  absl::Status Error(Reason reason, std::string_view what) const;

 private:
  /// Returns the end of the line that starts at `begin`, without the line terminator.
  size_t LineEnd(size_t begin);
  /// Returns the start of the next line after a line that ends at `end`.
  size_t After(size_t end) const;

  std::string_view text_;
  size_t max_line_bytes_;
  bool joins_;
  size_t at_ = 0;
  /// Positions of the first LF and of the first CR at or after the line's start; searched only when
  /// they are needed.
  size_t next_lf_ = 0, next_cr_ = 0;
  int64_t number_ = 0;
  int64_t next_number_ = 1;
};

}  // namespace slicefarm::slicing
