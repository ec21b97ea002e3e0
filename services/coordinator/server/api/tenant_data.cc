#include "services/coordinator/server/api/tenant_data.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <set>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/stoppable_sleep.h"
#include "services/coordinator/algo/tar_entry.h"
#include "services/coordinator/server/api/preset_library.h"
#include "services/coordinator/server/api/profile_settings.h"
#include "services/coordinator/server/messages/jobs_wire.h"
#include "services/coordinator/store/blobs/checking_reader.h"

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kPage = 200;

absl::Status NobodyWantsMore() {
  return MakeError(absl::StatusCode::kCancelled, Reason::kCancelled, "the client left");
}

std::string JsonOf(const google::protobuf::Message& message) {
  google::protobuf::util::JsonPrintOptions print;
  print.preserve_proto_field_names = true;
  print.add_whitespace = true;
  std::string json;
  const auto written = google::protobuf::util::MessageToJsonString(message, &json, print);
  return written.ok() ? json : "{}";
}

class Archive {
 public:
  Archive(int64_t now_us, const CancelToken& cancel, const TakeBytes& take)
      : time_s_(now_us / 1'000'000), cancel_(cancel), take_(take) {}

  absl::Status AddText(const std::string& name, const std::string& text) {
    return Take(absl::StrCat(TarHeader(name, std::ssize(text), time_s_), text,
                             TarPadding(std::ssize(text))));
  }

  absl::Status AddBlob(const std::string& name, BlobReader& blob) {
    if (absl::Status begun = Take(TarHeader(name, blob.size(), time_s_)); !begun.ok()) return begun;
    for (int64_t at = 0; at < blob.size();) {
      const auto piece = blob.Read(at, kBlobPieceBytes);
      if (!piece.ok()) return piece.status();
      at += std::ssize(*piece);
      if (absl::Status taken = Take(*piece); !taken.ok()) return taken;
    }
    return Take(TarPadding(blob.size()));
  }

  absl::Status End() { return Take(TarEnd()); }

 private:
  absl::Status Take(std::string_view bytes) {
    if (absl::Status wanted = cancel_.Check(); !wanted.ok()) return wanted;
    return take_(bytes) ? absl::OkStatus() : NobodyWantsMore();
  }

  const int64_t time_s_;
  const CancelToken cancel_;
  const TakeBytes& take_;
};

absl::Status AddJobs(const std::string& tenant, JobStore& jobs, Archive& archive) {
  ListQuery query{.tenant = tenant, .oldest_first = true, .limit = kPage};
  while (true) {
    const auto page = jobs.List(query);
    if (!page.ok()) return page.status();
    if (page->empty()) return absl::OkStatus();
    for (const JobRecord& job : *page) {
      absl::Status added =
          archive.AddText(absl::StrCat("jobs/", job.id, ".json"), JsonOf(ToProto(job)));
      if (!added.ok()) return added;
    }
    query.after_number = page->back().number;
  }
}

absl::StatusOr<std::vector<BlobEntry>> BlobsOf(BlobStore& store) {
  std::vector<BlobEntry> entries;
  const absl::Status seen =
      store.ForEach([&](const BlobEntry& entry) { entries.push_back(entry); });
  if (!seen.ok()) return seen;
  std::ranges::sort(entries, {}, &BlobEntry::digest);
  return entries;
}

/// Adds all complete blobs. Adds the names of unreadable blobs to `damaged`.
absl::Status AddBlobs(const std::shared_ptr<BlobStore>& store, Archive& archive,
                      std::string& damaged) {
  const auto entries = BlobsOf(*store);
  if (!entries.ok()) return entries.status();
  for (const BlobEntry& entry : *entries) {
    if (!entry.complete) continue;
    const std::string name = absl::StrCat("blobs/", entry.digest);
    // Open checks the whole blob, before its size is written
    const auto blob = store->Open(entry.digest);
    if (absl::IsNotFound(blob.status())) continue;
    if (absl::IsDataLoss(blob.status())) {
      absl::StrAppend(&damaged, name, "\n");
      continue;
    }
    if (!blob.ok()) return blob.status();
    if (absl::Status added = archive.AddBlob(name, **blob); !added.ok()) return added;
  }
  return absl::OkStatus();
}

