#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "absl/status/statusor.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "tests/sim/process.h"
#include "tests/sim/world.h"

namespace slicefarm::coordinator::sim {

/// Returns the error of a failed store.
absl::Status StoreFailed();

/// Connection of a coordinator to the store. A call takes effect some time after the coordinator
/// has made it, and its answer arrives later still. The coordinator may be paused or die between
/// these times. A call may fail before or after its effect. It may also take effect long after it
/// seems to have failed.
class StoreLink {
 public:
  StoreLink(World& world, Process& process, JobStore& store)
      : world_(world), process_(process), store_(store) {}

  /// Makes a call and passes its result to `then`. `call` returns a Status or a StatusOr.
  template <typename Call, typename Then>
  void Do(Call call, Then then) {
    // The coordinator may be paused between the decision and the call.
    process_.After(Delay(), [this, call = std::move(call), then = std::move(then)]() mutable {
      Send(std::move(call), std::move(then));
    });
  }

 private:
  enum class Fate { kWorks, kFailsBefore, kFailsAfter, kFailsAndWorksLate };

  int64_t Delay();
  Fate Draw();

  template <typename Call, typename Then>
  void Send(Call call, Then then) {
    using Answer = decltype(call(store_));
    const Fate fate = Draw();
    const int64_t life = process_.life();
    // The store makes the effect, even if the caller has died.
    const auto effect = [this, fate, life, call = std::move(call), then]() mutable {
      Answer answer = fate == Fate::kFailsBefore ? Answer(StoreFailed()) : call(store_);
      if (fate == Fate::kFailsAfter) answer = StoreFailed();
      if (fate != Fate::kFailsAndWorksLate && life == process_.life())
        Reply(then, std::move(answer));
    };
    if (fate == Fate::kFailsAndWorksLate) {
      Reply(then, Answer(StoreFailed()));
      world_.events.After(world_.random.Between(0, 20 * kSecondUs), std::move(effect));
    } else {
      world_.events.After(Delay(), std::move(effect));
    }
  }

  template <typename Then, typename Answer>
  void Reply(const Then& then, Answer answer) {
    process_.After(Delay(),
                   [then, answer = std::move(answer)]() mutable { then(std::move(answer)); });
  }

  World& world_;
  Process& process_;
  JobStore& store_;
};

}  // namespace slicefarm::coordinator::sim
