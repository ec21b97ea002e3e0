#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <string>

#include "tests/load/generator/client/calls.h"
#include "tests/load/generator/client/part_supply.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::load {

/// The coordinator's methods over one connection, none of which waits. `then` is called once for
/// each, from one of gRPC's threads. Outlives its calls.
class FarmCalls {
 public:
  explicit FarmCalls(std::shared_ptr<grpc::Channel> channel);

  /// Sends what the server lacks of the part.
  void Upload(const PartPtr& part, const CallContext& context, Ended then);
  void CreateJob(const v1::CreateJobRequest& request, const CallContext& context,
                 Then<v1::Job> then);
  void GetJob(const std::string& id, const CallContext& context, Then<v1::Job> then);
  /// The job as it ended. A stream that ends before is UNAVAILABLE. Logs as "Event" how long the
  /// events that happened meanwhile were under way: by the clocks of both sides.
  void WatchJob(const std::string& id, const CallContext& context, Then<v1::Job> then);
  /// Fetches the G-code and checks it against its digest: DATA_LOSS.
  void Download(const v1::Job& job, const CallContext& context, Ended then);

 private:
  std::shared_ptr<grpc::Channel> channel_;
  std::unique_ptr<v1::Meshes::Stub> meshes_;
  std::unique_ptr<v1::Jobs::Stub> jobs_;
};

}  // namespace slicefarm::load
