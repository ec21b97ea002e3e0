// Tests a job with a layer that kills the worker that gets it, among real processes: its damage,
// and its end. The workers are started again when they die, as by a service manager.
#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <cstring>
#include <fstream>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "common/base/sha256.h"
#include "common/base/temp_directory_test.h"
#include "common/rpc/client/channel.h"
#include "services/coordinator/server/api/coordinator_client_test.h"
#include "tests/corpus_file.h"
#include "tests/integration/child_process.h"

namespace slicefarm::poison_test {
namespace {

/// Number of workers that are down, now and at most so far.
struct Downs {
  std::atomic<int> now = 0, most = 0;

  void Add() {
    const int down = ++now;
    for (int seen = most; seen < down && !most.compare_exchange_weak(seen, down);) continue;
  }
};

/// Worker that is started again at once after the poison has killed it.
class KeptWorker {
 public:
  explicit KeptWorker(Downs& downs) : downs_(downs) {
    process_.emplace("/usr/bin/env", Arguments("127.0.0.1:0"));
    address_ = process_->address;
    keeper_ = std::thread([this] { Keep(); });
  }
  ~KeptWorker() {
    {
      const std::scoped_lock lock(mutex_);
      ends_ = true;
      process_->process.Signal(SIGKILL);
    }
    keeper_.join();
  }
  KeptWorker(const KeptWorker&) = delete;
  KeptWorker& operator=(const KeptWorker&) = delete;

  const std::string& address() const { return address_; }
  int deaths() const { return deaths_; }
  void Signal(int signal) {
    const std::scoped_lock lock(mutex_);
    process_->process.Signal(signal);
  }

 private:
  static std::vector<std::string> Arguments(const std::string& listen) {
    return {std::string("LD_PRELOAD=") + POISON_READER,
            SLICEFARM_BIN "/slicefarm-worker",
            "--slots",
            "1",
            "--listen",
            listen};
  }
  void Keep() {
    for (;;) {
      process_->process.Wait();
      const std::scoped_lock lock(mutex_);
      if (ends_) return;
      downs_.Add();
      ++deaths_;
      process_.emplace("/usr/bin/env", Arguments(address_));
      --downs_.now;
    }
  }

  Downs& downs_;
  std::optional<ServerProcess> process_;
  std::string address_;
  std::mutex mutex_;  ///< prevents the replacement of a process while another thread signals it
  bool ends_ = false;
  std::atomic<int> deaths_ = 0;
  std::thread keeper_;
};

/// Adds a closed box around the z axis to an STL.
void AddBox(float half, float low, float high, std::string& stl) {
  const auto corner = [&](int i) {
    return std::vector<float>{(i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half,
                              (i & 4) != 0 ? high : low};
  };
  constexpr int kFaces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  for (const auto& face : kFaces) {
    stl.append(12, '\0');
    for (const int i : face)
      for (const float value : corner(i))
        stl.append(reinterpret_cast<const char*>(&value), sizeof value);
    stl.append(2, '\0');
  }
}

/// Returns a tower. One of its layers has the corners that kill.
std::string PoisonedTower() {
  std::string stl(84, '\0');
  const uint32_t facets = 24;
  std::memcpy(stl.data() + 80, &facets, sizeof facets);
  AddBox(5, 0, 5, stl);
  AddBox(7.65625F, 2.51F, 2.54F, stl);
  return stl;
}

class PoisonTest : public testing::Test {
 protected:
  PoisonTest() {
    std::ofstream(tenants_) << R"({"tenants": {"a": {"tokens": [)" << Token("a")
                            << R"(]}, "b": {"tokens": [)" << Token("b") << "]}}}";
    coordinator_.emplace("slicefarm-coordinator",
                         std::vector<std::string>{
                             "--state-dir", state_.path(), "--slicing", slicing_.address,
                             "--planning", planning_.address, "--motion", motion_.address,
                             "--exposure", exposure_.address, "--tenants", tenants_, "--workers",
                             first_.address() + "," + second_.address(), "--metrics-port", "0"});
    coordinator_->AwaitMetric("slicefarm_workers 2");
    rpc::ChannelOptions options;
    options.token = "a";
    poisoner_.Connect(coordinator_->address, options);
    options.token = "b";
    other_.Connect(coordinator_->address, options);
  }

  static std::string Token(const std::string& token) {
    return R"({"sha256": ")" + Sha256Hex(token) + R"(", "scopes": ["submit", "read"]})";
  }

  v1::Job SubmitPoison() {
    const std::string tower = PoisonedTower();
    EXPECT_TRUE(poisoner_.Upload(tower).ok());
    v1::CreateJobRequest request = coordinator::CoordinatorClient::RequestFor(tower);
    request.mutable_spec()->set_process(v1::PROCESS_LASER);
    const auto job = poisoner_.Create(request);
    EXPECT_TRUE(job.ok()) << job.status();
    return job.value_or(v1::Job());
  }

  TempDirectory state_, directory_;
  const std::string tenants_ = directory_.path() + "/tenants.json";
  ServerProcess slicing_{"slicefarm-slicing"};
  ServerProcess planning_{"slicefarm-planning"};
  ServerProcess motion_{"slicefarm-motion"};
  ServerProcess exposure_{"slicefarm-exposure"};
  Downs downs_;
  KeptWorker first_{downs_}, second_{downs_};
  std::optional<ServerProcess> coordinator_;
  coordinator::CoordinatorClient poisoner_, other_;
};

TEST_F(PoisonTest, AJobThatKillsWorkersEndsAndTakesNoOtherWithIt) {
  const std::string box = CorpusFile("models/textbox.stl");
  // The two ranges are dispatched before any worker continues.
  first_.Signal(SIGSTOP);
  second_.Signal(SIGSTOP);
  const v1::Job poison = SubmitPoison();
  const std::string id = other_.Submit(box);
  coordinator_->AwaitMetric("slicefarm_worker_slots{state=\"busy\"} 2");
  first_.Signal(SIGCONT);
  second_.Signal(SIGCONT);

  EXPECT_EQ(other_.AwaitEnd(id).state(), v1::JOB_STATE_SUCCEEDED);
  const v1::Job end = poisoner_.AwaitEnd(poison.id());
  EXPECT_EQ(end.state(), v1::JOB_STATE_FAILED);
  EXPECT_EQ(end.error().reason(), "RANGE_POISONED") << end.error().message();
  EXPECT_GE(first_.deaths() + second_.deaths(), 3);
  EXPECT_LE(downs_.most, 1) << "workers were down at the same time";
  // The farm works again afterwards.
  v1::CreateJobRequest again = coordinator::CoordinatorClient::RequestFor(box);
  again.mutable_spec()->mutable_objects(0)->set_name("another name, another job");
  const auto job = other_.Create(again);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(other_.AwaitEnd(job->id()).state(), v1::JOB_STATE_SUCCEEDED);
}

}  // namespace
}  // namespace slicefarm::poison_test
