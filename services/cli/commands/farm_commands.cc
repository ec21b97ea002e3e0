// Commands about a caller's data on a farm besides single jobs: all events, meshes, stored results.
#include <fmt/core.h>
#include <google/protobuf/util/time_util.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/console/files.h"
#include "services/cli/farm/jobs_client.h"
#include "services/cli/farm/json_text.h"
#include "services/cli/farm/server_options.h"
#include "services/cli/job/summary.h"

namespace slicefarm::cli {
namespace {

using google::protobuf::util::TimeUtil;

struct FarmOptions {
  ServerOptions server;
  std::string tenant;
  std::string cursor;
  std::string from;
  int64_t count = 0;
  bool json = false;
  std::string sha256;
  std::string output;
};

struct ArtifactOptions {
  ServerOptions server;
  std::string id;
  std::string kind;
  std::string output = "-";
};

struct UpdateOptions {
  ServerOptions server;
  std::string id;
  std::string priority;
  std::string deadline;
  std::vector<std::string> labels;
  bool json = false;
};

absl::Status BadTime(const std::string& option, const std::string& text) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   fmt::format("{}: {} is not a time such as 2027-01-31T12:00:00Z", option, text));
}

ExitCode WatchAll(const FarmOptions& options, Interrupt& interrupt) {
  v1::WatchJobsRequest request;
  request.set_cursor(options.cursor);
  if (!options.tenant.empty()) request.set_tenant(options.tenant);
  if (!options.from.empty() && !TimeUtil::FromString(options.from, request.mutable_from()))
    return Fail(BadTime("--from", options.from));
  JobsClient client(ClientOptions(options.server, &interrupt));
  int64_t printed = 0;
  const absl::Status ended = client.WatchJobs(request, [&](const v1::WatchJobsResponse& response) {
    if (!response.has_event()) return absl::OkStatus();
    const v1::JobEvent& event = response.event();
    Print(options.json
              ? JsonLine(response) + "\n"
              : fmt::format("{}  {}  {:>4}  {}\n", TimeUtil::ToString(event.time()),
                            event.job().id(), event.sequence(), StateName(event.job().state())));
    return ++printed == options.count ? absl::OutOfRangeError("as many as --count says")
                                      : absl::OkStatus();
  });
  return absl::IsOutOfRange(ended) ? ExitCode::kOk : Fail(ended);
}

ExitCode ShowUsage(const FarmOptions& options, Interrupt& interrupt) {
  v1::GetUsageRequest request;
  if (!options.tenant.empty()) request.set_tenant(options.tenant);
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto usage = client.GetUsage(request);
  if (!usage.ok()) return Fail(usage.status());
  Print(JsonLine(*usage) + "\n");
  return ExitCode::kOk;
}

ExitCode ShowCaller(const FarmOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto caller = client.GetCaller();
  if (!caller.ok()) return Fail(caller.status());
  Print(JsonLine(*caller) + "\n");
  return ExitCode::kOk;
}

ExitCode ListMeshes(const FarmOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  v1::ListMeshesRequest request;
  request.set_page_size(1000);
  std::string text =
      fmt::format("{:<64}  {:>12}  {:<9}  {}\n", "MESH", "BYTES", "COMPLETE", "IDLE");
  if (options.json) text.clear();
  do {
    const auto page = client.ListMeshes(request);
    if (!page.ok()) return Fail(page.status());
    for (const auto& mesh : page->meshes()) {
      if (options.json) text += JsonLine(mesh) + "\n";
      if (options.json) continue;
      text += fmt::format("{}  {:>12}  {:<9}  {} s\n", mesh.sha256(), mesh.size(),
                          mesh.complete() ? "yes" : "no", mesh.idle_s());
    }
    request.set_page_token(page->next_page_token());
  } while (!request.page_token().empty());
  Print(text);
  return ExitCode::kOk;
}

ExitCode GetMesh(const FarmOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  auto file = OutputFile::Create(options.output);
  if (!file.ok()) return Fail(file.status());
  absl::Status fetched = client.DownloadMesh(options.sha256, *file);
  if (fetched.ok()) fetched = file->Commit();
  return fetched.ok() ? ExitCode::kOk : Fail(fetched);
}

