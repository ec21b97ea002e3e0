#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/rpc/server/serve.h"

namespace slicefarm::rpc {

/// Command line of the server program of one stage: the options of AddServeFlags, and options that
/// the stage adds. The pointers must outlive Parse; the values to which they point are the
/// defaults. This header does not include CLI11, because CLI11 adds 5 s to the compilation of each
/// file that includes it.
class StageCommandLine {
 public:
  /// Creates a command line. `name`: for example `beading` for slicefarm-beading. `about`:
  /// description of the program in --help.
  StageCommandLine(const std::string& name, const std::string& about, ServeFlags* flags);
  ~StageCommandLine();

  /// Adds --max-concurrent, the number of calls that work at the same time.
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
