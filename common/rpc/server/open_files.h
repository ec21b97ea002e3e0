#pragma once

namespace slicefarm::rpc {

/// Lets this process open as many files as the system allows: the soft limit is often 1024, which
/// connections and blobs of a busy server reach. Where it cannot be raised it stays as it was.
void RaiseOpenFilesLimit();

}  // namespace slicefarm::rpc
