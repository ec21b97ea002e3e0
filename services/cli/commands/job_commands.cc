#include <fmt/core.h>
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/time_util.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "services/cli/commands/commands.h"
#include "services/cli/console.h"
#include "services/cli/jobs_client.h"
#include "services/cli/server_options.h"

namespace slicefarm::cli {
namespace {

constexpr int kPageSize = 100;
constexpr size_t kCancelledAtOnce = 1000;  // the most that a call takes

struct JobCommandOptions {
  ServerOptions server;
  std::string id;
};

struct CancelOptions {
  ServerOptions server;
  std::vector<std::string> ids;
};

struct GetOptions : JobCommandOptions {
  ResultFiles files;
};

struct ListOptions : JobCommandOptions {
  int limit = 50;
  std::vector<std::string> states;
  std::vector<std::string> labels;
  bool oldest_first = false;
  bool json = false;
};

std::shared_ptr<JobCommandOptions> AddJobCommand(CLI::App& command,
                                                 std::shared_ptr<JobCommandOptions> options) {
  command.add_option("JOB", options->id, "As submit --detach and list print it")->required();
  AddServerOptions(command, options->server);
  return options;
}

std::string ToJson(const google::protobuf::Message& message) {
  google::protobuf::util::JsonPrintOptions print;
  print.add_whitespace = true;
  print.preserve_proto_field_names = true;
  std::string json;
  const auto status = google::protobuf::util::MessageToJsonString(message, &json, print);
  return status.ok() ? json : "{}\n";
}

std::string ProgressText(const v1::Job& job) {
  if (job.progress().layers_total() == 0) return "-";
  return fmt::format("{}/{}", job.progress().layers_done(), job.progress().layers_total());
}

std::string FirstObjectName(const v1::Job& job) {
  return job.spec().objects().empty() ? "-" : job.spec().objects(0).name();
}

ExitCode Watch(const JobCommandOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  ProgressBar bar(true);
  const auto job =
      client.WatchJob(options.id, [&](const v1::Job& event) { ShowProgress(bar, event); });
  bar.Clear();
  if (!job.ok()) return Fail(job.status());
  Warn({job->warnings().begin(), job->warnings().end()});
  if (!OutcomeOf(*job).ok()) return FailJob(*job);
  Print(fmt::format("job {} succeeded; `slicefarm get {} -o OUT.gcode` fetches it\n", job->id(),
                    job->id()));
  return ExitCode::kOk;
}

ExitCode Get(const GetOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto job = client.GetJob(options.id);
  if (!job.ok()) return Fail(job.status());
  if (options.files.gcode.empty() && options.files.report.empty()) {
    Print(ToJson(*job));
    return ExitCode::kOk;
  }
  if (!OutcomeOf(*job).ok()) return FailJob(*job);
  const absl::Status fetched = FetchResults(client, *job, options.files);
  return fetched.ok() ? ExitCode::kOk : Fail(fetched);
}

/// Of any job that ended, however it ended.
ExitCode Trace(const GetOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  v1::Job job;
  job.set_id(options.id);
  const absl::Status fetched = FetchResults(client, job, options.files);
  return fetched.ok() ? ExitCode::kOk : Fail(fetched);
}

void TellCancelled(const v1::Job& job) {
  Print(fmt::format("job {}: {}\n", job.id(),
                    HasEnded(job) ? StateName(job.state()) : "is being cancelled"));
}

/// Each by itself: one that cannot be cancelled leaves the others alone. The exit code is that of
/// the first error.
ExitCode CancelAll(JobsClient& client, const std::vector<std::string>& ids) {
  ExitCode code = ExitCode::kOk;
  for (size_t first = 0; first < ids.size(); first += kCancelledAtOnce) {
    v1::BatchCancelJobsRequest request;
    for (size_t i = first; i < std::min(ids.size(), first + kCancelledAtOnce); ++i)
      request.add_ids(ids[i]);
    const auto done = client.CancelJobs(request);
    if (!done.ok()) return Fail(done.status());
    for (const auto& outcome : done->outcomes()) {
      if (outcome.has_job()) {
        TellCancelled(outcome.job());
        continue;
      }
      v1::Job failed;
      failed.set_state(v1::JOB_STATE_FAILED);
      *failed.mutable_error() = outcome.error();
      const ExitCode error = Fail(OutcomeOf(failed));
      if (code == ExitCode::kOk) code = error;
    }
  }
  return code;
}

ExitCode Cancel(const CancelOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  if (options.ids.size() > 1) return CancelAll(client, options.ids);
  const auto job = client.CancelJob(options.ids.front());
  if (!job.ok()) return Fail(job.status());
  TellCancelled(*job);
  return ExitCode::kOk;
}

ExitCode Delete(const JobCommandOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  const absl::Status deleted = client.DeleteJob(options.id);
  return deleted.ok() ? ExitCode::kOk : Fail(deleted);
}

ExitCode Webhook(const JobCommandOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto webhook = client.GetWebhook(options.id);
  if (!webhook.ok()) return Fail(webhook.status());
  Print(ToJson(*webhook));
  return ExitCode::kOk;
}

v1::JobState StateOf(const std::string& name) {
  for (const v1::JobState state : {v1::JOB_STATE_QUEUED, v1::JOB_STATE_RUNNING,
                                   v1::JOB_STATE_SUCCEEDED, v1::JOB_STATE_FAILED}) {
    if (StateName(state) == name) return state;
  }
  return v1::JOB_STATE_CANCELLED;
}

/// Page by page, as many as are asked for.
absl::StatusOr<v1::ListJobsResponse> ListAll(JobsClient& client, const ListOptions& options) {
  v1::ListJobsRequest request;
  for (const std::string& state : options.states) request.add_states(StateOf(state));
  const auto labels = ReadLabels(options.labels);
  if (!labels.ok()) return labels.status();
  request.mutable_labels()->insert(labels->begin(), labels->end());
  request.set_oldest_first(options.oldest_first);
  v1::ListJobsResponse all;
  do {
    request.set_page_size(std::min(kPageSize, options.limit - all.jobs_size()));
    auto page = client.ListJobs(request);
    if (!page.ok()) return page.status();
    request.set_page_token(page->next_page_token());
    all.MergeFrom(*page);
    all.set_next_page_token(page->next_page_token());
  } while (!request.page_token().empty() && all.jobs_size() < options.limit);
  return all;
}

ExitCode List(const ListOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto all = ListAll(client, options);
  if (!all.ok()) return Fail(all.status());
  if (options.json) {
    Print(ToJson(*all));
    return ExitCode::kOk;
  }
  std::string text = fmt::format("{:<36}  {:<9}  {:>11}  {:<20}  {}\n", "JOB", "STATE", "LAYERS",
                                 "CREATED", "MODEL");
  for (const v1::Job& job : all->jobs()) {
    google::protobuf::Timestamp created = job.create_time();
    created.set_nanos(0);
    text += fmt::format("{:<36}  {:<9}  {:>11}  {:<20}  {}\n", job.id(), StateName(job.state()),
                        ProgressText(job), google::protobuf::util::TimeUtil::ToString(created),
                        FirstObjectName(job));
  }
  if (!all->next_page_token().empty()) text += "there are more: --limit N\n";
  Print(text);
  Warn(WaitsOf(all->jobs()));
  return ExitCode::kOk;
}

}  // namespace

void AddWatch(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("watch", "Wait for the end of a job");
  const auto options = AddJobCommand(*command, std::make_shared<JobCommandOptions>());
  command->footer("Exit code as the job's outcome. Ctrl-C stops the watching; the job goes on.");
  command->callback([options, &context] {
    context.run = [options, &context] { return Watch(*options, *context.interrupt); };
  });
}

void AddList(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("list", "List jobs, newest first");
  const auto options = std::make_shared<ListOptions>();
  command->add_option("--limit", options->limit, "How many at most")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str()
      ->type_name("N");
  command->add_option("--state", options->states, "Only jobs in this state. May be repeated")
      ->check(CLI::IsMember({"queued", "running", "succeeded", "failed", "cancelled"}))
      ->allow_extra_args(false);
  command->add_option("--label", options->labels, "Only jobs with this label. May be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--oldest-first", options->oldest_first);
  command->add_flag("--json", options->json, "All that is known of them, as JSON");
  AddServerOptions(*command, options->server);
  command->callback([options, &context] {
    context.run = [options, &context] { return List(*options, *context.interrupt); };
  });
}

void AddGet(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("get", "Fetch the results of a job, or show the job");
  const auto options = std::make_shared<GetOptions>();
  AddJobCommand(*command, options);
  command
      ->add_option("-o,--output", options->files.gcode,
                   "Where the G-code goes; -: to stdout; a folder: a file there, called as "
                   "output_filename_format says")
      ->type_name("OUT.gcode");
  command->add_option("--report", options->files.report, "Where the report goes; -: to stdout")
      ->type_name("REPORT.json");
  command->footer("Without -o and --report, all that is known of the job, as JSON.");
  command->callback([options, &context] {
    context.run = [options, &context] { return Get(*options, *context.interrupt); };
  });
}

void AddCancel(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("cancel", "Stop jobs; their records stay");
  const auto options = std::make_shared<CancelOptions>();
  command->add_option("JOB", options->ids, "As submit --detach and list print them")->required();
  AddServerOptions(*command, options->server);
  command->callback([options, &context] {
    context.run = [options, &context] { return Cancel(*options, *context.interrupt); };
  });
}

void AddDelete(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("delete", "Remove a job that ended, with its results");
  const auto options = AddJobCommand(*command, std::make_shared<JobCommandOptions>());
  command->callback([options, &context] {
    context.run = [options, &context] { return Delete(*options, *context.interrupt); };
  });
}

void AddWebhook(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("webhook", "Show what became of a job's webhook: each try, as JSON");
  const auto options = AddJobCommand(*command, std::make_shared<JobCommandOptions>());
  command->callback([options, &context] {
    context.run = [options, &context] { return Webhook(*options, *context.interrupt); };
  });
}

void AddTrace(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("trace", "Show where the time of a job that ended went");
  const auto options = std::make_shared<GetOptions>();
  options->files.trace = "-";
  AddJobCommand(*command, options);
  command->add_option("-o,--output", options->files.trace, "Where the trace goes; -: to stdout")
      ->capture_default_str()
      ->type_name("TRACE.json");
  command->footer(
      "In Chrome's trace event format: open it at https://ui.perfetto.dev or chrome://tracing.\n"
      "Each worker is a process of its own; a range that was done again has several attempts.");
  command->callback([options, &context] {
    context.run = [options, &context] { return Trace(*options, *context.interrupt); };
  });
}

}  // namespace slicefarm::cli
