#include "tests/sim/farm.h"

#include <utility>

#include "common/base/error.h"

namespace slicefarm::coordinator::sim {
namespace {

constexpr int64_t kRangeDeadlineUs = 25 * kSecondUs;
/// Time after which keepalive detects a broken line.
constexpr int64_t kNoticedUs = 3 * kSecondUs;

}  // namespace

Farm::Farm(World& world) : world_(world) {
  for (size_t i = 0; i < world.scenario.workers.size(); ++i) {
    nodes_.push_back(std::make_unique<Node>(world.events));
    nodes_.back()->process.Start();
    nodes_.back()->lines.resize(world.scenario.coordinators.size());
  }
}

int64_t Farm::Delay() {
  const bool slow = world_.Happens(20);
  return world_.random.Between(100, slow ? 500'000 : 5'000);
}

bool Farm::Broken(int coordinator, int worker) const {
  return world_.Until(nodes_[worker]->lines[coordinator].broken_until_us);
}

bool Farm::Reachable(int coordinator, int worker) const {
  const Node& node = *nodes_[worker];
  const int64_t since_us = node.lines[coordinator].broken_since_us;
  const bool noticed = world_.events.now_us() - since_us > kNoticedUs;
  return node.process.up() && !(Broken(coordinator, worker) && noticed);
}

void Farm::Partition(int coordinator, int worker, int64_t until_us) {
  nodes_[worker]->lines[coordinator] = {world_.events.now_us(), until_us};
}

void Farm::Call(int coordinator, int worker, const RangeOfWork& range, Reply reply) {
  const auto flight = std::make_shared<InFlight>(InFlight{std::move(reply), coordinator});
  world_.events.After(kRangeDeadlineUs, [this, flight, worker] {
    nodes_[worker]->flights.remove(flight);
    SendAnswer(flight, 0, absl::DeadlineExceededError("no answer"));
  });
  if (Broken(coordinator, worker)) return;
  if (world_.Happens(world_.scenario.lost_permille)) {
    ++world_.totals.lost_messages;
    return SendAnswer(flight, Delay(), absl::UnavailableError("the stream broke"));
  }
  world_.events.After(Delay(), [this, flight, worker, range] { Arrived(worker, flight, range); });
}

void Farm::Arrived(int worker, const Flight& flight, const RangeOfWork& range) {
  Node& node = *nodes_[worker];
  if (!node.process.up()) {
    return SendAnswer(flight, Delay(), absl::UnavailableError("connection refused"));
  }
  if (!can(worker).Has(range.work.process))
    world_.Violated("w{} gets work {} of a process that it does not run", worker, range.work.id);
  node.flights.push_back(flight);
  const int64_t slowness = world_.scenario.workers[worker].slowness;
  const int64_t work_us = range.work.layer_us * (range.last - range.first) * slowness;
  node.process.After(work_us, [this, worker, flight, range] { Worked(worker, flight, range); });
}

void Farm::Worked(int worker, const Flight& flight, const RangeOfWork& range) {
  if (range.work.InMiddle(range.first, range.last)) {
    if (range.work.fault == Work::Fault::kPoisonLayer) {
      return Answer(worker, flight, absl::InternalError("a layer that cannot be made"));
    }
    if (range.work.fault == Work::Fault::kBadLayer) {
      return Answer(worker, flight, BadInput());
    }
  }
  if (world_.Happens(world_.scenario.worker_fault_permille)) {
    switch (world_.random.Below(3)) {
      case 0:
        return Answer(worker, flight, absl::InternalError("a worker's own fault"));
      case 1:
        return Answer(worker, flight,
                      MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBuildMismatch,
                                "a worker of another build"));
      default:
        return;  // the worker hangs until the deadline
    }
  }
  RangeHashes layers;
  for (int32_t i = range.first; i < range.last; ++i) {
    layers.push_back(LayerHash(range.work.id, range.build, i));
  }
  if (world_.variant.answers_mixed && last_made_.size() == layers.size()) {
    std::swap(last_made_, layers);
  } else {
    last_made_ = layers;
  }
  Answer(worker, flight, layers);
}

void Farm::Answer(int worker, const Flight& flight, const absl::StatusOr<RangeHashes>& answer) {
  nodes_[worker]->flights.remove(flight);
  if (flight->settled || Broken(flight->coordinator, worker)) return;
  if (world_.Happens(world_.scenario.lost_permille)) {
    ++world_.totals.lost_messages;
    return SendAnswer(flight, Delay(), absl::UnavailableError("the stream broke"));
  }
  if (world_.Happens(world_.scenario.doubled_permille)) {
    ++world_.totals.doubled_messages;
    world_.events.After(2 * Delay(), [flight, answer] { flight->reply(answer); });
  }
  SendAnswer(flight, Delay(), answer);
}

void Farm::SendAnswer(const Flight& flight, int64_t delay_us,
                      const absl::StatusOr<RangeHashes>& answer) {
  if (std::exchange(flight->settled, true)) return;
  world_.events.After(delay_us, [flight, answer] { flight->reply(answer); });
}

void Farm::Kill(int worker, int64_t restart_after_us) {
  Node& node = *nodes_[worker];
  if (!node.process.up()) return;
  node.process.Kill();
  const auto flights = std::exchange(node.flights, {});
  for (const Flight& flight : flights) {
    if (Broken(flight->coordinator, worker)) continue;
    SendAnswer(flight, 1'000, absl::UnavailableError("connection reset"));
  }
  world_.events.After(restart_after_us, [&node] { node.process.Start(); });
}

}  // namespace slicefarm::coordinator::sim
