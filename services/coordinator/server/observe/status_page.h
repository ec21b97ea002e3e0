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

/// What a coordinator tells of itself, at one moment.
struct CoordinatorStatus {
  std::string name;
  std::string build;  ///< version and build id
  double uptime_s = 0;
  std::string store;                 ///< which one, without secrets
  absl::Status store_status = {};    ///< of the looks into it
  std::map<JobState, int64_t> jobs;  ///< by state
  std::vector<OpenJobs> open;        ///< by state and priority
  std::vector<JobRecord> running;    ///< the oldest ones, of any coordinator
  std::vector<RunnerAtWork> runners;
  std::map<std::string, std::vector<std::string>> replicas;  ///< addresses by stage
  std::optional<std::filesystem::space_info> disk;           ///< of the state
  std::vector<rpc::Problem> problems;                        ///< newest first
  int64_t now_us = 0;                                        ///< since 1970
};

/// One page of HTML that needs nothing else; what comes from outside (names, errors) is escaped.
std::string StatusPage(const CoordinatorStatus& status);

/// Text as part of HTML, also within quotes.
std::string EscapeHtml(std::string_view text);

}  // namespace slicefarm::coordinator
