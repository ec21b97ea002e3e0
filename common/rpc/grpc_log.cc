#include "common/rpc/grpc_log.h"

#include <fmt/core.h>
#include <grpc/support/log.h>

#include <atomic>
#include <string>
#include <string_view>

namespace slicefarm::rpc {
namespace {

/// Never deleted: gRPC's threads may have something to say to the last.
std::atomic<const JsonLog*> grpc_log = nullptr;

void Write(gpr_log_func_args* line) {
  const std::string_view path = line->file;
  const std::string_view file = path.substr(path.rfind('/') + 1);
  grpc_log.load()->Warn(fmt::format("grpc {}", file), {{"error", std::string(line->message)}});
}

}  // namespace

void LogGrpcTo(const JsonLog& log) {
  grpc_log = new JsonLog(log);
  gpr_set_log_function(Write);
}

}  // namespace slicefarm::rpc
