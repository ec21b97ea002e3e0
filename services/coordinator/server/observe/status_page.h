#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/rpc/observe/json_log.h"
#include "services/coordinator/algo/dispatch/fleet.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// Status of a coordinator at one moment.
struct CoordinatorStatus {
  std::string name;
  std::string build;  ///< version and build id
  double uptime_s = 0;
  std::string store;                 ///< kind and address of the store, without secrets
  absl::Status store_status = {};    ///< error of reading from the store
  std::map<JobState, int64_t> jobs;  ///< number of jobs by state
  std::vector<OpenJobs> open;        ///< open jobs by state and priority
  std::vector<JobRecord> running;    ///< oldest running jobs, of any coordinator
  std::vector<RunnerAtWork> runners;
  std::map<std::string, std::vector<std::string>> replicas;  ///< addresses by stage
  std::optional<std::filesystem::space_info> disk;           ///< disk of the state directory
  std::vector<rpc::Problem> problems;                        ///< newest first
  int64_t now_us = 0;                                        ///< time of the status, since 1970
};

/// Returns a self-contained page of HTML. Escapes texts from outside, such as names and errors.
std::string StatusPage(const CoordinatorStatus& status);

/// Escapes a text for HTML, also for use within quotes.
std::string EscapeHtml(std::string_view text);

}  // namespace slicefarm::coordinator
