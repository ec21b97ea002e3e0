#include <fmt/core.h>
#include <openssl/rand.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "absl/time/time.h"
#include "common/base/sha256.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"

namespace slicefarm::cli {
namespace {

struct TokenOptions {
  std::vector<std::string> scopes;
  std::string expires;
};

/// Returns a token of 256 random bits, with a prefix that identifies it to people and to scanners
/// for leaked secrets.
std::string NewToken() {
  std::array<unsigned char, 32> bytes;
  if (RAND_bytes(bytes.data(), bytes.size()) != 1) std::abort();
  std::string token = "sf_";
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

std::string CheckTime(const std::string& text) {
  absl::Time time;
  std::string error;
  if (absl::ParseTime(absl::RFC3339_full, text, &time, &error)) return "";
  return "not a time such as 2027-01-31T12:00:00Z";
}

ExitCode Make(const TokenOptions& options) {
  const std::string token = NewToken();
  nlohmann::ordered_json entry = {{"sha256", Sha256Hex(token)}, {"scopes", options.scopes}};
  if (options.scopes.empty()) entry["scopes"] = {"submit", "read"};
  if (!options.expires.empty()) entry["expires"] = options.expires;
  Print(fmt::format("{}\n{}\n", token, entry.dump()));
  return ExitCode::kOk;
}

}  // namespace

void AddToken(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("token", "Make a token for a tenant of a farm");
  const auto options = std::make_shared<TokenOptions>();
  command
      ->add_option("--scope", options->scopes,
                   "Permission of the token. submit: create and change jobs. read: see jobs and "
                   "fetch results. admin: see and cancel the jobs of all tenants, export and erase "
                   "tenants. May be repeated. Default: submit and read")
      ->check(OneOf(std::vector<std::string>{"submit", "read", "admin"}))
      ->allow_extra_args(false);
  command
      ->add_option("--expires", options->expires, "Time at which the token expires; default: never")
      ->check(CheckTime)
      ->type_name("TIME");
  command->footer(
      "Prints two lines: the token for the client, which is not stored anywhere, and an entry for "
      "the\n\"tokens\" of the tenant in the coordinator's --tenants file, which does not reveal "
      "the token.\nExample:\n  slicefarm token --expires 2027-01-31T12:00:00Z");
  command->callback([options, &context] { context.run = [options] { return Make(*options); }; });
}

}  // namespace slicefarm::cli
