// Precompiled for what speaks gRPC: programs, and what they put together.
#pragma once

#include <CLI/CLI.hpp>
#include <google/protobuf/message.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/impl/codegen/async_stream.h>
#include <grpcpp/impl/codegen/client_callback.h>
#include <grpcpp/impl/codegen/server_callback_handlers.h>
#include <grpcpp/impl/codegen/method_handler.h>
#include <nlohmann/json.hpp>

#include "cmake/pch/standard.h"
