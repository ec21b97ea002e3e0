#include <fmt/core.h>
#include <google/protobuf/util/time_util.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/base/duration_text.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/farm/job_outcome.h"
#include "services/cli/farm/jobs_client.h"
#include "services/cli/farm/json_text.h"
#include "services/cli/farm/queue_text.h"
#include "services/cli/farm/server_options.h"
#include "services/cli/farm/watch_bar.h"
#include "services/cli/job/summary.h"

namespace slicefarm::cli {
namespace {

constexpr int kPageSize = 100;
constexpr size_t kCancelledAtOnce = 1000;  // maximum of one call

struct JobCommandOptions {
  ServerOptions server;
  std::string id;
  bool json = false;
};

struct CancelOptions {
  ServerOptions server;
  std::vector<std::string> ids;
  bool json = false;
};

struct GetOptions : JobCommandOptions {
  ResultFiles files;
};

struct ListOptions : JobCommandOptions {
  int limit = 50;
  std::vector<std::string> states;
  std::vector<std::string> labels;
  bool oldest_first = false;
};

std::shared_ptr<JobCommandOptions> AddJobCommand(CLI::App& command,
                                                 std::shared_ptr<JobCommandOptions> options) {
  command
      .add_option("JOB", options->id,
                  "Job id, as printed by submit and list, or the beginning of it")
      ->required();
  AddServerOptions(command, options->server);
  return options;
}

std::string ProgressText(const v1::Job& job) {
  if (job.progress().layers_total() == 0) return "-";
  return fmt::format("{}/{}", job.progress().layers_done(), job.progress().layers_total());
}

std::string OrDash(std::string text) { return text.empty() ? "-" : text; }

std::string FirstObjectName(const v1::Job& job) {
  return job.spec().objects().empty() ? "-" : OrDash(job.spec().objects(0).name());
}

/// Returns the printer preset and the profiles of a job, such as "MK4S,mk4s@3,petg@1".
std::string ProfilesOf(const v1::Job& job) {
  std::string text = job.spec().presets().printer();
  for (const std::string& profile : job.spec().profiles())
    text += (text.empty() ? "" : ",") + profile;
  return OrDash(std::move(text));
}

/// Returns the labels of a job by key, such as "order=17,shelf=4".
std::string LabelsOf(const v1::Job& job) {
  const std::map<std::string, std::string> sorted(job.labels().begin(), job.labels().end());
  std::string text;
  for (const auto& [key, value] : sorted)
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", key, value);
  return OrDash(std::move(text));
}

/// Values of one job in a list.
struct Row {
  std::string id, state, place, layers, done, created, time, cost, profiles, labels, model;
};

std::string TextOf(const Row& row) {
  return fmt::format(
      "{:<32}  {:<9}  {:>5}  {:>11}  {:<16}  {:<20}  {:>11}  {:>10}  {:<16}  {:<16}  {}\n", row.id,
      row.state, row.place, row.layers, row.done, row.created, row.time, row.cost, row.profiles,
      row.labels, row.model);
}

Row RowOf(const v1::Job& job) {
  google::protobuf::Timestamp created = job.create_time();
  created.set_nanos(0);
  const v1::JobResult& result = job.result();
  return {.id = job.id(),
          .state = StateName(job.state()),
          .place = job.queue_position() == 0 ? "-" : fmt::format("{}", job.queue_position()),
          .layers = ProgressText(job),
          .done = OrDash(EndText(job, std::chrono::system_clock::now())),
          .created = google::protobuf::util::TimeUtil::ToString(created),
          .time = job.has_result() ? DurationText(result.print_time_s()) : "-",
          .cost = OrDash(MoneyText(result.cost().total(), result.cost().currency())),
          .profiles = ProfilesOf(job),
          .labels = LabelsOf(job),
          .model = FirstObjectName(job)};
}

ExitCode Watch(const JobCommandOptions& options, Interrupt& interrupt) {
  const JobsClientOptions connection = ClientOptions(options.server, &interrupt);
  JobsClient client(connection);
  const auto id = client.FullId(options.id);
  if (!id.ok()) return Fail(id.status());
  WatchBar bar(true, connection, *id);
  const auto job = client.WatchJob(*id, [&](const v1::Job& event) { bar.Show(event); });
  bar.Clear();
  if (!job.ok()) return Fail(job.status());
  Warn({job->warnings().begin(), job->warnings().end()});
  if (options.json) Print(JsonOfJob(*job, "") + "\n");
  if (!OutcomeOf(*job).ok()) return FailJob(*job);
  if (options.json) return ExitCode::kOk;
  Print(fmt::format("job {} succeeded; `slicefarm get {} -o OUT.gcode` fetches its result\n",
                    job->id(), job->id()));
  return ExitCode::kOk;
}

ExitCode Get(const GetOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto id = client.FullId(options.id);
  if (!id.ok()) return Fail(id.status());
  const auto job = client.GetJob(*id);
  if (!job.ok()) return Fail(job.status());
  if (options.files.gcode.empty() && options.files.report.empty()) {
    Print(IndentedJson(*job));
    return ExitCode::kOk;
  }
  if (!OutcomeOf(*job).ok()) return FailJob(*job);
  const absl::Status fetched = FetchResults(client, *job, options.files).status();
  return fetched.ok() ? ExitCode::kOk : Fail(fetched);
}

/// Fetches the trace of a job that ended, with any result.
ExitCode Trace(const GetOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto id = client.FullId(options.id);
  if (!id.ok()) return Fail(id.status());
  v1::Job job;
  job.set_id(*id);
  const absl::Status fetched = FetchResults(client, job, options.files).status();
  return fetched.ok() ? ExitCode::kOk : Fail(fetched);
}

void PrintCancelled(const CancelOptions& options, const v1::Job& job) {
  if (options.json) return Print(JsonOfJob(job, "") + "\n");
  Print(fmt::format("job {}: {}\n", job.id(),
                    HasEnded(job) ? StateName(job.state()) : "is being cancelled"));
}

/// Cancels the jobs independently: an error for one job does not affect the rest. Returns the exit
/// code of the first error.
ExitCode CancelAll(JobsClient& client, const CancelOptions& options) {
  const std::vector<std::string>& ids = options.ids;
  ExitCode code = ExitCode::kOk;
  for (size_t first = 0; first < ids.size(); first += kCancelledAtOnce) {
    v1::BatchCancelJobsRequest request;
    for (size_t i = first; i < std::min(ids.size(), first + kCancelledAtOnce); ++i)
      request.add_ids(ids[i]);
    const auto done = client.CancelJobs(request);
    if (!done.ok()) return Fail(done.status());
    for (const auto& outcome : done->outcomes()) {
      if (outcome.has_job()) {
        PrintCancelled(options, outcome.job());
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

ExitCode Cancel(CancelOptions options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  for (std::string& each : options.ids) {
    auto id = client.FullId(each);
    if (!id.ok()) return Fail(id.status());
    each = *std::move(id);
  }
  if (options.ids.size() > 1) return CancelAll(client, options);
  const auto job = client.CancelJob(options.ids.front());
  if (!job.ok()) return Fail(job.status());
  PrintCancelled(options, *job);
  return ExitCode::kOk;
}

ExitCode Delete(const JobCommandOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto id = client.FullId(options.id);
  if (!id.ok()) return Fail(id.status());
  const absl::Status deleted = client.DeleteJob(*id);
  return deleted.ok() ? ExitCode::kOk : Fail(deleted);
}

ExitCode Webhook(const JobCommandOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto id = client.FullId(options.id);
  if (!id.ok()) return Fail(id.status());
  const auto webhook = client.GetWebhook(*id);
  if (!webhook.ok()) return Fail(webhook.status());
  Print(IndentedJson(*webhook));
  return ExitCode::kOk;
}

v1::JobState StateOf(const std::string& name) {
  for (const v1::JobState state : {v1::JOB_STATE_QUEUED, v1::JOB_STATE_RUNNING,
                                   v1::JOB_STATE_SUCCEEDED, v1::JOB_STATE_FAILED}) {
    if (StateName(state) == name) return state;
  }
  return v1::JOB_STATE_CANCELLED;
}

/// Returns all requested jobs, page by page.
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
    Print(IndentedJson(*all));
    return ExitCode::kOk;
  }
  std::string text = TextOf({"JOB", "STATE", "PLACE", "LAYERS", "DONE", "CREATED", "PRINT TIME",
                             "COST", "PROFILES", "LABELS", "MODEL"});
  for (const v1::Job& job : all->jobs()) text += TextOf(RowOf(job));
  if (!all->next_page_token().empty()) text += "there are more jobs: use a larger --limit N\n";
  Print(text);
  Warn(WaitsOf(all->jobs()));
  return ExitCode::kOk;
}

}  // namespace

void AddWatch(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("watch", "Wait until a job has ended");
  const auto options = AddJobCommand(*command, std::make_shared<JobCommandOptions>());
  command->add_flag("--json", options->json, "Print the job as one line of JSON when it has ended");
  command->footer(
      "While the job waits, a terminal shows its position in the queue and its expected end.\nThe "
      "exit code is that of the job's outcome. Ctrl-C ends only this command; the job continues.");
  command->callback([options, &context] {
    context.run = [options, &context] { return Watch(*options, *context.interrupt); };
  });
}

void AddList(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("list", "List jobs, newest first");
  const auto options = std::make_shared<ListOptions>();
  command->add_option("--limit", options->limit, "Largest number of jobs to list")
      ->check(InRange(1, 100'000))
      ->capture_default_str()
      ->type_name("N");
  command->add_option("--state", options->states, "State of the jobs to list; may be repeated")
      ->check(
          OneOf(std::vector<std::string>{"queued", "running", "succeeded", "failed", "cancelled"}))
      ->allow_extra_args(false);
  command->add_option("--label", options->labels, "Label of the jobs to list; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--oldest-first", options->oldest_first, "List the oldest jobs first");
  command->add_flag("--json", options->json, "Print all fields of the jobs as JSON");
  command->footer(
      "PLACE: position of a waiting job in the queue of the whole farm; 1 starts next. DONE: "
      "expected\nend of a job, estimated from its layers, or from its position and the duration of "
      "other jobs.");
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
                   "File for the G-code; -: to stdout; a folder: a file in it, named by "
                   "output_filename_format")
      ->type_name("OUT.gcode");
  command->add_option("--report", options->files.report, "File for the report; -: to stdout")
      ->type_name("REPORT.json");
  command->footer(
      "Without -o and --report, prints all fields of the job as JSON; for a waiting job "
      "also\nqueue_position and estimated_end_time.");
  command->callback([options, &context] {
    context.run = [options, &context] { return Get(*options, *context.interrupt); };
  });
}

void AddCancel(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("cancel", "Cancel jobs; their records are kept");
  const auto options = std::make_shared<CancelOptions>();
  command
      ->add_option("JOB", options->ids,
                   "Job ids, as printed by submit and list, or the beginnings of them")
      ->required();
  command->add_flag("--json", options->json, "Print each job as one line of JSON");
  AddServerOptions(*command, options->server);
  command->callback([options, &context] {
    context.run = [options, &context] { return Cancel(*options, *context.interrupt); };
  });
}

void AddDelete(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("delete", "Remove an ended job with its results");
  const auto options = AddJobCommand(*command, std::make_shared<JobCommandOptions>());
  command->callback([options, &context] {
    context.run = [options, &context] { return Delete(*options, *context.interrupt); };
  });
}

void AddWebhook(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("webhook", "Show each delivery attempt of a job's webhook, as JSON");
  const auto options = AddJobCommand(*command, std::make_shared<JobCommandOptions>());
  command->callback([options, &context] {
    context.run = [options, &context] { return Webhook(*options, *context.interrupt); };
  });
}

void AddTrace(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand(
      "trace", "Write a timeline of an ended job, which shows the time of each stage");
  const auto options = std::make_shared<GetOptions>();
  options->files.trace = "-";
  AddJobCommand(*command, options);
  command->add_option("-o,--output", options->files.trace, "File for the trace; -: to stdout")
      ->capture_default_str()
      ->type_name("TRACE.json");
  command->footer(
      "The trace has Chrome's trace event format: open it at https://ui.perfetto.dev or "
      "chrome://tracing.\nEach worker is a process in it; a layer range that was repeated has "
      "several attempts.");
  command->callback([options, &context] {
    context.run = [options, &context] { return Trace(*options, *context.interrupt); };
  });
}

}  // namespace slicefarm::cli