/// Returns the newest revisions of all profiles of a tenant.
absl::StatusOr<std::vector<ProfileRecord>> ProfilesOf(const std::string& tenant,
                                                      ProfileStore& profiles) {
  std::vector<ProfileRecord> all;
  while (true) {
    const auto page = profiles.List(tenant, all.empty() ? "" : all.back().name, kPage);
    if (!page.ok()) return page.status();
    if (page->empty()) return all;
    all.insert(all.end(), page->begin(), page->end());
  }
}

/// Adds all revisions. `folder`: folder in the archive. `read`: ReadProfile or ReadBundle.
template <typename Read>
absl::Status AddRevisions(const std::string& tenant, ProfileStore& profiles,
                          const std::string& folder, const Read& read, Archive& archive) {
  const auto newest = ProfilesOf(tenant, profiles);
  if (!newest.ok()) return newest.status();
  // The number is used in the file name, because a profile name may be too long or an unsafe path,
  // such as "..".
  int64_t number = 0;
  for (const ProfileRecord& last : *newest) {
    ++number;
    for (int64_t revision = 1; revision <= last.revision; ++revision) {
      const auto record = profiles.Get(tenant, last.name, revision);
      if (absl::IsNotFound(record.status())) continue;  // deleted meanwhile
      if (!record.ok()) return record.status();
      const auto message = read(*record);
      if (!message.ok()) return message.status();
      absl::Status added = archive.AddText(
          absl::StrCat(folder, "/", number, "-", revision, ".json"), JsonOf(*message));
      if (!added.ok()) return added;
    }
  }
  return absl::OkStatus();
}

/// Deletes the ended jobs of a page and cancels the rest. Returns the number of deleted jobs.
absl::StatusOr<int64_t> ErasePage(const std::vector<JobRecord>& page, JobStore& jobs,
                                  int64_t now_us,
                                  const std::function<void(const std::string&)>& cancelled) {
  int64_t gone = 0;
  for (const JobRecord& job : page) {
    if (!IsTerminal(job.state)) {
      const auto asked = jobs.RequestCancel(job.id, now_us);
      if (asked.ok()) cancelled(job.id);
      if (!asked.ok() && !absl::IsNotFound(asked.status())) return asked.status();
      if (!asked.ok() || !IsTerminal(asked->state)) continue;
    }
    const absl::Status deleted = jobs.Delete(job.id);
    if (DetailOf(deleted).reason == Reason::kJobNotFinished) continue;
    if (!deleted.ok() && !absl::IsNotFound(deleted)) return deleted;
    ++gone;
  }
  return gone;
}

absl::StatusOr<int64_t> EraseJobs(const std::string& tenant, JobStore& jobs,
                                  const std::function<int64_t()>& now_us, const CancelToken& cancel,
                                  const std::function<void(const std::string&)>& cancelled) {
  int64_t erased = 0;
  while (true) {
    const auto page = jobs.List({.tenant = tenant, .oldest_first = true, .limit = kPage});
    if (!page.ok()) return page.status();
    if (page->empty()) return erased;
    const auto gone = ErasePage(*page, jobs, now_us(), cancelled);
    if (!gone.ok()) return gone.status();
    erased += *gone;
    // Running jobs end soon after the cancel.
    const auto pause = std::chrono::milliseconds(*gone == 0 ? 100 : 0);
    if (absl::Status wanted = SleepUnlessCancelled(cancel, pause); !wanted.ok()) return wanted;
  }
}

