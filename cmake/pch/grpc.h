// Precompiled for what speaks gRPC: programs, and what they put together. CLI11 and nlohmann/json are better included where they
// are used: each file that has them makes 4 s of code of them, used or not, precompiled or not.
#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/impl/codegen/async_stream.h>
#include <grpcpp/impl/codegen/client_callback.h>
#include <grpcpp/impl/codegen/server_callback_handlers.h>
#include <grpcpp/impl/codegen/method_handler.h>

#include "cmake/pch/standard.h"
