#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/base/spooled_text.h"
#include "common/gcode/archive/gcode_archive.h"

namespace slicefarm::cli {

/// Largest size of a settings file. Large enough for a G-code file with its settings at the end.
constexpr int64_t kMaxConfigBytes = 512 << 20;

/// Reads all bytes of a regular file or a pipe. `-` is the standard input, which is read once;
/// later calls return the same bytes. Errors: REQUEST_MALFORMED with the system's message;
/// REQUEST_TOO_LARGE above `max_bytes`, for a regular file before it is read.
absl::StatusOr<std::string> ReadFile(const std::string& path, int64_t max_bytes);

/// Reads a text file. Binary G-code (.bgcode) is converted to text; an archive (.gcode.3mf) gives
/// the program of `plate`, which is kOnlyPlate, kFirstPlate or a number (gcode_archive.h). Errors:
/// as in ReadFile; REQUEST_MALFORMED for a file that cannot be read, and for a plate that it does
/// not have. A text has only plate 1.
absl::StatusOr<std::string> ReadText(const std::string& path, int64_t max_bytes,
                                     int plate = gcode::kFirstPlate);

/// Returns the error with the file's name in front of its message.
absl::Status InFile(const std::string& path, const absl::Status& status);

/// File that is written completely or not at all. The bytes are written to a temporary file in the
/// same directory, which Commit renames. Mode and owner are as for a new file. Written directly,
/// without a temporary file: `-` (the standard output) and outputs that are no regular file, such
/// as /dev/null or a pipe.
class OutputFile {
 public:
  /// Creates the temporary file. Errors: DataLoss with the system's message; REQUEST_MALFORMED for
  /// a file that this program has read (input_files.h).
  static absl::StatusOr<OutputFile> Create(const std::string& path);
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();  ///< removes the temporary file unless Commit was called

  /// Appends bytes. Errors: DataLoss with the system's message, such as "No space left on device".
  absl::Status Write(std::string_view bytes);
  /// Renames the temporary file to its final name. Errors: as in Write.
  absl::Status Commit();

 private:
  OutputFile(std::string path, std::string temporary, int descriptor)
      : path_(std::move(path)), temporary_(std::move(temporary)), descriptor_(descriptor) {}

  absl::Status Error(int error_number) const;

  std::string path_;
  std::string temporary_;  ///< path of the temporary file; empty: the output is written directly
  int descriptor_;
};

/// Removes the temporary files of all OutputFiles and prevents later commits. For a program that
/// ends at once. Safe to call from any thread.
void RemovePartialFiles();

/// Checks that an OutputFile could be created at `path`, without leaving a file. Returns the errors
/// of OutputFile::Create. Returns OK for a path that is no regular file, and for an empty path.
absl::Status CheckWritable(const std::string& path);

/// Writes a whole file: Create, Write, Commit.
absl::Status WriteFile(const std::string& path, std::string_view bytes);
absl::Status WriteFile(const std::string& path, const SpooledText& text);

}  // namespace slicefarm::cli
