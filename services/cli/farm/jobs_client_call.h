#pragma once

#include "common/rpc/client/client_call.h"
#include "services/cli/farm/jobs_client.h"

namespace slicefarm::cli {

// Definitions of the templates of JobsClient, for its own files.

template <typename Response, typename Request, typename Start>
absl::StatusOr<Response> JobsClient::Call(const Request& request, const Start& start,
                                          std::chrono::milliseconds deadline) {
  Response response;
  const absl::Status status = Persist([&] {
    return rpc::UnaryCall({deadline, options_.cancel, options_.trace}, request, &response, start);
  });
  if (!status.ok()) return status;
  return response;
}

template <typename Request, typename Start>
absl::Status JobsClient::DeleteOnce(const Request& request, const Start& start) {
  int attempts = 0;
  const absl::Status deleted = Call<google::protobuf::Empty>(request, [&](auto... a) {
                                 ++attempts;
                                 return start(a...);
                               }).status();
  // An attempt without an answer may have deleted the object, so NotFound after it is a success.
  return absl::IsNotFound(deleted) && attempts > 1 ? absl::OkStatus() : deleted;
}

}  // namespace slicefarm::cli
