#include "common/rpc/server/storage_errors.h"

#include <string>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::rpc {
namespace {

/// Returns the text that a client gets instead of the error message; empty: the client gets the
/// original message.
std::string TextFor(const absl::Status& status) {
  if (absl::IsDataLoss(status)) return "";
  switch (DetailOf(status).reason) {
    case Reason::kDiskFull:
      return "the server has no space left to store the data; the log of the server names the "
             "place";
    case Reason::kStoreFailed:
      return "the server's storage failed; the log of the server has the reason";
    default:
      return "";
  }
}

class StorageErrors : public grpc::experimental::Interceptor {
 public:
  StorageErrors(const JsonLog& log, const char* method) : log_(log), method_(method) {}

  void Intercept(grpc::experimental::InterceptorBatchMethods* methods) override {
    using Hook = grpc::experimental::InterceptionHookPoints;
    if (methods->QueryInterceptionHookPoint(Hook::PRE_SEND_STATUS)) {
      const grpc::Status sent = methods->GetSendStatus();
      if (!sent.ok()) Replace(FromGrpc(sent), *methods);
    }
    methods->Proceed();
  }

 private:
  void Replace(const absl::Status& status, grpc::experimental::InterceptorBatchMethods& methods) {
    const std::string text = TextFor(status);
    if (text.empty()) return;
    const ErrorDetail detail = DetailOf(status);
    log_.Error("storage failed", {{"method", std::string(method_)},
                                  {"reason", std::string(ReasonName(detail.reason))},
                                  {"error", std::string(status.message())}});
    methods.ModifySendStatus(
        ToGrpc(MakeError(status.code(), detail.reason, text, detail.metadata)));
  }

  const JsonLog& log_;
  const char* const method_;
};

}  // namespace

grpc::experimental::Interceptor* StorageErrorsFactory::CreateServerInterceptor(
    grpc::experimental::ServerRpcInfo* info) {
  return new StorageErrors(log_, info->method());  // gRPC owns it
}

}  // namespace slicefarm::rpc
