#include "common/rpc/server/stage_command_line.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>

namespace slicefarm::rpc {

StageCommandLine::StageCommandLine(const std::string& name, const std::string& about,
                                   ServeFlags* flags)
    : app_(std::make_unique<CLI::App>(
          fmt::format("slicefarm-{}: {}, as a gRPC service", name, about))) {
  AddServeFlags(*app_, flags);
}

StageCommandLine::~StageCommandLine() = default;

void StageCommandLine::AddConcurrency(ServeFlags* flags) {
  AddCount("--max-concurrent", &flags->max_concurrent,
           "Number of calls that run at the same time; 0: one for each core", 0, 1024);
}

void StageCommandLine::AddCount(const std::string& option, int* count, const std::string& about,
                                int least, int most) {
  app_->add_option(option, *count, about)->check(CLI::Range(least, most))->capture_default_str();
}

void StageCommandLine::AddChoice(const std::string& option, std::string* name,
                                 const std::string& about, const std::vector<std::string>& names) {
  app_->add_option(option, *name, about)->check(CLI::IsMember(names))->capture_default_str();
}

void StageCommandLine::AddChoices(const std::string& option, std::vector<std::string>* chosen,
                                  const std::string& about, const std::vector<std::string>& names) {
  app_->add_option(option, *chosen, about)->delimiter(',')->check(CLI::IsMember(names));
}

std::optional<int> StageCommandLine::Parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app_->exit(error);
  }
  return std::nullopt;
}

}  // namespace slicefarm::rpc
