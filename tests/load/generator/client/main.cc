#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "common/base/build_info.h"
#include "common/base/error.h"
#include "tests/load/generator/algo/latency_plot.h"
#include "tests/load/generator/algo/report_json.h"
#include "tests/load/generator/algo/report_table.h"
#include "tests/load/generator/client/flags.h"

namespace slicefarm::load {
namespace {

constexpr char kDescription[] =
    "Puts load on a coordinator and tells what its clients would wait. Latency counts from the\n"
    "instant at which a request was to start, and failed requests count as well.";

constexpr char kFooter[] =
    "Examples:\n"
    "  slicefarm-load --rate 5 --seconds 30 --mix tiny --json out.json\n"
    "  slicefarm-load --rate 5,10,20 --mix mixed --json out.json --svg out.svg\n"
    "  slicefarm-load --closed 8 --mix mixed                   how much goes through at most\n"
    "  slicefarm-load --scenario submit --rate 200\n"
    "\n"
    "Exit codes: 0 the load was put on, whatever became of the requests; 1 it could not be;\n"
    "2 wrong command line";

constexpr int kFailed = 1;
constexpr int kUsage = 2;
constexpr std::chrono::seconds kConnectPatience{10};

int Fail(const absl::Status& status) {
  fmt::print(stderr, "error: {}: {}\n", ReasonName(DetailOf(status).reason),
             std::string(status.message()));
  return kFailed;
}

absl::Status WriteFile(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (file) return absl::OkStatus();
  return MakeError(absl::StatusCode::kDataLoss, Reason::kInternal, "cannot write " + path);
}

absl::Status WriteReports(const LoadFlags& flags, const std::vector<RunReport>& reports) {
  absl::Status status;
  if (!flags.json.empty()) status.Update(WriteFile(flags.json, ReportJson(reports)));
  if (!flags.svg.empty()) status.Update(WriteFile(flags.svg, LatencyPlot(reports)));
  return status;
}

RunReport RunOnce(const LoadFlags& flags, const RunOptions& options, Scenario& scenario) {
  RunReport report = Run(options, scenario);
  report.scenario = flags.scenario;
  report.server = flags.server;
  report.build_id = BuildId();
  report.mix = flags.mix;
  report.process = flags.process;
  report.same = flags.same;
  report.connections = flags.needed_connections();
  report.seed = flags.seed;
  return report;
}

absl::Status PutOnLoad(const LoadFlags& flags) {
  auto farm =
      Farm::Connect(flags.server, flags.security, flags.needed_connections(), kConnectPatience);
  if (!farm.ok()) return farm.status();
  const auto scenario = MakeScenario(flags.scenario_options(), **farm);
  RunLog before;
  absl::Status prepared = scenario->Prepare(
      {.deadline = std::chrono::system_clock::now() + std::chrono::minutes(1), .log = &before});
  if (!prepared.ok()) return prepared;
  fmt::print("{} {} {}, seed {}\n{}", flags.scenario, flags.process, flags.mix, flags.seed,
             TableHeader());
  std::vector<RunReport> reports;
  for (const RunOptions& run : flags.runs()) {
    reports.push_back(RunOnce(flags, run, *scenario));
    fmt::print("{}", TableRow(reports.back()));
    std::fflush(stdout);
    // Writes the reports after each run, so that an interruption of a later run does not lose them.
    if (absl::Status status = WriteReports(flags, reports); !status.ok()) return status;
  }
  return absl::OkStatus();
}

int Main(int argc, char** argv) {
  LoadFlags flags;
  CLI::App app(kDescription, "slicefarm-load");
  app.footer(kFooter);
  app.set_version_flag("--version",
                       fmt::format("slicefarm-load {}, build {}", Version(), BuildId()));
  AddLoadFlags(app, &flags);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kUsage;
  }
  if (flags.seed == 0) flags.seed = std::random_device()();
  const absl::Status status = PutOnLoad(flags);
  return status.ok() ? 0 : Fail(status);
}

}  // namespace
}  // namespace slicefarm::load

int main(int argc, char** argv) {
  try {
    return slicefarm::load::Main(argc, argv);
  } catch (const std::exception& error) {  // probably out of memory
    fmt::print(stderr, "error: {}\n", error.what());
    return slicefarm::load::kFailed;
  }
}
