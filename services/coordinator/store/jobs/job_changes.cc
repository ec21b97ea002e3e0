#include "services/coordinator/store/jobs/job_changes.h"

#include <sstream>

#include "absl/strings/str_cat.h"

namespace slicefarm::coordinator {
namespace {

/// Word in place of a state's name. Builds that do not support it ignore the notice.
constexpr std::string_view kProgress = "PROGRESS";

}  // namespace

std::string ToText(const JobChange& change) {
  return absl::StrCat(std::string(JobStateName(change.state)), change.cancel_requested ? "! " : " ",
                      change.job_id);
}

std::optional<JobChange> JobChangeFromText(std::string_view text) {
  const size_t space = text.find(' ');
  if (space == std::string_view::npos) return std::nullopt;
  JobChange change;
  change.job_id = text.substr(space + 1);
  std::string_view name = text.substr(0, space);
  change.cancel_requested = name.ends_with('!');
  if (change.cancel_requested) name.remove_suffix(1);
  const auto state = JobStateFromName(name);
  if (!state) return std::nullopt;
  change.state = *state;
  return change;
}

std::string ToText(const ProgressReport& report) {
  std::string text = absl::StrCat(std::string(kProgress), " ", report.owner);
  size_t left = kMostReported;
  for (const auto& [id, at] : report.jobs) {
    if (left-- == 0) break;
    absl::StrAppend(&text, " ", id, " ", at.epoch, " ", at.time_us, " ", at.layers_total, " ");
    absl::StrAppend(&text, at.layers_done);
  }
  return text;
}

std::optional<ProgressReport> ProgressReportFromText(std::string_view text) {
  std::istringstream words{std::string(text)};
  ProgressReport report;
  std::string kind;
  if (!(words >> kind >> report.owner) || kind != kProgress) return std::nullopt;
  std::string id;
  while (words >> id) {
    JobProgress at;
    if (!(words >> at.epoch >> at.time_us >> at.layers_total >> at.layers_done))
      return std::nullopt;
    report.jobs[id] = at;
  }
  return report;
}

}  // namespace slicefarm::coordinator
