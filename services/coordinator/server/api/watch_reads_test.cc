#include "services/coordinator/server/api/watch_reads.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"
#include "services/coordinator/store/jobs/forwarding_job_store.h"
#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator::watch_reads_test {
namespace {

/// Store that records the reads and lets each read wait until the test releases it.
class SlowStore : public ForwardingJobStore {
 public:
  using ForwardingJobStore::ForwardingJobStore;

  absl::StatusOr<JobRecord> Get(const std::string& id) override {
    ADD_FAILURE() << "reads the spec of " << id;
    return ForwardingJobStore::Get(id);
  }
  absl::StatusOr<std::vector<JobEventRecord>> Events(const std::string& id, int64_t after,
                                                     int32_t limit) override {
    std::unique_lock lock(mutex_);
    read_.push_back(id);
    changed_.notify_all();
    changed_.wait(lock, [this] { return open_; });
    lock.unlock();
    return ForwardingJobStore::Events(id, after, limit);
  }

  void AwaitReads(size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return read_.size() >= count; });
  }
  void Open() {
    const std::lock_guard lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }
  std::vector<std::string> read() {
    const std::lock_guard lock(mutex_);
    return read_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
  std::vector<std::string> read_;
};

class WatchReadsTest : public testing::Test {
 protected:
  WatchReadsTest() {
    for (const char* id : {"a1", "a2", "a3", "b1"}) {
      NewJob job;
      job.id = job.action_digest = id;
      job.tenant = std::string(id).substr(0, 1);
      EXPECT_TRUE(memory_.Create(job, 5).ok());
    }
  }

  WatchReads::Done Count() {
    return [this](const WatchReads::Result& result) {
      EXPECT_TRUE(result.ok()) << result.status();
      ++answers_;
    };
  }

  MemoryJobs jobs_;
  MemoryJobStore memory_{jobs_};
  SlowStore store_{memory_};
  std::atomic<int> answers_ = 0;
};

TEST_F(WatchReadsTest, AllWhoWantTheSameGetItFromOneRead) {
  WatchReads reads(store_, 1);
  reads.Read("a", "a1", 0, Count());
  store_.AwaitReads(1);
  for (int i = 0; i < 1000; ++i) reads.Read("a", "a1", 0, Count());
  store_.Open();
  reads.Read("a", "a2", 0, Count());
  store_.AwaitReads(3);
  reads.Stop();
  EXPECT_THAT(store_.read(), testing::ElementsAre("a1", "a1", "a2"))
      << "the first read may have been too early for the others";
}

TEST_F(WatchReadsTest, TenantsTakeTurns) {
  WatchReads reads(store_, 1);
  reads.Read("a", "a1", 0, Count());
  store_.AwaitReads(1);
  for (const char* id : {"a1", "a2", "a3"}) reads.Read("a", id, 0, Count());
  reads.Read("b", "b1", 0, Count());
  store_.Open();
  store_.AwaitReads(5);
  EXPECT_THAT(store_.read(), testing::ElementsAre("a1", "a1", "b1", "a2", "a3"));
}

TEST_F(WatchReadsTest, AStopLeavesNobodyWithoutAnAnswer) {
  WatchReads reads(store_, 1);
  std::atomic<int> refused = 0;
  const WatchReads::Done refuse = [&](const WatchReads::Result& result) {
    refused += absl::IsUnavailable(result.status()) &&
               DetailOf(result.status()).metadata.contains(rpc::kRetryAfterMs);
  };
  reads.Read("a", "a1", 0, Count());
  store_.AwaitReads(1);
  reads.Read("a", "a2", 0, refuse);
  std::thread stop([&] { reads.Stop(); });
  // Repeats the read until Stop takes effect.
  for (int before = refused; refused == before;) reads.Read("a", "a2", 0, refuse);
  store_.Open();
  stop.join();
  EXPECT_EQ(answers_, 1);
  EXPECT_EQ(store_.read().size(), 1u);
}

TEST_F(WatchReadsTest, AnUnknownJobIsAnError) {
  WatchReads reads(store_, 1);
  store_.Open();
  std::atomic<bool> not_found = false;
  reads.Read("a", "none", 0, [&](const WatchReads::Result& result) {
    not_found = DetailOf(result.status()).reason == Reason::kJobNotFound;
  });
  store_.AwaitReads(1);
  reads.Stop();
  EXPECT_TRUE(not_found);
}

}  // namespace
}  // namespace slicefarm::coordinator::watch_reads_test
