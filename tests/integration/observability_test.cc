// Tests the monitoring of a farm with the programs as processes: names of metrics in dashboards and
// alerts, the status page, and traces through logs of other processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "common/base/temp_directory_test.h"
#include "common/base/trace_context.h"
#include "common/rpc/security/dev_certs_test.h"
#include "nlohmann/json.hpp"
#include "services/coordinator/server/api/coordinator_client_test.h"
#include "tests/corpus_file.h"
#include "tests/integration/child_process.h"
#include "tests/integration/http_get.h"

namespace slicefarm::observability_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// Server program with its metrics.
class ShownProcess {
 public:
  explicit ShownProcess(const std::string& program, std::vector<std::string> arguments = {})
      : process_(program, WithMetrics(std::move(arguments)), ChildProcess::Stderr::kWithStdout),
        metrics_(process_.AwaitLine("metrics on ")),
        address_(process_.AwaitLine("listening on ")) {}

  const std::string& address() const { return address_; }

  std::string Get(const std::string& path) const {
    return HttpGet(std::stoi(metrics_.substr(metrics_.rfind(':') + 1)), path);
  }

  /// Returns the names of all its metrics, including the series of histograms.
  std::set<std::string> MetricNames() const {
    static const std::regex kType("# TYPE (\\w+) (\\w+)");
    std::set<std::string> names;
    const std::string text = Get("/metrics");
    for (std::sregex_iterator type(text.begin(), text.end(), kType), end; type != end; ++type) {
      const std::string name = (*type)[1];
      names.insert(name);
      if ((*type)[2] != "histogram") continue;
      for (const char* series : {"_bucket", "_sum", "_count"}) names.insert(name + series);
    }
    return names;
  }

  /// Waits for a log line with this text and returns it.
  nlohmann::json AwaitLog(const std::string& text) {
    for (;;) {
      const std::string line = "{" + process_.AwaitLine("{");
      if (line == "{") return {};
      if (line.find(text) != std::string::npos) return nlohmann::json::parse(line);
    }
  }

 private:
  static std::vector<std::string> WithMetrics(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--metrics-port", "0"});
    return arguments;
  }

  ChildProcess process_;
  const std::string metrics_;
  const std::string address_;
};

constexpr char kTraceparent[] = "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01";

class ObservabilityTest : public testing::Test, protected coordinator::CoordinatorClient {
 protected:
  /// Runs a job to its end.
  void SetUp() override {
    Connect(coordinator_.address());
    const std::string mesh = CorpusFile("models/textbox.stl");
    ASSERT_TRUE(Upload(mesh).ok());
    const auto job = Create(RequestFor(mesh), *ParseTraceparent(kTraceparent));
    ASSERT_TRUE(job.ok()) << job.status();
    id_ = job->id();
    const v1::Job end = AwaitEnd(id_);
    ASSERT_EQ(end.state(), v1::JOB_STATE_SUCCEEDED) << end.error().message();
  }

  /// Returns a webhooks file that allows no receiver.
  std::string WebhooksFile() const {
    const std::string path = state_.path() + "/webhooks.json";
    std::ofstream(path) << R"({"": {"allow": [], "secret": "0123456789abcdef"}})";
    return path;
  }

  TempDirectory state_;
  ShownProcess slicing_{"slicefarm-slicing"};
  ShownProcess planning_{"slicefarm-planning"};
  ShownProcess motion_{"slicefarm-motion"};
  ShownProcess worker_{"slicefarm-worker", {"--slots", "2"}};
  ShownProcess coordinator_{
      "slicefarm-coordinator",
      {"--state-dir", state_.path(), "--slicing", slicing_.address(), "--planning",
       planning_.address(), "--motion", motion_.address(), "--workers", worker_.address(), "--name",
       "c1", "--webhooks", WebhooksFile(), "--keep-jobs", "30"}};
  std::string id_;
};

/// Returns the names of metrics in a file.
std::set<std::string> NamesIn(const std::string& path) {
  static const std::regex kName("\\b(slicefarm_|grpc_server_|process_)\\w+");
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  const std::string all = text.str();
  std::set<std::string> names;
  for (std::sregex_iterator name(all.begin(), all.end(), kName), end; name != end; ++name) {
    names.insert(name->str());
  }
  return names;
}

