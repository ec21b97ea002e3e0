#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <deque>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "common/rpc/client/channel.h"
#include "common/wire/slicing_wire.h"
#include "processes/fdm/task/layer_chain.h"
#include "services/coordinator/remote/remote_planning.h"
#include "services/coordinator/remote/remote_slicing.h"
#include "services/coordinator/remote/remote_stages.h"
#include "services/coordinator/remote/stage_pool.h"
#include "services/coordinator/remote/worker_pool.h"
#include "slicefarm/v1/slicing.grpc.pb.h"
#include "tests/integration/child_process.h"
#include "tests/integration/http_get.h"
#include "tests/integration/stage_host.h"
#include "tests/integration/whole_job.h"

namespace slicefarm::processes_test {
namespace {

using coordinator::Dispatcher;
using coordinator::StagePool;
using coordinator::WorkerPool;

/// Several processes of one program.
struct Replicas {
  Replicas(const std::string& program, int count, std::vector<std::string> arguments = {}) {
    for (int i = 0; i < count; ++i) servers.emplace_back(program, arguments);
    for (const ServerProcess& server : servers) addresses.push_back(server.address);
  }

  std::deque<ServerProcess> servers;
  std::vector<std::string> addresses;
};

/// Runs slicing, planning and motion, which all kinds of jobs need, each as a process.
class ProcessesTest : public testing::Test {
 protected:
  Replicas slicing_processes_{"slicefarm-slicing", 1};
  Replicas planning_processes_{"slicefarm-planning", 1};
  Replicas motion_processes_{"slicefarm-motion", 2};
  StagePool slicing_pool_{"slicing", slicing_processes_.addresses, NoLog()};
  StagePool planning_pool_{"planning", planning_processes_.addresses, NoLog()};
  StagePool motion_pool_{"motion", motion_processes_.addresses, NoLog()};
  const coordinator::RemoteSlicing slicing_{slicing_pool_};
  const coordinator::RemotePlanning planning_{planning_pool_};
  const coordinator::RemoteMotion motion_{motion_pool_};
  Dispatcher dispatcher_;
};

TEST_F(ProcessesTest, FusedWorkersGiveTheSameBytes) {
  const Replicas workers("slicefarm-worker", 2, {"--slots", "1"});
  const WorkerPool pool(dispatcher_, workers.addresses, NoLog());
  const auto gcode = GcodeOf(slicing_, planning_, motion_, dispatcher_);
  ASSERT_TRUE(gcode.ok()) << gcode.status();
  EXPECT_TRUE(*gcode == GcodeOfThisProcess());
}

TEST_F(ProcessesTest, SplitStagesGiveTheSameBytes) {
  const Replicas beading_processes("slicefarm-beading", 2);
  const Replicas infill_processes("slicefarm-infill", 1);
  const Replicas ordering_processes("slicefarm-ordering", 2);
  StagePool beading_pool("beading", beading_processes.addresses, NoLog());
  StagePool infill_pool("infill", infill_processes.addresses, NoLog());
  StagePool ordering_pool("ordering", ordering_processes.addresses, NoLog());
  const coordinator::RemoteBeading beading(beading_pool);
  const coordinator::RemoteInfill infill(infill_pool);
  const coordinator::RemoteOrdering ordering(ordering_pool);
  dispatcher_.Join({.name = "split",
                    .tasks = std::make_shared<LayerChain>(beading, infill, ordering, motion_),
                    .slots = 4});
  const auto gcode = GcodeOf(slicing_, planning_, motion_, dispatcher_);
  ASSERT_TRUE(gcode.ok()) << gcode.status();
  EXPECT_TRUE(*gcode == GcodeOfThisProcess());
}

TEST_F(ProcessesTest, AKilledWorkerChangesNothing) {
  Replicas workers("slicefarm-worker", 2, {"--slots", "1"});
  const WorkerPool pool(dispatcher_, workers.addresses, NoLog());
  bool killed = false;
  const auto gcode = GcodeOf(slicing_, planning_, motion_, dispatcher_, [&](int32_t layers_done) {
    if (layers_done == 0 || killed) return;
    killed = true;
    workers.servers[0].process.Signal(SIGKILL);
  });
  ASSERT_TRUE(gcode.ok()) << gcode.status();
  EXPECT_TRUE(killed);
  EXPECT_TRUE(*gcode == GcodeOfThisProcess());
}

TEST_F(ProcessesTest, AWorkerThatJoinsLateWorksAlong) {
  const Replicas first("slicefarm-worker", 1, {"--slots", "1"});
  const WorkerPool first_pool(dispatcher_, first.addresses, NoLog());
  const Replicas second("slicefarm-worker", 1, {"--slots", "1"});
  std::unique_ptr<WorkerPool> second_pool;
  const auto gcode = GcodeOf(slicing_, planning_, motion_, dispatcher_, [&](int32_t layers_done) {
    if (layers_done > 0 && second_pool == nullptr) {
      second_pool = std::make_unique<WorkerPool>(dispatcher_, second.addresses, NoLog());
    }
  });
  ASSERT_TRUE(gcode.ok()) << gcode.status();
  EXPECT_TRUE(*gcode == GcodeOfThisProcess());
}

class EveryServerProgram : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Programs, EveryServerProgram,
                         testing::Values("slicing", "planning", "beading", "infill", "ordering",
                                         "motion", "worker"),
                         [](const auto& info) { return info.param; });

TEST_P(EveryServerProgram, ServesAndEndsWellOnSigterm) {
  ServerProcess server("slicefarm-" + GetParam());
  EXPECT_EQ(ChildProcess("slicefarm", {"health", server.address}).Wait(), 0);
  server.process.Signal(SIGTERM);
  EXPECT_EQ(server.process.Wait(), 0);
}

TEST_P(EveryServerProgram, ServesMetrics) {
  ChildProcess process("slicefarm-" + GetParam(), {"--metrics-port", "0"});
  EXPECT_THAT(process.AwaitLine("metrics on "), testing::StartsWith("127.0.0.1:"));
  EXPECT_THAT(process.AwaitLine("listening on "), testing::StartsWith("127.0.0.1:"));
}

TEST_P(EveryServerProgram, SaysWhyItCannotServe) {
  const ServerProcess first("slicefarm-" + GetParam());
  ChildProcess second("slicefarm-" + GetParam(), {"--listen", first.address});
  EXPECT_EQ(second.Wait(), 1);
}

TEST_P(EveryServerProgram, TellsItsVersion) {
  ChildProcess process("slicefarm-" + GetParam(), {"--version"});
  EXPECT_THAT(process.AwaitLine("slicefarm "), testing::HasSubstr("build "));
  EXPECT_EQ(process.Wait(), 0);
}

/// Waits until the server has accepted a call of `method`.
void AwaitCall(int metrics_port, const std::string& method) {
  const std::string counter = "grpc_server_started_total{grpc_method=\"" + method + "\"";
  while (HttpGet(metrics_port, "/metrics").find(counter) == std::string::npos) {
    std::this_thread::yield();
  }
}

/// Returns the status of a new call over the channel.
grpc::StatusCode StatusOfACall(const std::shared_ptr<grpc::Channel>& channel) {
  grpc::ClientContext context;
  const auto stream = v1::Slicing::NewStub(channel)->Slice(&context);
  stream->WritesDone();
  return stream->Finish().error_code();
}

// SIGTERM during a call: new calls are refused, the current one ends well, and then the program
// ends.
TEST(ServerPrograms, DrainCallsInFlight) {
  ChildProcess process("slicefarm-slicing", {"--metrics-port", "0"});
  const std::string metrics = process.AwaitLine("metrics on 127.0.0.1:");
  const std::string address = process.AwaitLine("listening on ");
  const SliceInput input = TextBox();
  const std::string& bytes = input.files[0].bytes;

  const std::shared_ptr<grpc::Channel> channel = rpc::MakeChannel(address);
  const auto stub = v1::Slicing::NewStub(channel);
  grpc::ClientContext context;
  const auto stream = stub->Slice(&context);
  v1::SliceRequest request;
  ASSERT_TRUE(ToProto({}, input, {}, request.mutable_start()).ok());
  ASSERT_TRUE(stream->Write(request));
  AwaitCall(std::stoi(metrics), "Slice");
  process.Signal(SIGTERM);
  channel->WaitForStateChange(GRPC_CHANNEL_READY, gpr_inf_future(GPR_CLOCK_REALTIME));
  EXPECT_EQ(StatusOfACall(channel), grpc::StatusCode::UNAVAILABLE);

  request.set_chunk(bytes);
  ASSERT_TRUE(stream->Write(request));
  ASSERT_TRUE(stream->WritesDone());
  v1::SliceResponse response;
  ASSERT_TRUE(stream->Read(&response));
  const int32_t layers = response.summary().layer_count();
  EXPECT_GT(layers, 0);
  for (int32_t i = 0; i < layers; ++i) ASSERT_TRUE(stream->Read(&response));
  EXPECT_TRUE(stream->Finish().ok());
  EXPECT_EQ(process.Wait(), 0);
}

TEST(ServerPrograms, CancelCallsThatOutlastTheDrain) {
  ChildProcess process("slicefarm-slicing", {"--metrics-port", "0", "--drain", "0"});
  const std::string metrics = process.AwaitLine("metrics on 127.0.0.1:");
  const std::string address = process.AwaitLine("listening on ");
  const auto stub = v1::Slicing::NewStub(rpc::MakeChannel(address));
  grpc::ClientContext context;
  const auto stream = stub->Slice(&context);
  v1::SliceRequest request;
  ASSERT_TRUE(ToProto({}, TextBox(), {}, request.mutable_start()).ok());
  ASSERT_TRUE(stream->Write(request));  // the rest is never sent
  AwaitCall(std::stoi(metrics), "Slice");
  process.Signal(SIGTERM);
  EXPECT_FALSE(stream->Finish().ok());
  EXPECT_EQ(process.Wait(), 0);
}

}  // namespace
}  // namespace slicefarm::processes_test
