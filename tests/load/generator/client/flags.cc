#include "tests/load/generator/client/flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

namespace slicefarm::load {
namespace {

/// Calls per connection. A coordinator allows 128 open calls on a connection. This number is
/// smaller, because calls use the connections in turn and not by their load.
constexpr int kCallsPerConnection = 64;

constexpr double kMaxSeconds = 24 * 3600;

const std::map<std::string, ScenarioKind>& Scenarios() {
  static const std::map<std::string, ScenarioKind> scenarios = {{"print", ScenarioKind::kPrint},
                                                                {"submit", ScenarioKind::kSubmit},
                                                                {"get", ScenarioKind::kGet},
                                                                {"watch", ScenarioKind::kWatch}};
  return scenarios;
}

/// Returns the processes by name; `both` means all of them.
const std::map<std::string, std::vector<Process>>& Processes() {
  static const std::map<std::string, std::vector<Process>> processes = [] {
    std::map<std::string, std::vector<Process>> names;
    for (const ProcessInfo& info : kProcesses) {
      names[std::string(info.name)] = {info.process};
      names["both"].push_back(info.process);
    }
    return names;
  }();
  return processes;
}

void AddWhat(CLI::App& app, LoadFlags* flags) {
  app.add_option("--server", flags->server, "Address of the coordinator")
      ->envname("SLICEFARM_SERVER")
      ->capture_default_str()
      ->type_name("HOST:PORT");
  rpc::AddTlsOptions(app, &flags->security);
  rpc::AddTokenOptions(app, &flags->security);
  app.add_option("--scenario", flags->scenario,
                 "Scenario. print: upload, create, watch, download. submit: create. get: GetJob. "
                 "watch: as print, with many watchers and no download")
      ->check(CLI::IsMember(Scenarios()))
      ->capture_default_str();
  app.add_option("--mix", flags->mix, "Sizes of parts; mixed: 80 % tiny, 18 % medium, 2 % huge")
      ->check(CLI::IsMember({"tiny", "medium", "huge", "mixed"}))
      ->capture_default_str();
  app.add_option("--process", flags->process, "Process of the jobs; both: alternating")
      ->check(CLI::IsMember(Processes()))
      ->capture_default_str();
  app.add_flag("--same", flags->same,
               "Use the same part each time, so that the server's cache may answer");
  app.add_option("--watchers", flags->watchers,
                 "Number of watchers of each job, for --scenario watch")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  app.add_option("--seed", flags->seed,
                 "Seed of arrivals, parts and request ids; the same seed on the same server "
                 "repeats the earlier jobs. 0: a new seed")
      ->capture_default_str();
}

void AddHow(CLI::App& app, LoadFlags* flags) {
  auto* rate =
      app.add_option("--rate", flags->rates,
                     "Rate of an open loop, in requests per second; several rates: one run each")
          ->delimiter(',')
          ->check(CLI::Range(0.001, 1e6));
  auto* closed = app.add_option("--closed", flags->closed,
                                "Closed loop: number of requests at the same time; the next "
                                "request starts when one of them has ended")
                     ->check(CLI::Range(1, 100'000));
  rate->excludes(closed);
  app.add_option("--seconds", flags->seconds, "Duration of each run, in seconds")
      ->check(CLI::Range(0.1, kMaxSeconds))
      ->capture_default_str();
  app.add_option("--deadline", flags->deadline_s, "Seconds after which a request fails")
      ->check(CLI::Range(0.001, kMaxSeconds))
      ->capture_default_str();
  app.add_option("--in-flight", flags->in_flight,
                 "Largest number of requests in flight of an open loop; further arrivals are "
                 "skipped and counted")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  app.add_option("--connections", flags->connections,
                 "Number of channels; 0: as many as the requests in flight need")
      ->check(CLI::Range(0, 10'000))
      ->capture_default_str();
  app.add_flag("--retry", flags->retry,
               "Try refused calls again at the time that the server names");
}

}  // namespace

void AddLoadFlags(CLI::App& app, LoadFlags* flags) {
  AddWhat(app, flags);
  AddHow(app, flags);
  app.add_option("--json", flags->json,
                 "File for a report in the format of ghz; several rates: an array");
  app.add_option("--svg", flags->svg, "File for a plot of the latency percentiles over the rates");
  app.callback([flags] {
    if (flags->rates.empty() && flags->closed == 0) {
      throw CLI::ValidationError("either --rate or --closed is needed");
    }
    std::sort(flags->rates.begin(), flags->rates.end());
  });
}

ScenarioOptions LoadFlags::scenario_options() const {
  return {.kind = Scenarios().at(scenario),
          .parts = {.mix = MixFromName(mix).value(), .same = same, .seed = seed},
          .watchers = watchers,
          .processes = Processes().at(process)};
}

std::vector<RunOptions> LoadFlags::runs() const {
  RunOptions run = {.duration = std::chrono::duration<double>(seconds),
                    .deadline = std::chrono::duration<double>(deadline_s),
                    .in_flight = closed > 0 ? closed : in_flight,
                    .retry = retry,
                    .seed = seed};
  if (closed > 0) return {run};
  std::vector<RunOptions> runs;
  for (const double rate : rates) {
    run.rate_rps = rate;
    ++run.seed;
    runs.push_back(run);
  }
  return runs;
}

int LoadFlags::needed_connections() const {
  if (connections > 0) return connections;
  const int requests = closed > 0 ? closed : in_flight;
  const int calls = std::max(requests, scenario == "watch" ? watchers : 0);
  return (calls + kCallsPerConnection - 1) / kCallsPerConnection;
}

}  // namespace slicefarm::load