ExitCode DeleteMesh(const FarmOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto deleted = client.DeleteMesh(options.sha256);
  if (!deleted.ok()) return Fail(deleted.status());
  Print(*deleted ? "deleted\n" : "not deleted: a job uses the mesh, or there is no such mesh\n");
  return ExitCode::kOk;
}

absl::StatusOr<v1::UpdateJobRequest> UpdateOf(const UpdateOptions& options) {
  v1::UpdateJobRequest request;
  request.set_id(options.id);
  if (!options.priority.empty()) {
    request.set_priority(options.priority == "interactive" ? v1::JOB_PRIORITY_INTERACTIVE
                         : options.priority == "bulk"      ? v1::JOB_PRIORITY_BULK
                                                           : v1::JOB_PRIORITY_NORMAL);
    request.mutable_update_mask()->add_paths("priority");
  }
  if (!options.deadline.empty()) {
    request.mutable_update_mask()->add_paths("deadline");
    if (options.deadline != "none" &&
        !TimeUtil::FromString(options.deadline, request.mutable_deadline()))
      return BadTime("--deadline", options.deadline);
  }
  if (!options.labels.empty()) {
    const auto labels = ReadLabels(options.labels);
    if (!labels.ok()) return labels.status();
    request.mutable_labels()->insert(labels->begin(), labels->end());
    request.mutable_update_mask()->add_paths("labels");
  }
  return request;
}

ExitCode UpdateJob(const UpdateOptions& options, Interrupt& interrupt) {
  auto request = UpdateOf(options);
  if (!request.ok()) return Fail(request.status());
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto id = client.FullId(options.id);
  if (!id.ok()) return Fail(id.status());
  request->set_id(*id);
  const auto job = client.UpdateJob(*request);
  if (!job.ok()) return Fail(job.status());
  if (options.json) {
    Print(JsonOfJob(*job, "") + "\n");
    return ExitCode::kOk;
  }
  Print(fmt::format("job {}: {}\n", job->id(), StateName(job->state())));
  return ExitCode::kOk;
}

/// Names of --kind.
const std::map<std::string, v1::Artifact> kArtifacts = {{"gcode", v1::ARTIFACT_GCODE},
                                                        {"report", v1::ARTIFACT_REPORT},
                                                        {"trace", v1::ARTIFACT_TRACE},
                                                        {"layers", v1::ARTIFACT_LAYERS},
                                                        {"thumbnail", v1::ARTIFACT_THUMBNAIL}};

ExitCode ShowArtifacts(const ArtifactOptions& options, Interrupt& interrupt) {
  JobsClient client(ClientOptions(options.server, &interrupt));
  const auto id = client.FullId(options.id);
  if (!id.ok()) return Fail(id.status());
  if (options.kind.empty()) {
    const auto list = client.ListArtifacts(*id);
    if (!list.ok()) return Fail(list.status());
    Print(JsonLine(*list) + "\n");
    return ExitCode::kOk;
  }
  auto file = OutputFile::Create(options.output);
  if (!file.ok()) return Fail(file.status());
  v1::Job job;
  job.set_id(*id);
  absl::Status fetched = client.Download(job, kArtifacts.at(options.kind), *file);
  if (fetched.ok()) fetched = file->Commit();
  return fetched.ok() ? ExitCode::kOk : Fail(fetched);
}

CLI::App* AddFarmCommand(CLI::App& parent, const char* name, const char* about,
                         const std::shared_ptr<FarmOptions>& options, CommandContext& context,
                         ExitCode (*run)(const FarmOptions&, Interrupt&)) {
  CLI::App* command = parent.add_subcommand(name, about);
  AddServerOptions(*command, options->server);
  command->callback([options, &context, run] {
    context.run = [options, &context, run] { return run(*options, *context.interrupt); };
  });
  return command;
}

void AddTenantOption(CLI::App& command, FarmOptions& options) {
  command
      .add_option(
          "--tenant", options.tenant,
          "Tenant to show; default: your own. Another tenant needs a token with the scope admin")
      ->type_name("NAME");
}

}  // namespace

