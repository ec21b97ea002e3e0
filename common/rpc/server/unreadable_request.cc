#include "common/rpc/server/unreadable_request.h"

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::rpc {
namespace {

class UnreadableRequestInterceptor : public grpc::experimental::Interceptor {
 public:
  void Intercept(grpc::experimental::InterceptorBatchMethods* methods) override {
    using Hook = grpc::experimental::InterceptionHookPoints;
    if (methods->QueryInterceptionHookPoint(Hook::PRE_SEND_STATUS)) {
      const grpc::Status status = methods->GetSendStatus();
      if (status.error_code() == grpc::StatusCode::INTERNAL && status.error_details().empty()) {
        methods->ModifySendStatus(ToGrpc(MakeError(
            absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
            "the request is not a valid message of this method, or has a text that is not UTF-8")));
      }
    }
    methods->Proceed();
  }
};

}  // namespace

grpc::experimental::Interceptor* UnreadableRequestFactory::CreateServerInterceptor(
    grpc::experimental::ServerRpcInfo* /*info*/) {
  return new UnreadableRequestInterceptor;  // gRPC owns it
}

}  // namespace slicefarm::rpc
