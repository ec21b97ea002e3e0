#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "common/base/temp_directory_test.h"
#include "services/cli/console/exit_code.h"

extern char** environ;

namespace slicefarm::cli {

using Arguments = std::vector<std::string>;

/// Exit code and output of one run.
struct Outcome {
  ExitCode code = ExitCode::kOk;
  std::string out;
  std::string err;
};

/// Cube of 10 mm with one corner in the origin, as OBJ.
inline constexpr char kCube[] =
    "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 10\nv 10 0 10\nv 10 10 10\nv 0 10 10\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// Test fixture that runs the program as a process in a folder with a cube.
class Program : public testing::Test {
 protected:
  Program() { Put("cube.obj", kCube); }

  std::string Path(const std::string& name) const { return folder_.path() + "/" + name; }
  std::string Text(const std::string& name) const {
    const std::ifstream file(Path(name), std::ios::binary);
    EXPECT_TRUE(file.good()) << name;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  bool Exists(const std::string& name) const { return std::filesystem::exists(Path(name)); }
  void Put(const std::string& name, std::string_view text) {
    std::ofstream(Path(name), std::ios::binary) << text;
  }

  pid_t Start(Arguments arguments) {
    arguments.insert(arguments.begin(), SLICEFARM_PROGRAM);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    constexpr int kFlags = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions, 1, Path(".out").c_str(), kFlags, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, Path(".err").c_str(), kFlags, 0600);
    pid_t pid = -1;
    EXPECT_EQ(posix_spawn(&pid, SLICEFARM_PROGRAM, &actions, nullptr, argv.data(), environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    return pid;
  }

  Outcome Await(pid_t pid) {
    int status = 0;
    EXPECT_EQ(waitpid(pid, &status, 0), pid);
    EXPECT_TRUE(WIFEXITED(status)) << "ended by signal " << WTERMSIG(status);
    return {static_cast<ExitCode>(WEXITSTATUS(status)), Text(".out"), Text(".err")};
  }

  Outcome Run(const Arguments& arguments) { return Await(Start(arguments)); }

  /// Runs `slice cube.obj --generic -o out.gcode` with more arguments.
  Outcome Slice(Arguments more = {}) {
    Arguments arguments = {"slice", Path("cube.obj"), "--generic", "-o", Path("out.gcode")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Run(arguments);
  }

  const TempDirectory folder_;
};

}  // namespace slicefarm::cli