TEST_F(ObservabilityTest, DashboardsAndAlertsNameWhatThereIs) {
  rpc::DevCerts certs;
  const rpc::TlsFiles tls = certs.Make("worker");
  ShownProcess secure("slicefarm-worker",
                      {"--tls-cert", tls.cert, "--tls-key", tls.key, "--tls-ca", tls.ca});
  std::set<std::string> there = {"up",                             // Prometheus' own metric
                                 "slicefarm_tenants_file_usable",  // with --tenants
                                 "slicefarm_ranges",               // made by the adapter
                                 // with --postgres and --max-database
                                 "slicefarm_database_bytes", "slicefarm_database_connections",
                                 "slicefarm_database_max_bytes",
                                 "slicefarm_database_max_connections"};
  for (const ShownProcess* process :
       {&slicing_, &planning_, &motion_, &worker_, &coordinator_, &secure}) {
    there.merge(process->MetricNames());
  }
  for (const char* file : {"alerts.yml", "alerts_test.yml", "grafana.json", "adapter.yml"}) {
    const std::string path = std::string(SLICEFARM_SOURCE) + "/deploy/monitoring/" + file;
    const std::set<std::string> named = NamesIn(path);
    EXPECT_FALSE(named.empty()) << path;
    std::set<std::string> missing;
    std::ranges::set_difference(named, there, std::inserter(missing, missing.end()));
    EXPECT_THAT(missing, IsEmpty()) << "in " << path;
  }
}

TEST_F(ObservabilityTest, TheFarmHasAPageForPeople) {
  const std::string page = coordinator_.Get("/statusz");
  EXPECT_THAT(page, HasSubstr("200 OK"));
  EXPECT_THAT(page, HasSubstr("<td>c1</td>"));
  EXPECT_THAT(page, HasSubstr("<td>SUCCEEDED</td><td>1</td>"));
  EXPECT_THAT(page, HasSubstr("<td>" + worker_.address() + "</td><td>2</td>"));
  EXPECT_THAT(page, HasSubstr("<td>slicing</td><td>" + slicing_.address() + "</td>"));
  EXPECT_THAT(page, HasSubstr("<td>planning</td><td>" + planning_.address() + "</td>"));
  EXPECT_THAT(worker_.Get("/statusz"), HasSubstr("404"));
}

TEST_F(ObservabilityTest, ATraceGoesThroughTheLogsOfAllProcesses) {
  const std::string trace_id = ParseTraceparent(kTraceparent)->trace_id;
  std::set<std::string> spans;
  for (const auto& [process, text] :
       {std::pair{&coordinator_, "\"job done\""}, std::pair{&slicing_, "\"Slice\""},
        std::pair{&planning_, "\"PlanJob\""}, std::pair{&worker_, "\"WorkRange\""},
        std::pair{&motion_, "\"FrameProgram\""}}) {
    const nlohmann::json line = process->AwaitLog(text);
    EXPECT_EQ(line["trace_id"], trace_id) << line;
    EXPECT_EQ(line["job"], id_) << line;
    spans.insert(line["span_id"]);
  }
  EXPECT_EQ(spans.size(), 5u);
}

TEST_F(ObservabilityTest, TheTraceOfAJobNamesItsWorkersCalls) {
  const auto text = Download(id_, v1::ARTIFACT_TRACE);
  ASSERT_TRUE(text.ok()) << text.status();
  const nlohmann::json trace = nlohmann::json::parse(*text);
  std::set<std::string> span_ids;
  std::set<std::string> tracks;
  for (const nlohmann::json& event : trace["traceEvents"]) {
    if (event["name"] == "process_name") tracks.insert(event["args"]["name"]);
    if (event["args"].contains("span_id")) span_ids.insert(event["args"]["span_id"]);
  }
  EXPECT_THAT(tracks, testing::Contains(worker_.address()));
  EXPECT_FALSE(span_ids.empty());
}

}  // namespace
}  // namespace slicefarm::observability_test
