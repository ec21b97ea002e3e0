#pragma once

namespace slicefarm::rpc {

/// Raises the limit of open files of this program to the maximum that the system allows. The soft
/// limit is often 1024, which a busy server can reach with its connections and blobs. If the limit
/// cannot be raised, it remains unchanged.
void RaiseOpenFilesLimit();

}  // namespace slicefarm::rpc
