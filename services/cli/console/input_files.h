#pragma once

#include <string>

namespace slicefarm::cli {

// Record of the files that this program has read. No output may replace one of them, even under
// another name or through a link. A file is identified by device, inode and creation time, because
// the inode of a deleted file is used again. Thread-safe.

/// Registers an open file as an input. Does nothing if it is not a regular file: an output to a
/// pipe, for example, does not replace the pipe.
void NoteInput(int descriptor);

/// Registers the file at `path`, for a file that a library opens, such as a certificate that gRPC
/// reads. Does nothing if it is missing or not a regular file.
void NoteInput(const std::string& path);

/// Returns true if `path`, after following links, is a registered file.
bool IsInput(const std::string& path);

}  // namespace slicefarm::cli
