#pragma once

#include <cstdint>

#include "slicefarm/v1/jobs.grpc.pb.h"
#include "tests/load/generator/client/calls.h"
#include "tests/load/generator/client/part_supply.h"

namespace slicefarm::load {

/// Makes one UploadMesh call with the part's bytes from `offset` on. Errors: errors of the server;
/// UNAVAILABLE if the server ended the call before the mesh was complete.
void StartUpload(v1::Meshes::Stub& stub, const PartPtr& part, int64_t offset,
                 const CallContext& context, Ended ended);

}  // namespace slicefarm::load
