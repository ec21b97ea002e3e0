#include "common/rpc/metrics.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>

#include "common/model/build_info.h"
#include "prometheus/counter.h"

namespace slicefarm::rpc {
namespace {

using testing::HasSubstr;

std::string Get(int port, const std::string& path) {
  const int socket_fd = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(connect(socket_fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  const std::string request = "GET " + path + " HTTP/1.0\r\n\r\n";
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

TEST(Metrics, APortInUseIsAnError) {
  Metrics first;
  const absl::StatusOr<int> port = first.Serve("127.0.0.1:0");
  ASSERT_TRUE(port.ok()) << port.status();
  Metrics second;
  EXPECT_TRUE(absl::IsUnavailable(second.Serve("127.0.0.1:" + std::to_string(*port)).status()));
}

}  // namespace
}  // namespace slicefarm::rpc
