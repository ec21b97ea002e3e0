#pragma once

#include <memory>
#include <utility>

#include "common/base/error.h"
#include "services/coordinator/store/jobs/forwarding_job_store.h"
#include "tests/sim/world.h"

namespace slicefarm::coordinator::sim {

/// Pair of stores that get the same calls. Each call returns the answer of the first store. If the
/// answer of the second store differs, reports this to the world as a violation.
class TwinStore : public JobStoreCalls<TwinStore> {
 public:
  TwinStore(World& world, JobStore& first, std::unique_ptr<JobStore> second)
      : world_(world), first_(first), second_(std::move(second)) {}

  /// Calls both stores and returns the answer of the first.
  template <typename Method, typename... Args>
  auto Dispatch(const char* name, Method method, const Args&... args) {
    auto answer = (first_.*method)(args...);
    const auto other = ((*second_).*method)(args...);
    if (!Equal(answer, other)) {
      world_.Violated("{}: the stores answer differently: {}, {}", name,
                      StatusOf(answer).ToString(), StatusOf(other).ToString());
    }
    return answer;
  }

 private:
  static const absl::Status& StatusOf(const absl::Status& status) { return status; }
  template <typename Value>
  static const absl::Status& StatusOf(const absl::StatusOr<Value>& answer) {
    return answer.status();
  }

  static bool Equal(const absl::Status& a, const absl::Status& b) {
    return a.code() == b.code() && DetailOf(a).reason == DetailOf(b).reason;
  }
  template <typename Value>
  static bool Equal(const absl::StatusOr<Value>& a, const absl::StatusOr<Value>& b) {
    return Equal(a.status(), b.status()) && (!a.ok() || *a == *b);
  }

  World& world_;
  JobStore& first_;
  const std::unique_ptr<JobStore> second_;
};

}  // namespace slicefarm::coordinator::sim
