#include "services/cli/farm/server_options.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "common/base/error.h"
#include "common/rpc/utf8.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/files.h"
#include "services/cli/console/input_files.h"
#include "services/cli/farm/job_outcome.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {

void AddServerOptions(CLI::App& app, ServerOptions& options) {
  app.add_option("--server", options.server,
                 "Address of the coordinator. For several coordinators: a name that resolves to "
                 "all of them, or ipv4:A:PORT,B:PORT")
      ->envname("SLICEFARM_SERVER")
      ->capture_default_str()
      ->type_name("HOST:PORT");
  app.add_option(
         "--patience", options.patience_s,
         "Seconds for which a server that does not answer is tried again before the command fails")
      ->check(InRange(0.0, 86400.0))
      ->capture_default_str()
      ->type_name("S");
  rpc::AddTlsOptions(app, &options.security);
  rpc::AddTokenOptions(app, &options.security);
}

JobsClientOptions ClientOptions(const ServerOptions& options, Interrupt* interrupt) {
  if (interrupt != nullptr) interrupt->WaitForEnd();
  const rpc::ClientSecurity& security = options.security;
  for (const std::string& path :
       {security.token_file, security.tls.ca, security.tls.cert, security.tls.key})
    NoteInput(path);
  return {.server = options.server,
          .security = options.security,
          .patience = std::chrono::milliseconds(static_cast<int64_t>(options.patience_s * 1000)),
          .cancel = interrupt == nullptr ? CancelToken() : interrupt->Token()};
}

absl::StatusOr<std::map<std::string, std::string>> ReadLabels(
    const std::vector<std::string>& texts) {
  const auto malformed = [](const std::string& text, const char* why) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                     fmt::format("--label {}: {}", text, why));
  };
  std::map<std::string, std::string> labels;
  for (const std::string& text : texts) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) return malformed(text, "KEY=VALUE is needed");
    if (!rpc::IsUtf8(text)) return malformed(text, "is not UTF-8 text");
    labels[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return labels;
}

namespace {

/// Returns the path of the output. In a folder the file has the name that the job's settings give
/// it.
absl::StatusOr<std::string> PathOf(JobsClient& client, const v1::Job& job,
                                   const std::string& output) {
  std::error_code error;
  if (output.empty() || !std::filesystem::is_directory(output, error)) return output;
  const auto text = client.DownloadText(job, v1::ARTIFACT_REPORT);
  if (!text.ok()) return text.status();
  const auto report = nlohmann::json::parse(*text, nullptr, /*allow_exceptions=*/false);
  const bool named =
      report.is_object() && report.contains("file_name") && report["file_name"].is_string();
  const std::string name = named ? report["file_name"].get<std::string>() : "";
  // The report of an older farm or of another machine has no safe name.
  if (name.empty() || name.find_first_of("/\\") != std::string::npos)
    return Malformed(fmt::format("{} is a folder, and the job does not name its file", output));
  return (std::filesystem::path(output) / name).string();
}

}  // namespace

absl::StatusOr<std::string> FetchResults(JobsClient& client, const v1::Job& job,
                                         const ResultFiles& files) {
  auto gcode = PathOf(client, job, files.gcode);
  if (!gcode.ok()) return gcode.status();
  std::vector<OutputFile> complete;
  for (const auto& [path, artifact] :
       {std::pair{*gcode, v1::ARTIFACT_GCODE}, std::pair{files.report, v1::ARTIFACT_REPORT},
        std::pair{files.trace, v1::ARTIFACT_TRACE}}) {
    if (path.empty()) continue;
    auto file = OutputFile::Create(path);
    if (!file.ok()) return file.status();
    if (absl::Status status = client.Download(job, artifact, *file); !status.ok()) return status;
    complete.push_back(*std::move(file));
  }
  for (OutputFile& file : complete) {
    if (absl::Status status = file.Commit(); !status.ok()) return status;
  }
  return gcode;
}

void ShowProgress(ProgressBar& bar, const v1::Job& job) {
  if (job.progress().layers_total() > 0) {
    bar.Show("layers", job.progress().layers_done(), job.progress().layers_total());
  } else {
    bar.Show(job.state() == v1::JOB_STATE_RUNNING ? "slicing" : StateName(job.state()), 0, 0);
  }
}

std::string StateName(v1::JobState state) {
  switch (state) {
    case v1::JOB_STATE_QUEUED:
      return "queued";
    case v1::JOB_STATE_RUNNING:
      return "running";
    case v1::JOB_STATE_SUCCEEDED:
      return "succeeded";
    case v1::JOB_STATE_FAILED:
      return "failed";
    case v1::JOB_STATE_CANCELLED:
      return "cancelled";
    default:
      return "unknown";
  }
}

ExitCode JobExitCode(const absl::Status& outcome) {
  const ExitCode code = ExitCodeOf(outcome);
  const bool tells = code == ExitCode::kOk || code == ExitCode::kBadSettings ||
                     code == ExitCode::kBadMesh || code == ExitCode::kCancelled ||
                     code == ExitCode::kNotFound;
  return tells ? code : ExitCode::kJobFailed;
}

ExitCode FailJob(const v1::Job& job, const std::string& model) {
  const absl::Status outcome = OutcomeOf(job);
  const ExitCode code = JobExitCode(outcome);
  Fail(code == ExitCode::kBadMesh && !model.empty() ? InFile(model, outcome) : outcome);
  return code;
}

}  // namespace slicefarm::cli
