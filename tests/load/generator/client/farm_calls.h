#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <string>

#include "slicefarm/v1/jobs.grpc.pb.h"
#include "tests/load/generator/client/calls.h"
#include "tests/load/generator/client/part_supply.h"

namespace slicefarm::load {

/// Methods of the coordinator over one connection. They never block. Each method calls `then` once,
/// from one of gRPC's threads. This object must outlive its calls.
class FarmCalls {
 public:
  explicit FarmCalls(std::shared_ptr<grpc::Channel> channel);

  /// Sends the bytes of the part that the server does not have.
  void Upload(const PartPtr& part, const CallContext& context, Ended then);
  /// Creates a job.
  void CreateJob(const v1::CreateJobRequest& request, const CallContext& context,
                 Then<v1::Job> then);
  /// Gets a job.
  void GetJob(const std::string& id, const CallContext& context, Then<v1::Job> then);
  /// Watches a job and returns it after its end. A stream that ends earlier is UNAVAILABLE. Logs
  /// the delay of new events as "Event", by the clocks of both sides.
  void WatchJob(const std::string& id, const CallContext& context, Then<v1::Job> then);
  /// Downloads the G-code and checks it against its digest. Errors: DATA_LOSS if they differ.
  void Download(const v1::Job& job, const CallContext& context, Ended then);

 private:
  std::shared_ptr<grpc::Channel> channel_;
  std::unique_ptr<v1::Meshes::Stub> meshes_;
  std::unique_ptr<v1::Jobs::Stub> jobs_;
};

}  // namespace slicefarm::load
