// Precompiled headers for code with gRPC: programs, and the libraries of their parts. CLI11 and
// nlohmann/json are not included here. Each file that includes them takes 4 s longer to compile,
// used or not, precompiled or not.
#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/impl/codegen/async_stream.h>
#include <grpcpp/impl/codegen/client_callback.h>
#include <grpcpp/impl/codegen/server_callback_handlers.h>
#include <grpcpp/impl/codegen/method_handler.h>

#include "cmake/pch/standard.h"
