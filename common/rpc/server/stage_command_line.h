#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/rpc/server/serve.h"

namespace slicefarm::rpc {

/// Command line of the server program of one stage: the options of AddServeFlags, and options that
/// the stage adds. The pointers refer to the default values and must outlive Parse. CLI11 is
/// included only in the implementation, because it adds 5 s to the compilation of each file that
/// includes it.
class StageCommandLine {
 public:
  /// `name`: `beading` of slicefarm-beading. `about`: description of the program in --help.
  StageCommandLine(const std::string& name, const std::string& about, ServeFlags* flags);
  ~StageCommandLine();

  /// Adds --max-concurrent, for programs with calls that each use one slot.
  void AddConcurrency(ServeFlags* flags);
  /// Adds an option for a whole number from `least` to `most`.
  void AddCount(const std::string& option, int* count, const std::string& about, int least,
                int most);
  /// Adds an option for one of `names`.
  void AddChoice(const std::string& option, std::string* name, const std::string& about,
                 const std::vector<std::string>& names);
  /// Adds an option for a comma-separated selection of `names`.
  void AddChoices(const std::string& option, std::vector<std::string>* chosen,
                  const std::string& about, const std::vector<std::string>& names);

  /// Reads the command line. Returns an exit code if the program should end now: a bad flag, --help
  /// or --version.
  std::optional<int> Parse(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace slicefarm::rpc
