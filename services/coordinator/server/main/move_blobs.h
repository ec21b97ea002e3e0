#pragma once

namespace slicefarm::coordinator {

/// main() of `slicefarm-coordinator move-blobs`: moves the blobs of a PostgreSQL database or of a
/// state directory into a bucket, and prints how many. May be ended and run again. Beside
/// coordinators of a database that are told of the bucket already. Returns the exit code.
int MoveBlobs(int argc, char** argv);

}  // namespace slicefarm::coordinator
