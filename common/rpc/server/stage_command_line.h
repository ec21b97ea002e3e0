#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/rpc/server/serve.h"

namespace slicefarm::rpc {

/// The command line of the server program of one stage: that of AddServeFlags, and what the stage
/// adds. The values that are pointed to are the defaults, and outlive Parse. CLI11 stays behind
/// this class: a compiler takes 5 s for it in each program that includes it.
class StageCommandLine {
 public:
  /// `name`: `beading` of slicefarm-beading. `about`: its line in --help.
  StageCommandLine(const std::string& name, const std::string& about, ServeFlags* flags);
  ~StageCommandLine();

  /// --max-concurrent: for programs whose calls each take one slot.
  void AddConcurrency(ServeFlags* flags);
  /// A whole number from `least` to `most`.
  void AddCount(const std::string& option, int* count, const std::string& about, int least,
                int most);
  /// One of `names`.
  void AddChoice(const std::string& option, std::string* name, const std::string& about,
                 const std::vector<std::string>& names);
  /// Some of `names`, by commas.
  void AddChoices(const std::string& option, std::vector<std::string>* chosen,
                  const std::string& about, const std::vector<std::string>& names);

  /// Returns the exit code if reading is all there was to do: a bad flag, --help or --version.
  std::optional<int> Parse(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace slicefarm::rpc
