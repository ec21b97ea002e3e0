#include "common/rpc/observe/metrics.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>
#include <vector>

#include "common/base/build_info.h"
#include "prometheus/counter.h"

namespace slicefarm::rpc::metrics_test {
namespace {

using testing::HasSubstr;

std::string Ask(int port, const std::string& request) {
  const int socket_fd = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(connect(socket_fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  EXPECT_EQ(send(socket_fd, request.data(), request.size(), 0),
            static_cast<ssize_t>(request.size()));
  std::string answer;
  std::array<char, 4096> buffer;
  for (ssize_t n = 0; (n = recv(socket_fd, buffer.data(), buffer.size(), 0)) > 0;) {
    answer.append(buffer.data(), static_cast<size_t>(n));
  }
  close(socket_fd);
  return answer;
}

std::string Get(int port, const std::string& path) {
  return Ask(port, "GET " + path + " HTTP/1.0\r\n\r\n");
}

TEST(Metrics, AreServedToPrometheus) {
  Metrics metrics;
  prometheus::BuildCounter()
      .Name("farm_test_total")
      .Register(metrics.registry())
      .Add({})
      .Increment(3);
  const absl::StatusOr<int> port = metrics.Serve("127.0.0.1:0");
  ASSERT_TRUE(port.ok()) << port.status();
  const std::string answer = Get(*port, "/metrics");
  EXPECT_THAT(answer, HasSubstr("200 OK"));
  EXPECT_THAT(answer, HasSubstr("farm_test_total 3"));
  EXPECT_THAT(answer, HasSubstr("slicefarm_build_info{build_id=\"" + std::string(BuildId())));
  EXPECT_THAT(answer, HasSubstr("process_cpu_seconds_total "));
  EXPECT_THAT(answer, HasSubstr("process_resident_memory_bytes "));
  EXPECT_THAT(answer, HasSubstr("process_open_fds "));
}

// Half requests must not occupy the server's threads. An earlier server had four, one per request.
TEST(Metrics, HalfRequestsKeepNobodyWaiting) {
  Metrics metrics;
  const absl::StatusOr<int> port = metrics.Serve("127.0.0.1:0");
  ASSERT_TRUE(port.ok()) << port.status();
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(*port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  std::vector<int> half;
  for (int i = 0; i < 200; ++i) {
    half.push_back(socket(AF_INET, SOCK_STREAM, 0));
    ASSERT_EQ(connect(half.back(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)),
              0);
    ASSERT_EQ(send(half.back(), "GET /met", 8, 0), 8);
  }
  EXPECT_THAT(Get(*port, "/metrics"), HasSubstr("slicefarm_build_info"));
  for (const int each : half) close(each);
}

TEST(Metrics, APortInUseIsAnError) {
  Metrics first;
  const absl::StatusOr<int> port = first.Serve("127.0.0.1:0");
  ASSERT_TRUE(port.ok()) << port.status();
  Metrics second;
  EXPECT_TRUE(absl::IsUnavailable(second.Serve("127.0.0.1:" + std::to_string(*port)).status()));
}

TEST(Metrics, ValuesAreLookedUpWhenSomebodyAsks) {
  class Values : public prometheus::Collectable {
   public:
    std::vector<prometheus::MetricFamily> Collect() const override {
      prometheus::ClientMetric metric;
      metric.gauge.value = ++asked_;
      return {{"farm_asked", "", prometheus::MetricType::Gauge, {metric}}};
    }

   private:
    mutable int asked_ = 0;
  };
  Metrics metrics;
  metrics.Show(std::make_shared<Values>());
  EXPECT_THAT(metrics.Text(), HasSubstr("farm_asked 1\n"));
  EXPECT_THAT(metrics.Text(), HasSubstr("farm_asked 2\n"));
}

TEST(Metrics, PagesStandBesideThem) {
  Metrics metrics;
  metrics.ShowPage("/page", [] { return "<p>hello</p>"; });
  const absl::StatusOr<int> port = metrics.Serve("127.0.0.1:0");
  ASSERT_TRUE(port.ok()) << port.status();
  const std::string page = Get(*port, "/page");
  EXPECT_THAT(page, HasSubstr("200 OK"));
  EXPECT_THAT(page, HasSubstr("text/html"));
  EXPECT_THAT(page, testing::EndsWith("<p>hello</p>"));
  EXPECT_THAT(Get(*port, "/page/below"), HasSubstr("404"));
  EXPECT_THAT(Get(*port, "/../etc/passwd"), testing::Not(HasSubstr("200 OK")));
  EXPECT_THAT(Ask(*port, "POST /page HTTP/1.0\r\n\r\n"), HasSubstr("405"));
  EXPECT_THAT(Ask(*port, "HEAD /page HTTP/1.0\r\n\r\n"), testing::Not(HasSubstr("hello")));
  metrics.Stop();
}

}  // namespace
}  // namespace slicefarm::rpc::metrics_test
