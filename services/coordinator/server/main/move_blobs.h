#pragma once

namespace slicefarm::coordinator {

/// main() of `slicefarm-coordinator move-blobs`: moves the blobs of a PostgreSQL database or of a
/// state directory into a bucket, and prints their number. May be interrupted and run again.
/// Coordinators of the database may run meanwhile if they already use the bucket. Returns the exit
/// code.
int MoveBlobs(int argc, char** argv);

}  // namespace slicefarm::coordinator
