#include "common/base/available_cpus.h"

#include <gtest/gtest.h>

#include <thread>

namespace slicefarm::available_cpus_test {
namespace {

TEST(AvailableCpus, AQuotaIsRoundedUp) {
  struct Case {
    std::string_view quota;
    std::string_view period;
    std::optional<int> cpus;
  };
  for (const Case& each : {Case{"200000", "100000", 2},
                           {"150000", "100000", 2},
                           {"50000", "100000", 1},
                           {"max", "100000", std::nullopt},
                           {"-1", "100000", std::nullopt},
                           {"", "", std::nullopt},
                           {"100000", "0", std::nullopt},
                           {"100000x", "100000", std::nullopt}}) {
    EXPECT_EQ(CpusOfQuota(each.quota, each.period), each.cpus) << each.quota;
  }
}

TEST(AvailableCpus, AreSomeAndNoMoreThanTheMachineHas) {
  EXPECT_GE(AvailableCpus(), 1);
  EXPECT_LE(AvailableCpus(), std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace
}  // namespace slicefarm::available_cpus_test
