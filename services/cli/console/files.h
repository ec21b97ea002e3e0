#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/base/spooled_text.h"

namespace slicefarm::cli {

constexpr int64_t kMaxConfigBytes = 512 << 20;  ///< a G-code file that quotes its settings is big

/// All bytes of a regular file or a pipe; `-` is the standard input, which is read once and gives
/// the same bytes each time. Errors: REQUEST_MALFORMED with the system's words;
/// REQUEST_TOO_LARGE past `max_bytes`, before they are read if the file tells its size.
absl::StatusOr<std::string> ReadFile(const std::string& path, int64_t max_bytes);

/// The same of a file of text; of binary G-code (.bgcode), what it is as text. Errors also:
/// REQUEST_MALFORMED for binary G-code that cannot be read.
absl::StatusOr<std::string> ReadText(const std::string& path, int64_t max_bytes);

/// The error with the file's name in front of its message.
absl::Status InFile(const std::string& path, const absl::Status& status);

/// A file that is there as a whole or not at all: its bytes go to a file beside it, which takes its
/// name in the end. Mode and owner are those of a new file. `-` is the standard output, written as
/// it comes. An output that is no regular file
/// (/dev/null, a pipe) is written in place.
class OutputFile {
 public:
  /// Errors: DataLoss with the system's words; REQUEST_MALFORMED for a file that this process has
  /// read (input_files.h).
  static absl::StatusOr<OutputFile> Create(const std::string& path);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();  ///< without Commit, nothing is left

  /// Errors: DataLoss with the system's words, such as "No space left on device".
  absl::Status Write(std::string_view bytes);
  absl::Status Commit();

 private:
  OutputFile(std::string path, std::string temporary, int descriptor)
      : path_(std::move(path)), temporary_(std::move(temporary)), descriptor_(descriptor) {}

  absl::Status Error(int error_number) const;

  std::string path_;
  std::string temporary_;  ///< empty: written in place
  int descriptor_;
};

/// Removes the files of OutputFiles that have not been committed, and lets none be committed any
/// more: for a process that ends at once. Safe to call from any thread.
void RemovePartialFiles();

/// Whether an OutputFile could be made there, with the errors of Create; leaves nothing behind.
/// True of what is no regular file. Empty: there is none to be made.
absl::Status CheckWritable(const std::string& path);

/// Create, Write, Commit.
absl::Status WriteFile(const std::string& path, std::string_view bytes);
absl::Status WriteFile(const std::string& path, const SpooledText& text);

}  // namespace slicefarm::cli
