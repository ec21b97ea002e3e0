#include "services/coordinator/store/jobs/job_changes.h"

#include "absl/strings/str_cat.h"

namespace slicefarm::coordinator {

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

}  // namespace slicefarm::coordinator
