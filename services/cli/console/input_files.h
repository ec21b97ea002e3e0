#pragma once

#include <string>

namespace slicefarm::cli {

/// The files that this process has read, so that no output takes the place of one, whatever name or
/// link it goes by. Told apart by device, inode and time of birth: the inode of a file that was
/// deleted goes to another one. Thread-safe.

/// Notes an open file. Only regular files count: a pipe is not replaced by what is written to it.
void NoteInput(int descriptor);

/// Notes a file that somebody else reads. A file that is not there is none.
void NoteInput(const std::string& path);

/// Returns true if `path`, through links, leads to a file that was noted.
bool IsInput(const std::string& path);

}  // namespace slicefarm::cli
