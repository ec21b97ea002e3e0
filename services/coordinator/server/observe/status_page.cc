#include "services/coordinator/server/observe/status_page.h"

#include <fmt/core.h>

#include <algorithm>

#include "absl/time/time.h"
#include "services/coordinator/server/observe/coordinator_metrics.h"

namespace slicefarm::coordinator {
namespace {

constexpr char kHead[] = R"(<!doctype html><html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width"><title>slicefarm coordinator</title><style>
body{font:14px/1.5 system-ui,sans-serif;margin:2em;color:#222;background:#fff}
h1{font-size:1.4em}h2{font-size:1.1em;margin:1.5em 0 .3em}
table{border-collapse:collapse}th,td{padding:.2em .8em;text-align:left;border-bottom:1px solid #ddd}
td.n{text-align:right;font-variant-numeric:tabular-nums}.bad{color:#a00}code{font-size:.9em}
</style></head><body>
)";

using Cells = std::vector<std::string>;

/// Returns a table of texts. Escapes the texts.
std::string Table(const Cells& head, const std::vector<Cells>& rows) {
  if (rows.empty()) return "<p>none</p>\n";
  std::string html = "<table><tr>";
  for (const std::string& cell : head) html += "<th>" + EscapeHtml(cell) + "</th>";
  html += "</tr>\n";
  for (const Cells& row : rows) {
    html += "<tr>";
    for (const std::string& cell : row) html += "<td>" + EscapeHtml(cell) + "</td>";
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string Heading(const std::string& text) { return "<h2>" + EscapeHtml(text) + "</h2>\n"; }

/// Returns a duration in its two largest units: "3 d 4 h", "2 min 5 s".
std::string Duration(double seconds) {
  const auto all = static_cast<int64_t>(std::max(seconds, 0.0));
  if (all >= 86400) return fmt::format("{} d {} h", all / 86400, all % 86400 / 3600);
  if (all >= 3600) return fmt::format("{} h {} min", all / 3600, all % 3600 / 60);
  if (all >= 60) return fmt::format("{} min {} s", all / 60, all % 60);
  return fmt::format("{:.1f} s", std::max(seconds, 0.0));
}

std::string Gib(uintmax_t bytes) {
  constexpr double kGib = 1 << 30;
  return fmt::format("{:.1f} GiB", static_cast<double>(bytes) / kGib);
}

double AgeS(const CoordinatorStatus& status, int64_t since_us) {
  return static_cast<double>(status.now_us - since_us) / 1e6;
}

std::string About(const CoordinatorStatus& status) {
  std::vector<Cells> rows = {{"name", status.name},
                             {"build", status.build},
                             {"up for", Duration(status.uptime_s)},
                             {"store", status.store}};
  if (!status.store_status.ok()) {
    rows.push_back({"store fails", std::string(status.store_status.message())});
  }
  if (status.disk) {
    rows.push_back(
        {"disk", Gib(status.disk->available) + " of " + Gib(status.disk->capacity) + " free"});
  }
  return Table({"coordinator", ""}, rows);
}

std::string Jobs(const CoordinatorStatus& status) {
  std::vector<Cells> ended;
  for (const auto& [state, count] : status.jobs) {
    ended.push_back({std::string(JobStateName(state)), fmt::format("{}", count)});
  }
  std::vector<Cells> open;
  for (const OpenJobs& jobs : status.open) {
    open.push_back({std::string(JobStateName(jobs.state)), PriorityName(jobs.priority),
                    fmt::format("{}", jobs.count), Duration(AgeS(status, jobs.oldest_us))});
  }
  return Heading("Jobs") + Table({"state", "jobs"}, ended) + Heading("Jobs that have not ended") +
         Table({"state", "priority", "jobs", "oldest"}, open);
}

std::string Running(const CoordinatorStatus& status) {
  std::vector<Cells> rows;
  for (const JobRecord& job : status.running) {
    rows.push_back({job.id, job.tenant, job.owner,
                    fmt::format("{} of {}", job.layers_done, job.layers_total),
                    Duration(AgeS(status, job.start_us)), fmt::format("{}", job.retries)});
  }
  return Heading("Running jobs, oldest first") +
         Table({"job", "tenant", "coordinator", "layers", "for", "retries"}, rows);
}

std::string Workers(const CoordinatorStatus& status) {
  std::vector<Cells> runners;
  std::vector<Cells> tasks;
  for (const RunnerAtWork& runner : status.runners) {
    runners.push_back({runner.name, fmt::format("{}", runner.slots),
                       fmt::format("{}", runner.tasks.size()), status.build});
    for (const TaskAtWork& task : runner.tasks)
      tasks.push_back({runner.name, task.job_id, task.task, Duration(task.since_s)});
  }
  std::vector<Cells> replicas;
  for (const auto& [stage, addresses] : status.replicas) {
    for (const std::string& address : addresses) replicas.push_back({stage, address});
  }
  return Heading("Connected workers (workers of another build are refused)") +
         Table({"worker", "slots", "busy", "build"}, runners) + Heading("Tasks in flight") +
         Table({"worker", "job", "task", "for"}, tasks) + Heading("Stages") +
         Table({"stage", "address"}, replicas);
}

std::string Problems(const CoordinatorStatus& status) {
  std::vector<Cells> rows;
  for (const rpc::Problem& problem : status.problems) {
    rows.push_back({absl::FormatTime("%Y-%m-%dT%H:%M:%SZ", absl::FromChrono(problem.time),
                                     absl::UTCTimeZone()),
                    problem.text});
  }
  return Heading("Last warnings and errors") + Table({"time", ""}, rows);
}

}  // namespace

std::string EscapeHtml(std::string_view text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string StatusPage(const CoordinatorStatus& status) {
  return kHead + ("<h1>slicefarm coordinator " + EscapeHtml(status.name) + "</h1>\n") +
         About(status) + Jobs(status) + Running(status) + Workers(status) + Problems(status) +
         "</body></html>\n";
}

}  // namespace slicefarm::coordinator
