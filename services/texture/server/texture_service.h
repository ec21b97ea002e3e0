#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/base/shared/shared_cache.h"
#include "common/rpc/server/call_limiter.h"
#include "common/stage/stages.h"
#include "common/stage/texture_stage.h"

namespace slicefarm::texture {

/// Returns the gRPC service slicefarm.v1.Texture, which calls a TextureStage. `stage`, `gate` and
/// `shared` must outlive the service.
std::unique_ptr<grpc::Service> MakeTextureService(const TextureStage& stage, rpc::CallLimiter& gate,
                                                  SharedCache& shared);

}  // namespace slicefarm::texture
