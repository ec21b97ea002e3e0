#pragma once

#include <sys/types.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace slicefarm::slicing {

/// Returns the number of open files of a process.
inline int OpenFiles(const std::string& pid = "self") {
  const std::filesystem::directory_iterator files("/proc/" + pid + "/fd");
  return static_cast<int>(std::distance(begin(files), end(files)));
}

/// Returns the first line of /proc/PID/`name`; empty if there is none.
inline std::string ProcText(pid_t pid, const std::string& name) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/" + name);
  std::string line;
  std::getline(file, line);
  return line;
}

/// Returns the text after the name in `PID (NAME) STATE PARENT ...`; empty if there is no such
/// process.
inline std::string StateAndParent(pid_t pid) {
  const std::string stat = ProcText(pid, "stat");
  const size_t name_end = stat.rfind(") ");
  return name_end == std::string::npos ? "" : stat.substr(name_end + 2);
}

/// Returns the children of a process, including zombies.
inline std::vector<pid_t> ChildrenOf(pid_t parent) {
  std::vector<pid_t> children;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const pid_t pid = std::atoi(entry.path().filename().c_str());
    if (pid == 0) continue;
    const std::string state = StateAndParent(pid);
    if (!state.empty() && std::atoi(state.c_str() + 2) == parent) children.push_back(pid);
  }
  return children;
}

/// Returns true if a process is running; a zombie is not.
inline bool IsRunning(pid_t pid) {
  const std::string state = StateAndParent(pid);
  return !state.empty() && state[0] != 'Z' && state[0] != 'X';
}

}  // namespace slicefarm::slicing
