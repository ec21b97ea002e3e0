#include "common/rpc/observe/library_log.h"

#include <fmt/core.h>
#include <google/protobuf/stubs/logging.h>
#include <grpc/support/log.h>

#include <atomic>
#include <string>
#include <string_view>

namespace slicefarm::rpc {
namespace {

/// Never deleted, because gRPC's threads may log until the program ends.
std::atomic<const JsonLog*> library_log = nullptr;

void Write(std::string_view library, std::string_view path, const std::string& error) {
  const std::string_view file = path.substr(path.rfind('/') + 1);
  library_log.load()->Warn(fmt::format("{} {}", library, file), {{"error", error}});
}

void WriteGrpc(gpr_log_func_args* line) { Write("grpc", line->file, line->message); }

void WriteProtobuf(google::protobuf::LogLevel, const char* path, int, const std::string& message) {
  Write("protobuf", path, message);
}

}  // namespace

void LogLibrariesTo(const JsonLog& log) {
  library_log = new JsonLog(log);
  gpr_set_log_function(WriteGrpc);
  google::protobuf::SetLogHandler(WriteProtobuf);
}

}  // namespace slicefarm::rpc
