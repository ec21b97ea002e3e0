#include "tests/sim/sim_client.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"

namespace slicefarm::coordinator::sim {
namespace {

constexpr int64_t kCallDeadlineUs = 5 * kSecondUs;

}  // namespace

SimClient::SimClient(World& world, CheckedStore& store, Coordinators& coordinators, int index)
    : world_(world),
      store_(store),
      coordinators_(coordinators),
      index_(index),
      plan_(world.scenario.clients[index]) {}

void SimClient::Start() {
  world_.events.At(plan_.begin_us, [this] { Create(); });
}

void SimClient::StartFromYesterday(const std::string& job_id) {
  world_.events.At(plan_.begin_us, [this, job_id] { Created(job_id); });
}

/// Calls a coordinator. Calls `then` once: with the answer, or when no answer arrives in time.
void SimClient::Send(const Call& call, const ReplyTo& then) {
  const auto settled = std::make_shared<bool>(false);
  const ReplyTo settle = [settled, then](const absl::StatusOr<Reply>& reply) {
    if (!std::exchange(*settled, true)) then(reply);
  };
  SimCoordinator& to = *coordinators_[world_.random.Below(static_cast<int>(coordinators_.size()))];
  const auto delay_us = [&] { return world_.random.Between(200, 20'000); };
  if (world_.Happens(world_.scenario.lost_permille)) {
    ++world_.totals.lost_messages;
  } else {
    Arrive(to, delay_us(), call, settle);
  }
  if (world_.Happens(world_.scenario.doubled_permille)) {
    ++world_.totals.doubled_messages;
    Arrive(to, world_.random.Between(0, 10 * kSecondUs), call, settle);
  }
  world_.events.After(kCallDeadlineUs,
                      [settle] { settle(absl::DeadlineExceededError("no answer")); });
}

void SimClient::Arrive(SimCoordinator& to, int64_t delay_us, const Call& call,
                       const ReplyTo& settle) {
  world_.events.After(delay_us, [this, &to, call, settle] {
    if (!to.Serving()) return settle(absl::UnavailableError("connection refused"));
    to.process().After(0, [this, &to, call, settle] {
      if (!to.Serving()) return settle(absl::UnavailableError("it stops"));
      call(to, [this, settle](const absl::StatusOr<Reply>& reply) {
        if (world_.Happens(world_.scenario.lost_permille)) {
          ++world_.totals.lost_messages;
          return;
        }
        const int64_t back_us = world_.random.Between(200, 20'000);
        world_.events.After(back_us, [settle, reply] { settle(reply); });
      });
    });
  });
}

void SimClient::Again(void (SimClient::*what)()) {
  world_.events.After(world_.random.Between(100, 1000) * kMillisecondUs,
                      [this, what] { (this->*what)(); });
}

void SimClient::Create() {
  const std::string job_id = absl::StrCat("j", index_, ".", tries_++);
  const auto copies = std::make_shared<int>(0);
  Send(
      [plan = plan_, job_id, copies](SimCoordinator& to, const ReplyTo& reply) {
        // The coordinator generates the id, so a doubled call gets another id.
        to.Create(plan, absl::StrCat(job_id, (*copies)++ == 0 ? "" : "'"), reply);
      },
      [this](const absl::StatusOr<Reply>& reply) {
        reply.ok() ? Created(reply->job.id) : NotCreated(reply.status());
      });
}

void SimClient::NotCreated(const absl::Status& error) {
  const Reason reason = DetailOf(error).reason;
  if (reason == Reason::kBlobNotFound) {
    world_.blobs.Put({plan_.tenant, MeshOf(plan_.work)}, world_.wall_us());
  }
  const bool refused = reason == Reason::kBlobNotFound || reason == Reason::kQueueFull;
  // Without a request_id, a client that does not know whether the job exists must not repeat the
  // call.
  const bool may_ask = refused || !plan_.request_id.empty();
  if (may_ask && reason != Reason::kRequestIdReused) return Again(&SimClient::Create);
  done_ = true;
}

void SimClient::Created(const std::string& job_id) {
  job_id_ = job_id;
  store_.Acknowledged(job_id);
  world_.Log("client {} has {}", index_, job_id);
  if (plan_.cancel_after_us) {
    cancelling_ = true;
    world_.events.After(*plan_.cancel_after_us, [this] { Cancel(); });
  }
  Watch();
}

void SimClient::Cancel() {
  Send([id = job_id_](SimCoordinator& to, const ReplyTo& reply) { to.Cancel(id, reply); },
       [this](const absl::StatusOr<Reply>& reply) {
         if (!reply.ok() && !absl::IsNotFound(reply.status())) return Again(&SimClient::Cancel);
         cancelling_ = false;
       });
}

void SimClient::Watch() {
  Send([id = job_id_, after = seen_](SimCoordinator& to,
                                     const ReplyTo& reply) { to.Events(id, after, reply); },
       [this](const absl::StatusOr<Reply>& reply) {
         if (reply.ok()) return Watched(reply->events);
         if (!absl::IsNotFound(reply.status())) return Again(&SimClient::Watch);
         if (!store_.Deleted(job_id_)) world_.Violated("{} was not found", job_id_);
         done_ = true;
       });
}

void SimClient::Watched(const std::vector<JobEventRecord>& events) {
  for (const JobEventRecord& event : events) {
    if (event.sequence != ++seen_) {
      world_.Violated("client {} got event {} of {} as number {}", index_, event.sequence, job_id_,
                      seen_);
    }
  }
  if (events.empty() || !IsTerminal(events.back().state)) return Again(&SimClient::Watch);
  Ended(events.back().state);
}

void SimClient::Ended(JobState state) {
  world_.Log("client {} knows that {} is {}", index_, job_id_, JobStateName(state));
  const JobRecord* job = store_.Find(job_id_);
  if (job ? job->state != state : !store_.Deleted(job_id_)) {
    world_.Violated("{} was told to be {}, and is not", job_id_, JobStateName(state));
  }
  if (plan_.deletes) return Delete();
  done_ = true;
}

void SimClient::Delete() {
  if (cancelling_) return Again(&SimClient::Delete);
  Send([id = job_id_](SimCoordinator& to, const ReplyTo& reply) { to.Delete(id, reply); },
       [this](const absl::StatusOr<Reply>& reply) {
         if (absl::IsFailedPrecondition(reply.status())) {
           world_.Violated("{} ended, and may not be deleted", job_id_);
         }
         if (!reply.ok() && !absl::IsNotFound(reply.status())) return Again(&SimClient::Delete);
         done_ = true;
       });
}

}  // namespace slicefarm::coordinator::sim
