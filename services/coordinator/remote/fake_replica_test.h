#pragma once

#include <grpcpp/grpcpp.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "common/base/build_info.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/observe/metrics.h"
#include "common/rpc/server/server.h"
#include "services/coordinator/remote/address_watch.h"
#include "slicefarm/v1/worker.grpc.pb.h"

namespace slicefarm::coordinator {

/// For tests: a worker's server that can be killed and started again on its port.
class FakeReplica final : public v1::Worker::Service {
 public:
  FakeReplica() { Start("127.0.0.1:0"); }

  const std::string& address() const { return address_; }
  int calls() const { return calls_; }

  void OnCall(std::function<grpc::Status()> answer) { answer_ = std::move(answer); }
  void SetInfo(std::string build_id, int slots) {
    build_id_ = std::move(build_id);
    slots_ = slots;
  }

  /// REQUIRES: it is not there.
  void SetProcesses(std::vector<v1::Process> processes) { processes_ = std::move(processes); }

  /// What ranges come to. REQUIRES: no call is in flight.
  void OnWork(std::function<grpc::Status()> answer) { work_ = std::move(answer); }

  rpc::Server& server() { return *server_; }
  void Kill() { server_.reset(); }
  void Restart() { Start(address_); }

  grpc::Status GetWorkerInfo(grpc::ServerContext* /*context*/,
                             const v1::GetWorkerInfoRequest* /*request*/,
                             v1::WorkerInfo* info) override {
    ++calls_;
    info->set_build_id(build_id_);
    info->set_slots(slots_);
    for (const v1::Process process : processes_) info->add_processes(process);
    return answer_();
  }

  grpc::Status WorkRange(
      grpc::ServerContext* /*context*/,
      grpc::ServerReaderWriter<v1::WorkResponse, v1::WorkRequest>* /*stream*/) override {
    return work_();
  }

 private:
  void Start(const std::string& listen) {
    rpc::ServerOptions options;
    options.listen = listen;
    // While it was down, a connection of somebody else may have come by its port, for a moment.
    absl::StatusOr<std::unique_ptr<rpc::Server>> server;
    do {
      server = rpc::Server::Start(options, {this}, call_metrics_);
    } while (!server.ok());
    server_ = *std::move(server);
    address_ = "127.0.0.1:" + std::to_string(server_->port());
  }

  std::function<grpc::Status()> answer_ = [] { return grpc::Status::OK; };
  std::function<grpc::Status()> work_ = [] {
    return grpc::Status(grpc::StatusCode::UNIMPLEMENTED, "a fake");
  };
  std::string build_id_ = std::string(BuildId());
  int slots_ = 2;
  std::vector<v1::Process> processes_ = {v1::PROCESS_FDM};
  std::atomic<int> calls_ = 0;
  rpc::Metrics metrics_;
  rpc::CallMetrics call_metrics_{metrics_.registry()};
  std::string address_;
  std::unique_ptr<rpc::Server> server_;
};

/// For tests: a name whose addresses the test sets. Thread-safe.
class FakeName {
 public:
  void Set(std::vector<std::string> addresses) {
    const std::lock_guard lock(mutex_);
    addresses_ = std::move(addresses);
  }
  AddressWatchOptions Options() {
    AddressWatchOptions options;
    options.every = std::chrono::milliseconds(20);
    options.least_pause = std::chrono::milliseconds(1);
    options.resolve = [this](const std::string&) -> absl::StatusOr<std::vector<std::string>> {
      const std::lock_guard lock(mutex_);
      return addresses_;
    };
    return options;
  }

 private:
  std::mutex mutex_;
  std::vector<std::string> addresses_;
};

}  // namespace slicefarm::coordinator
