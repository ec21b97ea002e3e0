#include "common/rpc/observe/json_log.h"

#include <gmock/gmock.h>
#include <google/protobuf/stubs/logging.h>
#include <grpc/support/log.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "common/base/build_info.h"
#include "common/rpc/observe/library_log.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::rpc::json_log_test {
namespace {

class JsonLogTest : public testing::Test {
 protected:
  nlohmann::json Line() const { return nlohmann::json::parse(out_.str()); }

  std::ostringstream out_;
  const JsonLog log_{"beading",
                     std::make_shared<spdlog::logger>(
                         "test", std::make_shared<spdlog::sinks::ostream_sink_mt>(out_))};
};

TEST_F(JsonLogTest, WritesOneObjectALine) {
  log_.Info("range done", {{"job", "j1"}, {"layer_first", int64_t{3}}, {"seconds", 0.25}});
  EXPECT_THAT(out_.str(), testing::EndsWith("}\n"));
  const nlohmann::json line = Line();
  EXPECT_EQ(line["level"], "info");
  EXPECT_EQ(line["svc"], "beading");
  EXPECT_EQ(line["build"], std::string(BuildId()));
  EXPECT_EQ(line["msg"], "range done");
  EXPECT_EQ(line["job"], "j1");
  EXPECT_EQ(line["layer_first"], 3);
  EXPECT_EQ(line["seconds"], 0.25);
  EXPECT_THAT(line["ts"].get<std::string>(),
              testing::MatchesRegex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:]{8}\\.[0-9]{3}Z"));
}

TEST_F(JsonLogTest, HasWhatLibrariesSay) {
  auto* const protobufs_own = google::protobuf::SetLogHandler(nullptr);
  LogLibrariesTo(log_);
  gpr_set_log_verbosity(GPR_LOG_SEVERITY_ERROR);  // otherwise gRPC's first channel does this
  gpr_log("core/lib/ssl.cc", 7, GPR_LOG_SEVERITY_ERROR, "Invalid %s key.", "private");
  gpr_set_log_function(nullptr);
  EXPECT_EQ(Line()["level"], "warning");
  EXPECT_EQ(Line()["msg"], "grpc ssl.cc");
  EXPECT_EQ(Line()["error"], "Invalid private key.");
  out_.str("");
  v1::GetJobRequest request;
  EXPECT_FALSE(request.ParseFromString("\x0a\x01\xff"));
  google::protobuf::SetLogHandler(protobufs_own);
  EXPECT_EQ(Line()["msg"], "protobuf wire_format_lite.cc");
  EXPECT_THAT(Line()["error"].get<std::string>(), testing::HasSubstr("GetJobRequest.id"));
}

TEST_F(JsonLogTest, NamesTheLevel) {
  log_.Warn("x");
  EXPECT_EQ(Line()["level"], "warning");
  out_.str("");
  log_.Error("x");
  EXPECT_EQ(Line()["level"], "error");
}

// The name of a job must not be able to add log lines, nor break the reader.
TEST_F(JsonLogTest, HostileTextStaysOneLine) {
  const std::string hostile = "\"}\n{\"level\":\"error\" {} %v %n \xff\0" + std::string(1, '\0');
  log_.Info(hostile, {{"job", hostile}, {"seconds", std::nan("")}});
  EXPECT_EQ(std::ranges::count(out_.str(), '\n'), 1);
  EXPECT_EQ(Line()["level"], "info");
  EXPECT_THAT(Line()["job"].get<std::string>(), testing::StartsWith("\"}\n{"));
  EXPECT_TRUE(Line()["seconds"].is_null());
}

TEST_F(JsonLogTest, CutsLongText) {
  log_.Info("x", {{"error", std::string(1'000'000, 'x')}});
  EXPECT_EQ(Line()["error"].get<std::string>().size(), 2048);
}

TEST_F(JsonLogTest, NamesTheTrace) {
  LogFields fields = {{"job", "j1"}};
  AddTrace({}, &fields);
  AddTrace({"4bf92f3577b34da6a3ce929d0e0e4736", "00f067aa0ba902b7"}, &fields);
  log_.Info("x", fields);
  EXPECT_EQ(Line()["trace_id"], "4bf92f3577b34da6a3ce929d0e0e4736");
  EXPECT_EQ(Line()["span_id"], "00f067aa0ba902b7");
}

TEST_F(JsonLogTest, AFloodOfProblemsIsHeldBackAndCounted) {
  const JsonLog stuck("x",
                      std::make_shared<spdlog::logger>(
                          "test", std::make_shared<spdlog::sinks::ostream_sink_mt>(out_)),
                      {.burst = 2, .lines_per_s = 0});
  for (int i = 0; i < 100; ++i) stuck.Error("broken");
  EXPECT_EQ(std::ranges::count(out_.str(), '\n'), 2);
  const JsonLog copy = stuck;
  copy.Warn("broken");
  EXPECT_EQ(std::ranges::count(out_.str(), '\n'), 2);
  for (int i = 0; i < 100; ++i) stuck.Info("call");
  EXPECT_EQ(std::ranges::count(out_.str(), '\n'), 102);
}

TEST_F(JsonLogTest, RemembersTheLastProblems) {
  log_.Info("fine");
  log_.Warn("bad", {{"job", "j1"}});
  const JsonLog copy = log_;
  copy.Error("worse");
  const auto problems = log_.RecentProblems();
  ASSERT_EQ(problems.size(), 2);
  EXPECT_EQ(problems[0].text, R"({"msg":"worse"})");
  EXPECT_EQ(problems[1].text, R"({"msg":"bad","job":"j1"})");
  for (int i = 0; i < 100; ++i) log_.Warn(std::to_string(i));
  EXPECT_EQ(log_.RecentProblems().size(), 20);
  EXPECT_EQ(log_.RecentProblems()[0].text, R"({"msg":"99"})");
}

}  // namespace
}  // namespace slicefarm::rpc::json_log_test
