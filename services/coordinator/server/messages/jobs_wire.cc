#include "services/coordinator/server/messages/jobs_wire.h"

#include <fmt/core.h>

#include <charconv>
#include <utility>

#include "common/base/sha256.h"
#include "common/model/limits.h"
#include "common/wire/calibration_wire.h"
#include "common/wire/options/given_settings_wire.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/mesh_wire.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/server/messages/result_wire.h"
#include "services/coordinator/server/messages/tenant_events.h"

namespace slicefarm::coordinator {
namespace {

/// Largest time of google.protobuf.Timestamp: 9999-12-31T23:59:59Z.
constexpr int64_t kMaxSeconds = 253'402'300'799;

/// Size after which a page ends. One more job is smaller than the rest of a message
/// (limits::kMaxSpecBytes).
constexpr size_t kMaxPageBytes = 1 << 20;

absl::StatusOr<JobState> StateFromProto(v1::JobState proto) {
  if (proto == v1::JOB_STATE_UNSPECIFIED || !v1::JobState_IsValid(proto)) {
    return Malformed("states", "contains a state that this version does not know");
  }
  return static_cast<JobState>(static_cast<int>(proto) - 1);
}

void SetTime(int64_t us, google::protobuf::Timestamp* time) {
  time->set_seconds(us / 1'000'000);
  time->set_nanos(static_cast<int32_t>(us % 1'000'000 * 1'000));
}

absl::Status TakeTimes(const v1::ListJobsRequest& request, ListQuery& query) {
  if (request.has_created_from()) {
    const auto from = FromProto(request.created_from());
    if (!from.ok()) return Within("created_from", from.status());
    query.created_from_us = *from;
  }
  if (request.has_created_before()) {
    const auto before = FromProto(request.created_before());
    if (!before.ok()) return Within("created_before", before.status());
    query.created_before_us = *before;
  }
  return absl::OkStatus();
}

/// Converts all fields except the spec.
v1::Job SummaryToProto(const JobRecord& job) {
  v1::Job proto;
  proto.set_id(job.id);
  proto.set_tenant(job.tenant);
  proto.set_state(ToProto(job.state));
  proto.mutable_labels()->insert(job.labels.begin(), job.labels.end());
  proto.set_priority(static_cast<v1::JobPriority>(static_cast<int>(job.priority) + 1));
  if (job.deadline_us != kNoDeadlineUs) SetTime(job.deadline_us, proto.mutable_deadline());
  SetTime(job.create_us, proto.mutable_create_time());
  if (job.start_us != 0) SetTime(job.start_us, proto.mutable_start_time());
  if (job.end_us != 0) SetTime(job.end_us, proto.mutable_end_time());
  proto.mutable_progress()->set_layers_total(job.layers_total);
  proto.mutable_progress()->set_layers_done(job.layers_done);
  if (job.error) *proto.mutable_error() = ToProto(*job.error);
  proto.set_settings_digest(job.settings_digest);
  proto.set_build_id(job.build_id);
  proto.set_cancel_requested(job.cancel_requested && !IsTerminal(job.state));
  const bool ended_run = IsTerminal(job.state) && job.start_us != 0;
  proto.set_attempts(job.retries + job.store_failures + job.lost_runs + job.deadly_runs +
                     (ended_run ? 1 : 0));
  if (job.state == JobState::kQueued && job.owner.empty() && job.owner_until_us > 0)
    SetTime(job.owner_until_us, proto.mutable_next_attempt_time());
  if (!job.result) return proto;
  *proto.mutable_result() = ToProto(*job.result);
  proto.mutable_warnings()->Assign(job.result->warnings.begin(), job.result->warnings.end());
  return proto;
}

}  // namespace

static_assert(static_cast<int>(v1::JOB_STATE_CANCELLED) ==
              static_cast<int>(JobState::kCancelled) + 1);
static_assert(static_cast<int>(v1::JOB_PRIORITY_INTERACTIVE) ==
              static_cast<int>(Priority::kInteractive) + 1);

namespace {

/// Checks that no object is a 3MF project. A project has several objects with positions of their
/// own, which ReadProject returns. If the format is not given, the project is found when it is
/// read, and the job fails.
absl::Status CheckNoProjects(const v1::JobSpec& spec) {
  for (int i = 0; i < spec.objects_size(); ++i) {
    const v1::Object& object = spec.objects(i);
    if (object.parts().empty() && object.format() == v1::MESH_FORMAT_3MF) {
      return Within(
          "objects", i,
          Malformed("format",
                    "a 3MF project is not a single mesh; call ReadProject for its objects"));
    }
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<JobRequest> FromProto(const v1::JobSpec& spec) {
  JobRequest request;
  if (!v1::JobMode_IsValid(spec.mode()))
    return Malformed("mode", "has a value that this version does not know");
  if (spec.mode() == v1::JOB_MODE_QUOTE) request.mode = JobMode::kQuote;
  if (spec.process() != v1::PROCESS_UNSPECIFIED) {
    const auto process = EnumFromProto<Process>(spec.process(), kProcessCount, "process");
    if (!process.ok()) return process.status();
    request.process = *process;
  }
  if (absl::Status no_project = CheckNoProjects(spec); !no_project.ok()) return no_project;
  auto scene = slicefarm::FromProto(spec.objects());
  if (!scene.ok()) return scene.status();
  request.scene = *std::move(scene);
  request.settings = SettingsFromProto(spec.project_settings());
  for (Setting& setting : SettingsFromProto(spec.settings()))
    request.settings.push_back(std::move(setting));
  request.without_effect.assign(spec.without_effect().begin(), spec.without_effect().end());
  for (const v1::ProjectNote& note : spec.notes()) {
    if (note.feature().empty()) {
      request.warnings.push_back(note.text());
    } else {
      request.missing.push_back({note.feature(), note.text(), {}});
    }
  }
  request.allowed.assign(spec.allow().begin(), spec.allow().end());
  request.generic = spec.generic();
  request.sources = SourcesFromProto(spec.setting_sources());
  request.calibration = slicefarm::FromProto(spec.calibration());
  return request;
}

void ClearSettings(v1::JobSpec& spec) {
  spec.clear_settings();
  spec.clear_project_settings();
  spec.clear_without_effect();
  spec.clear_notes();
  spec.clear_setting_sources();
  spec.clear_calibration();
  for (v1::Object& object : *spec.mutable_objects()) {
    object.clear_settings();
    for (v1::Part& part : *object.mutable_parts()) part.clear_settings();
    for (v1::HeightRange& range : *object.mutable_height_ranges()) range.clear_settings();
  }
}

void ClearDetails(v1::Job& job) {
  ClearSettings(*job.mutable_spec());
  if (!job.has_result()) return;
  job.mutable_result()->clear_objects();
  job.mutable_result()->clear_shared();
}

absl::StatusOr<Priority> FromProto(v1::JobPriority priority) {
  if (!v1::JobPriority_IsValid(priority)) {
    return Malformed("priority", "has a value that this version does not know");
  }
  if (priority == v1::JOB_PRIORITY_UNSPECIFIED) return Priority::kNormal;
  return static_cast<Priority>(static_cast<int>(priority) - 1);
}

absl::StatusOr<int64_t> FromProto(const google::protobuf::Timestamp& time) {
  if (time.seconds() < 0 || time.seconds() > kMaxSeconds || time.nanos() < 0 ||
      time.nanos() >= 1'000'000'000) {
    return Malformed("time", "is not between 1970 and 9999");
  }
  return time.seconds() * 1'000'000 + time.nanos() / 1'000;
}

std::string SpecBytes(const v1::JobSpec& spec) { return spec.SerializeAsString(); }

absl::StatusOr<JobRequest> ReadSpec(const std::string& bytes) {
  v1::JobSpec spec;
  if (!spec.ParseFromString(bytes)) return Malformed("spec", "cannot be read");
  return FromProto(spec);
}

v1::JobState ToProto(JobState state) {
  return static_cast<v1::JobState>(static_cast<int>(state) + 1);
}

v1::JobError ToProto(const JobError& error) {
  v1::JobError proto;
  proto.set_code(static_cast<int>(error.code));
  proto.set_reason(error.reason);
  proto.set_message(error.message);
  proto.mutable_metadata()->insert(error.metadata.begin(), error.metadata.end());
  return proto;
}

v1::Preflight ToProto(const Preflight& preflight, const Cost& cost) {
  v1::Preflight proto;
  for (const MeshReport& mesh : preflight.meshes) *proto.add_meshes() = slicefarm::ToProto(mesh);
  proto.set_layers(preflight.layers);
  proto.set_first_layer_area_mm2(preflight.first_layer_area_mm2);
  proto.set_print_time_s(preflight.print_time_s);
  proto.set_filament_mm(preflight.filament.length_mm);
  proto.set_filament_g(preflight.filament.mass_g);
  *proto.mutable_cost() = ToProto(cost);
  for (const OrientationAdvice& advice : preflight.orientations)
    *proto.add_orientations() = slicefarm::ToProto(advice);
  return proto;
}

namespace {

/// Returns the token of the page after the job of this number, in a list with these conditions.
std::string PageToken(int64_t number, const ListQuery& query) {
  std::string text =
      fmt::format("{} {} {} {}", query.oldest_first, query.created_from_us, query.created_before_us,
                  query.priority ? static_cast<int>(*query.priority) : -1);
  for (const JobState state : query.states) text += fmt::format(" {}", static_cast<int>(state));
  for (const auto& [key, value] : query.labels)
    text += fmt::format(" {}:{} {}:{}", key.size(), key, value.size(), value);
  constexpr size_t kDigits = 16;
  return fmt::format("{}-{}", number, Sha256Hex(text).substr(0, kDigits));
}

absl::Status TakePageToken(const std::string& token, ListQuery& query) {
  if (token.empty()) return absl::OkStatus();
  const char* end = token.data() + token.size();
  const auto error = std::from_chars(token.data(), end, query.after_number).ec;
  const bool is_of_this = error == std::errc() && query.after_number > 0 &&
                          token == PageToken(query.after_number, query);
  return is_of_this
             ? absl::OkStatus()
             : Malformed("page_token", "is not from an answer to a request with the same filters");
}

}  // namespace

absl::StatusOr<ListQuery> FromProto(const v1::ListJobsRequest& request) {
  ListQuery query;
  if (request.page_size() < 0) return Malformed("page_size", "is negative");
  query.limit = request.page_size() == 0 ? kDefaultPageSize
                                         : std::min(request.page_size(), limits::kMaxPageSize);
  for (const int state : request.states()) {
    const auto known = StateFromProto(static_cast<v1::JobState>(state));
    if (!known.ok()) return known.status();
    if (std::ranges::find(query.states, *known) == query.states.end())
      query.states.push_back(*known);
  }
  query.labels = {request.labels().begin(), request.labels().end()};
  if (absl::Status ok = CheckLabels(query.labels); !ok.ok()) return ok;
  query.oldest_first = request.oldest_first();
  if (request.has_tenant()) query.tenant = request.tenant();
  if (request.priority() != v1::JOB_PRIORITY_UNSPECIFIED) {
    const auto priority = FromProto(request.priority());
    if (!priority.ok()) return priority.status();
    query.priority = *priority;
  }
  if (absl::Status taken = TakeTimes(request, query); !taken.ok()) return taken;
  if (absl::Status taken = TakePageToken(request.page_token(), query); !taken.ok()) return taken;
  return query;
}

absl::StatusOr<JobChanging> FromProto(const v1::UpdateJobRequest& request) {
  JobChanging changing;
  if (request.update_mask().paths().empty()) return Malformed("update_mask", "names nothing");
  for (const std::string& path : request.update_mask().paths()) {
    if (path == "priority") {
      const auto priority = FromProto(request.priority());
      if (!priority.ok()) return priority.status();
      changing.priority = *priority;
    } else if (path == "deadline") {
      changing.deadline_us = kNoDeadlineUs;
      if (!request.has_deadline()) continue;
      const auto deadline_us = FromProto(request.deadline());
      if (!deadline_us.ok()) return Within("deadline", deadline_us.status());
      changing.deadline_us = *deadline_us;
    } else if (path == "labels") {
      changing.labels.emplace(request.labels().begin(), request.labels().end());
      if (absl::Status ok = CheckLabels(*changing.labels); !ok.ok()) return ok;
    } else {
      return Malformed("update_mask", "names a field that cannot be changed");
    }
  }
  return changing;
}

v1::ListJobsResponse ToProto(const std::vector<JobRecord>& jobs, const ListQuery& query) {
  v1::ListJobsResponse response;
  size_t bytes = 0;
  int64_t read_bytes = 0;
  for (const JobRecord& job : jobs) read_bytes += std::ssize(job.spec);
  for (const JobRecord& job : jobs) {
    v1::Job listed = ToProto(job);
    ClearDetails(listed);
    bytes += listed.ByteSizeLong();
    if (bytes > kMaxPageBytes && response.jobs_size() > 0) break;
    *response.add_jobs() = std::move(listed);
  }
  const int taken = response.jobs_size();
  if (taken == query.limit || taken < std::ssize(jobs) || read_bytes >= kListedSpecBytes) {
    response.set_next_page_token(PageToken(jobs[taken - 1].number, query));
  }
  return response;
}

v1::Job ToProto(const JobRecord& job) {
  v1::Job proto = SummaryToProto(job);
  proto.mutable_spec()->ParseFromString(job.spec);
  if (job.result) AddShares(*job.result, *proto.mutable_result());
  return proto;
}

v1::JobEvent ToProto(const JobEventRecord& event, const JobRecord& job) {
  JobRecord then = job;
  then.state = event.state;
  then.layers_total = event.layers_total;
  then.layers_done = event.layers_done;
  if (event.time_us < job.start_us) then.start_us = 0;
  if (!IsTerminal(event.state)) {
    then.end_us = 0;
    then.error.reset();
    then.result.reset();
  }
  v1::JobEvent proto;
  proto.set_sequence(event.sequence);
  SetTime(event.time_us, proto.mutable_time());
  *proto.mutable_job() = SummaryToProto(then);
  return proto;
}

absl::StatusOr<int64_t> WatchedFrom(const v1::WatchJobsRequest& request, int64_t now_us) {
  if (!request.cursor().empty()) {
    const auto time_us = TimeOfCursor(request.cursor());
    if (!time_us) return Malformed("cursor", "is not a cursor of an answer");
    return *time_us;
  }
  if (!request.has_from()) return now_us;
  auto from_us = FromProto(request.from());
  return from_us.ok() ? from_us : Within("from", from_us.status());
}

v1::Webhook ToProto(const WebhookRecord& webhook) {
  v1::Webhook proto;
  proto.set_url(webhook.url);
  proto.set_state(static_cast<v1::Webhook::State>(static_cast<int>(webhook.state) + 1));
  if (webhook.state == WebhookState::kDue) SetTime(webhook.due_us, proto.mutable_next_time());
  for (const WebhookAttempt& attempt : webhook.attempts) {
    v1::Webhook::Attempt& each = *proto.add_attempts();
    SetTime(attempt.time_us, each.mutable_time());
    each.set_http_status(attempt.http_status);
    each.set_error(attempt.error);
  }
  return proto;
}

v1::Upload ToProto(const std::string& digest, const BlobStatus& status) {
  v1::Upload proto;
  proto.set_sha256(digest);
  proto.set_committed_size(status.committed_size);
  proto.set_complete(status.complete);
  return proto;
}

}  // namespace slicefarm::coordinator
