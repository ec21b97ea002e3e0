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

/// Fake worker server for tests. It can be killed and restarted on its port.
class FakeReplica final : public v1::Worker::Service {
 public:
  FakeReplica() { Start("127.0.0.1:0"); }

  /// Returns the address of the server.
  const std::string& address() const { return address_; }
  /// Returns the number of GetWorkerInfo calls so far.
  int calls() const { return calls_; }

  /// Sets the function that returns the status of GetWorkerInfo.
  void OnCall(std::function<grpc::Status()> answer) { answer_ = std::move(answer); }
  /// Sets the build id and the number of slots that the server reports.
  void SetInfo(std::string build_id, int slots) {
    build_id_ = std::move(build_id);
    slots_ = slots;
  }

  /// Sets the processes that the server reports. REQUIRES: the server is not running.
  void SetProcesses(std::vector<v1::Process> processes) { processes_ = std::move(processes); }

  /// Sets the function that returns the status of WorkRange. REQUIRES: no call is in flight.
  void OnWork(std::function<grpc::Status()> answer) { work_ = std::move(answer); }

  /// Returns the running server.
  rpc::Server& server() { return *server_; }
  /// Stops the server.
  void Kill() { server_.reset(); }
  /// Starts the server again at the same address.
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
    // While the server is down, another connection can occupy its port for a moment.
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

/// Fake name service for tests; the test sets the addresses. Thread-safe.
class FakeName {
 public:
  void Set(std::vector<std::string> addresses) {
    const std::lock_guard lock(mutex_);
    addresses_ = std::move(addresses);
  }
  /// Returns options of a watch that resolves every name to the addresses of this object.
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
