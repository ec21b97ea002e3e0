#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/base/error.h"

namespace slicefarm::slicing {

/// The words of a line, taken off its front one by one. Blanks are space, tab, CR, LF, VT, FF and
/// the backslash of a continued line.
class Words {
 public:
  explicit Words(std::string_view rest) : rest_(rest) {}

  /// The next word; empty at the end of the line.
  std::string_view Next();

 private:
  std::string_view rest_;
};

/// A number as C writes it, whatever the locale; nothing if `word` is not one as a whole. Too big:
/// infinity; too small: zero.
std::optional<double> ParseNumber(std::string_view word);

/// Goes through a text line by line. Each line ends in LF, CR LF or CR, whatever the others do.
class LineReader {
 public:
  /// `max_line_bytes`: longer lines are refused. `joins`: a line that ends in a backslash goes on
  /// in the next.
  LineReader(std::string_view text, int64_t max_line_bytes, bool joins);

  /// The next line; nothing at the end of the text.
  /// Errors: MESH_MALFORMED with `limit`, `got`, `line` for a line that is too long.
  absl::StatusOr<std::optional<std::string_view>> Next();

  /// Number of the line that Next gave, from 1.
  int64_t number() const { return number_; }

  /// An InvalidArgument that ends in "(line N)" and has `line` in its metadata.
  absl::Status Error(Reason reason, std::string_view what) const;

 private:
  /// End of the line that starts at `begin`, its terminator excluded.
  size_t LineEnd(size_t begin);
  /// Where the line after the one with that end begins.
  size_t After(size_t end) const;

  std::string_view text_;
  size_t max_line_bytes_;
  bool joins_;
  size_t at_ = 0;
  size_t next_lf_ = 0, next_cr_ = 0;  ///< the first at or after the line's begin, once looked for
  int64_t number_ = 0;
  int64_t next_number_ = 1;
};

}  // namespace slicefarm::slicing
