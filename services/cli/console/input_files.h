#pragma once

#include <string>

namespace slicefarm::cli {

/// Files that this process has read. No output may replace one of them, under any name or link.
/// Files are identified by device, inode and time of birth, because the inode of a deleted file is
/// reused. Thread-safe.

/// Registers an open file. Only regular files count, because writing to a pipe does not replace it.
void NoteInput(int descriptor);

/// Registers a file that other code reads. A missing file is ignored.
void NoteInput(const std::string& path);

/// Returns true if `path`, after following links, is a registered file.
bool IsInput(const std::string& path);

}  // namespace slicefarm::cli
