#include "services/coordinator/server/jobs_wire.h"

#include <charconv>
#include <utility>

#include "common/model/limits.h"
#include "common/wire/mesh_wire.h"
#include "common/wire/wire_error.h"

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kDefaultPageSize = 50;

/// A page ends before it; one job is less than the rest of a message (limits::kMaxSpecBytes).
constexpr size_t kMaxPageBytes = 1 << 20;

absl::StatusOr<ObjectRequest> ObjectFromProto(const v1::Object& proto) {
  const auto format = slicefarm::FromProto(proto.format());
  if (!format.ok()) return format.status();
  auto placement = slicefarm::FromProto(proto.placement());
  if (!placement.ok()) return Within("placement", placement.status());
  return ObjectRequest{proto.mesh_sha256(), proto.name(), *format, *std::move(placement)};
}

absl::StatusOr<JobState> StateFromProto(v1::JobState proto) {
  if (proto == v1::JOB_STATE_UNSPECIFIED || !v1::JobState_IsValid(proto)) {
    return Malformed("states", "is not a state of this version");
  }
  return static_cast<JobState>(static_cast<int>(proto) - 1);
}

void SetTime(int64_t us, google::protobuf::Timestamp* time) {
  time->set_seconds(us / 1'000'000);
  time->set_nanos(static_cast<int32_t>(us % 1'000'000 * 1'000));
}

v1::JobError ErrorToProto(const JobError& error) {
  v1::JobError proto;
  proto.set_code(static_cast<int>(error.code));
  proto.set_reason(error.reason);
  proto.set_message(error.message);
  proto.mutable_metadata()->insert(error.metadata.begin(), error.metadata.end());
  return proto;
}

v1::JobResult ResultToProto(const JobResult& result) {
  v1::JobResult proto;
  proto.set_gcode_sha256(result.gcode_sha256);
  proto.set_gcode_size(result.gcode_size);
  proto.set_report_sha256(result.report_sha256);
  proto.set_print_time_s(result.print_time_s);
  proto.set_filament_mm(result.filament_mm);
  proto.set_filament_g(result.filament_g);
  proto.set_layers(result.layers);
  proto.set_cached(result.cached);
  return proto;
}

/// All but the spec.
v1::Job SummaryToProto(const JobRecord& job) {
  v1::Job proto;
  proto.set_id(job.id);
  proto.set_tenant(job.tenant);
  proto.set_state(ToProto(job.state));
  proto.mutable_labels()->insert(job.labels.begin(), job.labels.end());
  SetTime(job.create_us, proto.mutable_create_time());
  if (job.start_us != 0) SetTime(job.start_us, proto.mutable_start_time());
  if (job.end_us != 0) SetTime(job.end_us, proto.mutable_end_time());
  proto.mutable_progress()->set_layers_total(job.layers_total);
  proto.mutable_progress()->set_layers_done(job.layers_done);
  if (job.error) *proto.mutable_error() = ErrorToProto(*job.error);
  proto.set_settings_digest(job.settings_digest);
  proto.set_build_id(job.build_id);
  if (!job.result) return proto;
  *proto.mutable_result() = ResultToProto(*job.result);
  proto.mutable_warnings()->Assign(job.result->warnings.begin(), job.result->warnings.end());
  return proto;
}

}  // namespace

static_assert(static_cast<int>(v1::JOB_STATE_CANCELLED) ==
              static_cast<int>(JobState::kCancelled) + 1);

absl::StatusOr<JobRequest> FromProto(const v1::JobSpec& spec) {
  JobRequest request;
  for (int i = 0; i < spec.objects_size(); ++i) {
    auto object = ObjectFromProto(spec.objects(i));
    if (!object.ok()) return Within("objects", i, object.status());
    request.objects.push_back(*std::move(object));
  }
  for (const v1::Setting& setting : spec.settings()) {
    const auto source =
        setting.from_profile() ? config::Source::kProfile : config::Source::kRequest;
    request.settings.push_back({setting.key(), setting.value(), source});
  }
  return request;
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

absl::StatusOr<ListQuery> FromProto(const v1::ListJobsRequest& request) {
  ListQuery query;
  if (request.page_size() < 0) return Malformed("page_size", "is negative");
  query.limit = request.page_size() == 0 ? kDefaultPageSize
                                         : std::min(request.page_size(), limits::kMaxPageSize);
  const std::string& token = request.page_token();
  if (!token.empty()) {
    const char* end = token.data() + token.size();
    const auto [read, error] = std::from_chars(token.data(), end, query.after_number);
    if (error != std::errc() || read != end || query.after_number < 1) {
      return Malformed("page_token", "is none that a list gave");
    }
  }
  for (const int state : request.states()) {
    const auto known = StateFromProto(static_cast<v1::JobState>(state));
    if (!known.ok()) return known.status();
    query.states.push_back(*known);
  }
  return query;
}

v1::ListJobsResponse ToProto(const std::vector<JobRecord>& jobs, const ListQuery& query) {
  v1::ListJobsResponse response;
  size_t bytes = 0;
  for (const JobRecord& job : jobs) {
    v1::Job listed = ToProto(job);
    listed.mutable_spec()->clear_settings();
    bytes += listed.ByteSizeLong();
    if (bytes > kMaxPageBytes && response.jobs_size() > 0) break;
    *response.add_jobs() = std::move(listed);
  }
  const int taken = response.jobs_size();
  if (taken == query.limit || taken < std::ssize(jobs)) {
    response.set_next_page_token(std::to_string(jobs[taken - 1].number));
  }
  return response;
}

v1::Job ToProto(const JobRecord& job) {
  v1::Job proto = SummaryToProto(job);
  proto.mutable_spec()->ParseFromString(job.spec);
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

v1::Upload ToProto(const std::string& digest, const BlobStatus& status) {
  v1::Upload proto;
  proto.set_sha256(digest);
  proto.set_committed_size(status.committed_size);
  proto.set_complete(status.complete);
  return proto;
}

}  // namespace slicefarm::coordinator
