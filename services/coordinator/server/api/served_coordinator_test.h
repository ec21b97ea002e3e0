#pragma once

#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>

#include "absl/strings/str_cat.h"
#include "common/base/temp_directory_test.h"
#include "common/rpc/server/server.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/algo/dispatch/fleet.h"
#include "services/coordinator/server/execution/fake_stages_test.h"
#include "services/coordinator/server/main/coordinator.h"

namespace slicefarm::coordinator {

/// Fixture with a coordinator that has a real server, real stores and fake stages. The test can
/// close it and serve it again with the same state.
class ServedCoordinatorTest : public testing::Test {
 protected:
  ServedCoordinatorTest() { fleet_.Join({.name = "fake", .tasks = ranges_, .slots = 2}); }

  /// Closes the coordinator while the members of a derived test still exist.
  void TearDown() override {
    ranges_->LetGo();
    Close();
  }

  /// Returns options that a test may change before it serves.
  CoordinatorOptions Options() {
    CoordinatorOptions options;
    options.stores.state_dir = directory_.path();
    options.build_id = "test-build";
    options.runner.owner = "coordinator";
    options.runner.jobs = 2;
    options.runner.poll = std::chrono::milliseconds(20);
    options.metrics = &registry_;
    return options;
  }

  void Serve(const CoordinatorOptions& options) {
    auto coordinator = Coordinator::Open(
        options,
        {{.slicing = &slicing_, .planning = &planning_, .motion = &motion_}, arranging_, projects_},
        dispatcher_, rpc::JsonLog("test"));
    ASSERT_TRUE(coordinator.ok()) << coordinator.status();
    coordinator_ = *std::move(coordinator);
    auto server = rpc::Server::Start(server_options_, coordinator_->services(), metrics_,
                                     &coordinator_->queued_methods());
    ASSERT_TRUE(server.ok()) << server.status();
    server_ = *std::move(server);
    ASSERT_TRUE(coordinator_->Start().ok());
  }

  /// Stops the coordinator as SIGTERM does.
  void Close() {
    if (!coordinator_) return;
    coordinator_->Stop();
    server_->Drain(std::chrono::seconds(10));
    server_.reset();
    coordinator_.reset();
  }

  /// Returns the path of a blob of the tenant "".
  std::string BlobPath(const std::string& digest) const {
    return directory_.path() + "/blobs/" + digest.substr(0, 2) + "/" + digest;
  }

  std::string address() const { return absl::StrCat("127.0.0.1:", server_->port()); }

  TempDirectory directory_;
  FakeSlicing slicing_;
  FakeArranging arranging_;
  FakeProjects projects_;
  FakePlanning planning_;
  FakeMotion motion_;
  std::shared_ptr<FakeRanges> ranges_ = std::make_shared<FakeRanges>();
  Dispatcher dispatcher_;
  Fleet fleet_{dispatcher_};
  prometheus::Registry registry_;
  rpc::CallMetrics metrics_{registry_};
  rpc::ServerOptions server_options_;
  std::unique_ptr<Coordinator> coordinator_;
  std::unique_ptr<rpc::Server> server_;
};

}  // namespace slicefarm::coordinator
