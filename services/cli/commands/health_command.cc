#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <string>

#include "common/base/error.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/client/client_security.h"
#include "common/rpc/client/health.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"

namespace slicefarm::cli {
namespace {

struct HealthOptions {
  std::string address;
  double timeout_s = 2;
  bool live = false;
  rpc::ClientSecurity security;
};

absl::Status NotServing(const std::string& address) {
  return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                   fmt::format("{} is not serving", address));
}

ExitCode CheckHealth(const HealthOptions& options, Interrupt& interrupt) {
  const auto connection = rpc::Secured({}, options.security, options.address);
  if (!connection.ok()) return Fail(connection.status());
  const auto serving = rpc::IsServing(
      rpc::MakeChannel(options.address, *connection), options.live ? rpc::kLiveService : "",
      {std::chrono::milliseconds(static_cast<int64_t>(options.timeout_s * 1000)),
       interrupt.Token()});
  if (const absl::Status outcome = serving.status(); !outcome.ok()) {
    const ErrorDetail detail = DetailOf(outcome);
    return Fail(MakeError(outcome.code(), detail.reason,
                          fmt::format("{}: {}{}", options.address, std::string(outcome.message()),
                                      rpc::ConnectionHint(outcome, options.security)),
                          detail.metadata));
  }
  if (!*serving) return Fail(NotServing(options.address));
  Print("serving\n");
  return ExitCode::kOk;
}

}  // namespace

void AddHealth(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand(
      "health", "Check whether a service of slicefarm is ready for jobs or calls");
  const auto options = std::make_shared<HealthOptions>();
  command->add_option("ADDRESS", options->address, "Address of a slicefarm service")
      ->required()
      ->type_name("HOST:PORT");
  command->add_option("--timeout", options->timeout_s, "Seconds to wait for the answer")
      ->check(InRange(0.01, 600.0))
      ->capture_default_str()
      ->type_name("S");
  command->add_flag("--live", options->live,
                    "Check only that the program runs, not that it can accept jobs or calls");
  rpc::AddTlsOptions(*command, &options->security);
  command->footer(
      "Exit code 0: serving; 5: not serving, or no answer; 2: your own certificate cannot be used. "
      "The command is meant for health checks of containers.");
  command->callback([options, &context] {
    context.run = [options, &context] { return CheckHealth(*options, *context.interrupt); };
  });
}

}  // namespace slicefarm::cli
