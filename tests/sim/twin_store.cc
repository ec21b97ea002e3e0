#include "tests/sim/twin_store.h"

#include "common/base/error.h"

namespace slicefarm::coordinator::sim {
namespace {

const absl::Status& StatusOf(const absl::Status& status) { return status; }

template <typename Value>
const absl::Status& StatusOf(const absl::StatusOr<Value>& answer) {
  return answer.status();
}

bool Equal(const absl::Status& a, const absl::Status& b) {
  return a.code() == b.code() && DetailOf(a).reason == DetailOf(b).reason;
}

template <typename Value>
bool Equal(const absl::StatusOr<Value>& a, const absl::StatusOr<Value>& b) {
  return Equal(a.status(), b.status()) && (!a.ok() || *a == *b);
}

}  // namespace

template <typename Call>
auto TwinStore::Both(const char* name, const Call& call) {
  auto answer = call(first_);
  const auto other = call(*second_);
  if (!Equal(answer, other)) {
    world_.Violated("{}: the stores answer differently: {}, {}", name, StatusOf(answer).ToString(),
                    StatusOf(other).ToString());
  }
  return answer;
}

absl::StatusOr<Created> TwinStore::Create(const NewJob& job, int64_t now_us) {
  return Both("Create", [&](JobStore& store) { return store.Create(job, now_us); });
}

absl::StatusOr<std::vector<Created>> TwinStore::CreateAll(const std::vector<NewJob>& jobs,
                                                          int64_t now_us) {
  return Both("CreateAll", [&](JobStore& store) { return store.CreateAll(jobs, now_us); });
}

absl::StatusOr<JobRecord> TwinStore::Get(const std::string& id) {
  return Both("Get", [&](JobStore& store) { return store.Get(id); });
}

absl::StatusOr<std::string> TwinStore::TenantOf(const std::string& id) {
  return Both("TenantOf", [&](JobStore& store) { return store.TenantOf(id); });
}

absl::StatusOr<std::vector<JobRecord>> TwinStore::List(const ListQuery& query) {
  return Both("List", [&](JobStore& store) { return store.List(query); });
}

absl::StatusOr<std::optional<JobRecord>> TwinStore::Claim(const std::string& owner, int64_t now_us,
                                                          int64_t until_us,
                                                          const ClaimFilter& filter) {
  return Both("Claim",
              [&](JobStore& store) { return store.Claim(owner, now_us, until_us, filter); });
}

absl::StatusOr<std::vector<JobRecord>> TwinStore::EndOverdue(const JobError& error, int64_t now_us,
                                                             int32_t limit) {
  return Both("EndOverdue",
              [&](JobStore& store) { return store.EndOverdue(error, now_us, limit); });
}

absl::StatusOr<bool> TwinStore::Adopt(const Lease& lease, const JobIdentity& identity,
                                      int64_t now_us) {
  return Both("Adopt", [&](JobStore& store) { return store.Adopt(lease, identity, now_us); });
}

absl::StatusOr<std::vector<HeldJob>> TwinStore::Renew(const std::vector<Lease>& leases,
                                                      int64_t until_us) {
  return Both("Renew", [&](JobStore& store) { return store.Renew(leases, until_us); });
}

absl::Status TwinStore::Release(const std::string& owner) {
  return Both("Release", [&](JobStore& store) { return store.Release(owner); });
}

absl::StatusOr<JobRecord> TwinStore::Update(const Lease& lease, const JobUpdate& update,
                                            int64_t now_us) {
  return Both("Update", [&](JobStore& store) { return store.Update(lease, update, now_us); });
}

absl::StatusOr<JobRecord> TwinStore::RequestCancel(const std::string& id, int64_t now_us) {
  return Both("RequestCancel", [&](JobStore& store) { return store.RequestCancel(id, now_us); });
}

absl::StatusOr<JobRecord> TwinStore::Change(const std::string& id, const JobChanging& changing,
                                            int64_t now_us) {
  return Both("Change", [&](JobStore& store) { return store.Change(id, changing, now_us); });
}

absl::Status TwinStore::Delete(const std::string& id) {
  return Both("Delete", [&](JobStore& store) { return store.Delete(id); });
}

absl::StatusOr<std::vector<JobRecord>> TwinStore::FindRequested(
    const std::string& tenant, const std::vector<std::string>& request_ids,
    const std::string& spec_digest) {
  return Both("FindRequested", [&](JobStore& store) {
    return store.FindRequested(tenant, request_ids, spec_digest);
  });
}

absl::StatusOr<JobRecord> TwinStore::GetWithoutSpec(const std::string& id) {
  return Both("GetWithoutSpec", [&](JobStore& store) { return store.GetWithoutSpec(id); });
}

absl::StatusOr<std::vector<JobEventRecord>> TwinStore::Events(const std::string& id, int64_t after,
                                                              int32_t limit) {
  return Both("Events", [&](JobStore& store) { return store.Events(id, after, limit); });
}

absl::StatusOr<std::vector<TenantEvent>> TwinStore::EventsOf(const std::string& tenant,
                                                             const EventPlace& after,
                                                             int32_t limit) {
  return Both("EventsOf", [&](JobStore& store) { return store.EventsOf(tenant, after, limit); });
}

absl::StatusOr<std::optional<JobResult>> TwinStore::FindResult(const std::string& action_digest) {
  return Both("FindResult", [&](JobStore& store) { return store.FindResult(action_digest); });
}

absl::Status TwinStore::ForgetResult(const std::string& action_digest) {
  return Both("ForgetResult", [&](JobStore& store) { return store.ForgetResult(action_digest); });
}

absl::Status TwinStore::ExpireRequestIds(int64_t now_us) {
  return Both("ExpireRequestIds", [&](JobStore& store) { return store.ExpireRequestIds(now_us); });
}

absl::StatusOr<std::map<JobState, int64_t>> TwinStore::CountEnded() {
  return Both("CountEnded", [](JobStore& store) { return store.CountEnded(); });
}

absl::StatusOr<int64_t> TwinStore::CountOf(const std::string& tenant) {
  return Both("CountOf", [&](JobStore& store) { return store.CountOf(tenant); });
}

absl::StatusOr<std::map<JobState, int64_t>> TwinStore::CountOpenOf(const std::string& tenant) {
  return Both("CountOpenOf", [&](JobStore& store) { return store.CountOpenOf(tenant); });
}

absl::StatusOr<std::vector<OpenJobs>> TwinStore::CountOpen() {
  return Both("CountOpen", [](JobStore& store) { return store.CountOpen(); });
}

absl::StatusOr<QueueSnapshot> TwinStore::ReadQueue(int64_t now_us) {
  return Both("ReadQueue", [&](JobStore& store) { return store.ReadQueue(now_us); });
}

absl::StatusOr<std::set<std::string>> TwinStore::Referenced(const std::string& tenant,
                                                            const std::set<std::string>& digests) {
  return Both("Referenced", [&](JobStore& store) { return store.Referenced(tenant, digests); });
}

absl::StatusOr<std::set<std::string>> TwinStore::Artifacts(const std::string& tenant,
                                                           const std::set<std::string>& digests) {
  return Both("Artifacts", [&](JobStore& store) { return store.Artifacts(tenant, digests); });
}

absl::StatusOr<std::vector<std::string>> TwinStore::EndedBefore(int64_t time_us, int32_t limit) {
  return Both("EndedBefore", [&](JobStore& store) { return store.EndedBefore(time_us, limit); });
}

absl::StatusOr<bool> TwinStore::TakeChore(const std::string& chore, int64_t now_us,
                                          int64_t until_us) {
  return Both("TakeChore",
              [&](JobStore& store) { return store.TakeChore(chore, now_us, until_us); });
}

absl::StatusOr<int64_t> TwinStore::InUseSince(int64_t now_us, int64_t most_gap_us) {
  return Both("InUseSince", [&](JobStore& store) { return store.InUseSince(now_us, most_gap_us); });
}

}  // namespace slicefarm::coordinator::sim