absl::Status EraseBlobs(const std::string& tenant, const TenantData& data,
                        const CancelToken& cancel, v1::EraseTenantResponse& erased) {
  const auto store = data.blobs.Of(tenant);
  if (!store.ok()) return store.status();
  const auto entries = BlobsOf(**store);
  if (!entries.ok()) return entries.status();
  for (size_t next = 0; next < entries->size();) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    const size_t end = std::min(next + kPage, entries->size());
    std::set<std::string> digests;
    for (size_t i = next; i < end; ++i) digests.insert((*entries)[i].digest);
    // The blobs that are still referenced are used by other tenants: the tenant's own jobs are
    // deleted.
    const auto used = data.jobs.Referenced(tenant, digests);
    if (!used.ok()) return used.status();
    for (; next < end; ++next) {
      const BlobEntry& entry = (*entries)[next];
      if (used->contains(entry.digest)) {
        erased.set_shared_blobs(erased.shared_blobs() + 1);
        continue;
      }
      const auto deleted = (*store)->Delete(entry.digest, /*idle_s=*/0);
      if (!deleted.ok()) return deleted.status();
      if (!*deleted) continue;
      erased.set_blobs(erased.blobs() + 1);
      erased.set_bytes(erased.bytes() + entry.size);
    }
  }
  return (*store)->DropDamaged(/*aside_s=*/0).status();
}

/// Deletes all profiles. Returns their number.
absl::StatusOr<int64_t> EraseProfiles(const std::string& tenant, ProfileStore& profiles,
                                      int64_t now_us) {
  const auto all = ProfilesOf(tenant, profiles);
  if (!all.ok()) return all.status();
  for (const ProfileRecord& profile : *all) {
    const absl::Status deleted = profiles.Delete(tenant, profile.name, /*revision=*/0, now_us);
    if (!deleted.ok() && !absl::IsNotFound(deleted)) return deleted;
  }
  return std::ssize(*all);
}

}  // namespace

absl::Status ExportTenant(const std::string& tenant, const TenantData& data, int64_t now_us,
                          const CancelToken& cancel, const TakeBytes& take) {
  Archive archive(now_us, cancel, take);
  if (absl::Status added = AddJobs(tenant, data.jobs, archive); !added.ok()) return added;
  absl::Status revisions = AddRevisions(tenant, data.profiles, "profiles", ReadProfile, archive);
  if (revisions.ok())
    revisions = AddRevisions(tenant, data.preset_bundles, "presets", ReadBundle, archive);
  if (!revisions.ok()) return revisions;
  const auto store = data.blobs.Of(tenant);
  if (!store.ok()) return store.status();
  std::string damaged;
  if (absl::Status added = AddBlobs(*store, archive, damaged); !added.ok()) return added;
  if (!damaged.empty()) {
    if (absl::Status added = archive.AddText("not-readable.txt", damaged); !added.ok())
      return added;
  }
  return archive.End();
}

absl::StatusOr<v1::EraseTenantResponse> EraseTenant(
    const std::string& tenant, const TenantData& data, const std::function<int64_t()>& now_us,
    const CancelToken& cancel, const std::function<void(const std::string& job)>& cancelled) {
  v1::EraseTenantResponse erased;
  const auto jobs = EraseJobs(tenant, data.jobs, now_us, cancel, cancelled);
  if (!jobs.ok()) return jobs.status();
  erased.set_jobs(*jobs);
  if (absl::Status done = EraseBlobs(tenant, data, cancel, erased); !done.ok()) return done;
  const auto profiles = EraseProfiles(tenant, data.profiles, now_us());
  if (!profiles.ok()) return profiles.status();
  erased.set_profiles(*profiles);
  const auto bundles = EraseProfiles(tenant, data.preset_bundles, now_us());
  if (!bundles.ok()) return bundles.status();
  erased.set_preset_bundles(*bundles);
  return erased;
}

}  // namespace slicefarm::coordinator