void AddEvents(CLI::App& app, CommandContext& context) {
  const auto options = std::make_shared<FarmOptions>();
  CLI::App* command = AddFarmCommand(app, "events", "Show events of all jobs as they happen",
                                     options, context, WatchAll);
  command->add_option("--from", options->from, "Time of the first event to show; default: now")
      ->type_name("TIME");
  command
      ->add_option("--cursor", options->cursor,
                   "Cursor that --json printed with an event; shows only the events after this one")
      ->excludes("--from");
  command->add_option("--count", options->count, "Number of events after which the command ends")
      ->check(AboveZero())
      ->type_name("N");
  command->add_flag("--json", options->json,
                    "Print each event with all its fields, as one line of JSON");
  AddTenantOption(*command, *options);
  command->footer(
      "Each line shows time, job, event number and state. After a cursor, some events may be "
      "repeated.");
}

void AddArtifacts(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("artifacts", "List the artifacts of a job, as JSON, or fetch one of them");
  const auto options = std::make_shared<ArtifactOptions>();
  command->add_option("JOB", options->id, "Job id, or the beginning of it")->required();
  std::vector<std::string> kinds;
  for (const auto& [kind, artifact] : kArtifacts) kinds.push_back(kind);
  auto* const kind =
      command
          ->add_option("--kind", options->kind,
                       "Kind of the artifact to fetch; without --kind, all artifacts are listed")
          ->check(OneOf(kinds));
  command->add_option("-o,--output", options->output, "File for the artifact; -: to stdout")
      ->needs(kind)
      ->capture_default_str()
      ->type_name("FILE");
  AddServerOptions(*command, options->server);
  command->callback([options, &context] {
    context.run = [options, &context] { return ShowArtifacts(*options, *context.interrupt); };
  });
}

void AddUsage(CLI::App& app, CommandContext& context) {
  const auto options = std::make_shared<FarmOptions>();
  AddTenantOption(
      *AddFarmCommand(app, "usage", "Show how much storage a tenant uses on the farm, as JSON",
                      options, context, ShowUsage),
      *options);
}

void AddCaller(CLI::App& app, CommandContext& context) {
  AddFarmCommand(app, "caller", "Show your identity on the farm and your permissions, as JSON",
                 std::make_shared<FarmOptions>(), context, ShowCaller);
}

void AddMeshes(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("meshes", "List, fetch and remove meshes that the farm stores");
  command->require_subcommand(1);
  const auto options = std::make_shared<FarmOptions>();
  AddFarmCommand(*command, "list", "List all meshes, including incomplete uploads", options,
                 context, ListMeshes)
      ->add_flag("--json", options->json, "Print each mesh as one line of JSON");
  CLI::App* get = AddFarmCommand(*command, "get", "Fetch a mesh", options, context, GetMesh);
  get->add_option("SHA256", options->sha256)->required();
  get->add_option("-o,--output", options->output, "File for the mesh; -: to stdout")
      ->required()
      ->type_name("FILE");
  CLI::App* remove = AddFarmCommand(*command, "delete", "Remove a mesh unless a job uses it",
                                    options, context, DeleteMesh);
  remove->add_option("SHA256", options->sha256)->required();
}

void AddUpdate(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("update", "Change the priority, the deadline or the labels of a job");
  const auto options = std::make_shared<UpdateOptions>();
  command->add_option("JOB", options->id, "Job id, or the beginning of it")->required();
  command
      ->add_option("--priority", options->priority,
                   "Priority of the job among the jobs of its tenant")
      ->check(OneOf(std::vector<std::string>{"bulk", "normal", "interactive"}));
  command
      ->add_option("--deadline", options->deadline,
                   "Time such as 2027-01-31T12:00:00Z at which the job fails if it is not done; "
                   "none: no deadline")
      ->type_name("TIME");
  command
      ->add_option("--label", options->labels,
                   "Label of the job; the given labels replace all present ones. May be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "Print the job as JSON");
  AddServerOptions(*command, options->server);
  command->callback([options, &context] {
    context.run = [options, &context] { return UpdateJob(*options, *context.interrupt); };
  });
}

}  // namespace slicefarm::cli
