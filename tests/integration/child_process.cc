#include "tests/integration/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <thread>
#include <utility>

#include "tests/integration/http_get.h"

extern char** environ;

namespace slicefarm {
namespace {

[[noreturn]] void Die(const char* what) {
  std::perror(what);
  std::abort();
}

}  // namespace

ChildProcess::ChildProcess(const std::string& program, std::vector<std::string> arguments,
                           Stderr errors) {
  const std::string path = std::filesystem::path(SLICEFARM_BIN) / program;
  std::vector<char*> argv = {const_cast<char*>(path.c_str())};
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);

  std::array<int, 2> ends = {};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) Die("pipe2");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  if (errors == Stderr::kWithStdout) {
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  } else {
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  }
  errno = posix_spawn(&pid_, path.c_str(), &actions, nullptr, argv.data(), environ);
  if (errno != 0) Die(path.c_str());
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  stdout_ = ends[0];
}

ChildProcess::~ChildProcess() {
  if (!ended_) {
    Signal(SIGKILL);
    Wait();
  }
  close(stdout_);
}

std::string ChildProcess::AwaitLine(std::string_view prefix) {
  for (;;) {
    for (size_t end = 0; (end = unread_.find('\n')) != std::string::npos;) {
      const std::string line = unread_.substr(0, end);
      unread_.erase(0, end + 1);
      if (line.starts_with(prefix)) return line.substr(prefix.size());
    }
    std::array<char, 4096> buffer = {};
    const ssize_t size = read(stdout_, buffer.data(), buffer.size());
    if (size <= 0) return "";
    unread_.append(buffer.data(), static_cast<size_t>(size));
  }
}

void ChildProcess::Signal(int signal) const { kill(pid_, signal); }

int ChildProcess::Wait() {
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0) {
    if (errno != EINTR) Die("waitpid");
  }
  ended_ = true;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

namespace {

int MetricsPort(ChildProcess& process, const std::vector<std::string>& arguments) {
  if (std::find(arguments.begin(), arguments.end(), "--metrics-port") == arguments.end()) return 0;
  const std::string where = process.AwaitLine("metrics on ");
  return where.empty() ? 0 : std::stoi(where.substr(where.rfind(':') + 1));
}

}  // namespace

ServerProcess::ServerProcess(const std::string& program, std::vector<std::string> arguments)
    : process(program, arguments),
      metrics_port(MetricsPort(process, arguments)),
      address(process.AwaitLine("listening on ")) {
  if (!address.empty()) return;
  process.Signal(SIGKILL);
  throw std::runtime_error(program + " does not serve");  // ends the fixture's other processes too
}

std::string ServerProcess::Metric(const std::string& name) const {
  const std::string page = HttpGet(metrics_port, "/metrics");
  const size_t line = page.find("\n" + name + " ");
  if (line == std::string::npos) return "";
  const size_t begin = line + name.size() + 2;
  return page.substr(begin, page.find('\n', begin) - begin);
}

void ServerProcess::AwaitMetric(const std::string& line) const {
  while (HttpGet(metrics_port, "/metrics").find("\n" + line + "\n") == std::string::npos)
    std::this_thread::yield();
}

}  // namespace slicefarm
