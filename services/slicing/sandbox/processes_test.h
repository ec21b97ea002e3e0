#pragma once

#include <dirent.h>
#include <sys/types.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace slicefarm::slicing {

/// How many files a process has open.
inline int OpenFiles(const std::string& pid = "self") {
  const std::filesystem::directory_iterator files("/proc/" + pid + "/fd");
  return static_cast<int>(std::distance(begin(files), end(files)));
}

/// The children of a process, the dead that nobody reaped among them.
inline std::vector<pid_t> ChildrenOf(pid_t parent) {
  std::vector<pid_t> children;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "stat");
    std::string stat;
    if (!std::getline(file, stat)) continue;
    // PID (NAME) STATE PARENT ...
    const size_t name_end = stat.rfind(')');
    if (name_end == std::string::npos) continue;
    if (std::atoi(stat.c_str() + name_end + 4) == parent)
      children.push_back(std::atoi(stat.c_str()));
  }
  return children;
}

}  // namespace slicefarm::slicing
