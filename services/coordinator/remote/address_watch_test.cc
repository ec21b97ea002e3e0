#include "services/coordinator/remote/address_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

#include "common/base/error.h"

namespace slicefarm::coordinator::address_watch_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Addresses = std::vector<std::string>;

TEST(SplitAddresses, CutsAtCommas) {
  EXPECT_THAT(SplitAddresses(""), IsEmpty());
  EXPECT_THAT(SplitAddresses("a:1"), ElementsAre("a:1"));
  EXPECT_THAT(SplitAddresses("a:1,b:2,,c:3,"), ElementsAre("a:1", "b:2", "c:3"));
}

TEST(ResolveByDns, NumbersStayAsTheyAre) {
  EXPECT_THAT(*ResolveByDns("127.0.0.1:50051"), ElementsAre("127.0.0.1:50051"));
  EXPECT_THAT(*ResolveByDns("[::1]:50051"), ElementsAre("[::1]:50051"));
}

TEST(ResolveByDns, AHostOfBothFamiliesIsOne) {
  EXPECT_THAT(*ResolveByDns("localhost:7"), ElementsAre("127.0.0.1:7"));
}

TEST(ResolveByDns, UnknownHostsAreUnavailable) {
  const absl::Status status = ResolveByDns("no-such-host.invalid:1").status();
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_EQ(DetailOf(status).metadata["address"], "no-such-host.invalid:1");
}

TEST(ResolveByDns, WhatIsNoHostAndPortIsRefused) {
  for (const char* name : {"", "host", "host:", ":1"}) {
    EXPECT_TRUE(absl::IsInvalidArgument(ResolveByDns(name).status())) << name;
  }
}

/// Fake name service with answers from the test. Records the addresses that the watch has reported.
class Names {
 public:
  AddressWatchOptions Options() {
    AddressWatchOptions options;
    options.every = std::chrono::hours(1);  // only Refresh triggers another lookup
    options.least_pause = std::chrono::milliseconds(1);
    options.resolve = [this](const std::string& name) -> absl::StatusOr<Addresses> {
      const std::lock_guard lock(mutex_);
      ++looks_;
      changed_.notify_all();
      if (!answers_.contains(name)) return absl::UnavailableError("not known");
      return answers_[name];
    };
    return options;
  }
  auto Listener() {
    return [this](const Addresses& addresses) {
      const std::lock_guard lock(mutex_);
      reported_.push_back(addresses);
      changed_.notify_all();
    };
  }
  void Set(const std::string& name, Addresses addresses) {
    const std::lock_guard lock(mutex_);
    answers_[name] = std::move(addresses);
  }
  void Forget(const std::string& name) {
    const std::lock_guard lock(mutex_);
    answers_.erase(name);
  }
  std::vector<Addresses> AwaitReported(size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return reported_.size() >= count; });
    return reported_;
  }
  int looks() {
    const std::lock_guard lock(mutex_);
    return looks_;
  }
  void AwaitLooks(int count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return looks_ >= count; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, Addresses> answers_;
  std::vector<Addresses> reported_;
  int looks_ = 0;
};

TEST(AddressWatch, TellsAllAddressesSortedAndOnce) {
  Names names;
  names.Set("a:1", {"10.0.0.3:1", "10.0.0.1:1"});
  names.Set("b:1", {"10.0.0.2:1", "10.0.0.1:1"});
  AddressWatch watch({"a:1", "b:1"}, names.Listener(), names.Options());
  EXPECT_THAT(names.AwaitReported(1),
              ElementsAre(ElementsAre("10.0.0.1:1", "10.0.0.2:1", "10.0.0.3:1")));
}

TEST(AddressWatch, TellsWhatChanged) {
  Names names;
  names.Set("a:1", {"10.0.0.1:1"});
  AddressWatch watch({"a:1"}, names.Listener(), names.Options());
  names.AwaitReported(1);
  names.Set("a:1", {"10.0.0.1:1", "10.0.0.2:1"});
  watch.Refresh();
  names.AwaitReported(2);
  names.Set("a:1", {"10.0.0.2:1"});
  watch.Refresh();
  EXPECT_THAT(names.AwaitReported(3),
              ElementsAre(ElementsAre("10.0.0.1:1"), ElementsAre("10.0.0.1:1", "10.0.0.2:1"),
                          ElementsAre("10.0.0.2:1")));
}

TEST(AddressWatch, IsSilentWhileNothingChanges) {
  Names names;
  names.Set("a:1", {"10.0.0.1:1"});
  AddressWatch watch({"a:1"}, names.Listener(), names.Options());
  names.AwaitReported(1);
  for (int look = 2; look < 5; ++look) {
    watch.Refresh();
    names.AwaitLooks(look);
  }
  EXPECT_THAT(names.AwaitReported(1), testing::SizeIs(1));
}

// A failure of the name service must not remove the workers.
TEST(AddressWatch, AFailingNameKeepsItsAddresses) {
  Names names;
  names.Set("a:1", {"10.0.0.1:1"});
  names.Set("b:1", {"10.0.0.2:1"});
  AddressWatch watch({"a:1", "b:1"}, names.Listener(), names.Options());
  names.AwaitReported(1);
  names.Forget("a:1");
  names.Set("b:1", {"10.0.0.9:1"});
  watch.Refresh();
  EXPECT_THAT(names.AwaitReported(2).back(), ElementsAre("10.0.0.1:1", "10.0.0.9:1"));
}

}  // namespace
}  // namespace slicefarm::coordinator::address_watch_test
