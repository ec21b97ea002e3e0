#include "services/cli/console/parse_errors.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "absl/strings/str_join.h"
#include "common/config/table/settings_table.h"
#include "common/config/table/suggest.h"
#include "common/model/process.h"

namespace slicefarm::cli {
namespace {

/// Returns the given command, or the program if there is none.
const CLI::App& Given(const CLI::App& app) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  return given.empty() ? app : Given(*given.front());
}

/// Returns the call of a command, such as "slicefarm profile put".
std::string CallOf(const CLI::App& command) {
  const CLI::App* const parent = command.get_parent();
  return parent == nullptr ? command.get_name() : CallOf(*parent) + " " + command.get_name();
}

std::vector<std::string> LongOptions(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> Commands(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* each : command.get_subcommands({})) names.push_back(each->get_name());
  return names;
}

std::string NearestOf(std::string_view word, const std::vector<std::string>& names) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  return config::Nearest(word, views);
}

bool Has(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

/// Returns the setting that was written as an option, for example `--layer-height`; empty if there
/// is none.
std::string SettingOf(std::string_view option) {
  std::string key(option.substr(std::min(option.find_first_not_of('-'), option.size())));
  std::ranges::replace(key, '-', '_');
  for (const ProcessInfo& info : kProcesses)
    if (config::FindSetting(key, info.process) >= 0) return key;
  return config::NearestSetting(key, kDefaultProcess);
}

/// Appends the commands that have the option, each in backquotes.
void AddOwners(const CLI::App& app, const std::string& option, std::vector<std::string>& owners) {
  for (const CLI::App* command : app.get_subcommands({})) {
    if (Has(LongOptions(*command), option))
      owners.push_back("`" + CallOf(*command) + "`");
    else
      AddOwners(*command, option, owners);
  }
}

std::string UnknownOption(const CLI::App& app, const CLI::App& command, const std::string& given) {
  const std::string option = given.substr(0, given.find('='));
  const std::vector<std::string> options = LongOptions(command);
  std::string text = fmt::format("{} has no option {}", CallOf(command), option);
  if (option.size() < 3 || !option.starts_with("--")) return text;
  std::vector<std::string> owners;
  AddOwners(app, option, owners);
  const std::string nearest = NearestOf(option, options);
  const std::string setting = Has(options, "--set") ? SettingOf(option) : "";
  const auto edits = [&](std::string_view name) { return config::EditDistance(option, name); };
  std::string as_option = "--" + setting;
  std::ranges::replace(as_option, '_', '-');
  const bool is_setting = as_option == option || "--" + setting == option;
  if (!owners.empty() && !is_setting)
    return text + "; commands with this option: " + absl::StrJoin(owners, ", ");
  if (!setting.empty() && (nearest.empty() || edits(as_option) < edits(nearest)))
    return text + fmt::format("; do you mean --set {}=VALUE?", setting);
  return nearest.empty() ? text : text + fmt::format("; do you mean {}?", nearest);
}

std::string UnknownCommand(const CLI::App& command, const std::string& word) {
  const std::vector<std::string> commands = Commands(command);
  const std::string nearest = NearestOf(word, commands);
  return fmt::format("{} has no command '{}'{}", CallOf(command), word,
                     nearest.empty() ? "" : fmt::format("; do you mean {}?", nearest));
}

std::string Unexpected(const CLI::App& app, const CLI::App& command,
                       const std::vector<std::string>& rest, const std::string& otherwise) {
  if (rest.empty()) return otherwise;
  const auto option =
      std::ranges::find_if(rest, [](const std::string& each) { return each.starts_with('-'); });
  if (option != rest.end()) return UnknownOption(app, command, *option);
  if (!command.get_subcommands({}).empty()) return UnknownCommand(command, rest.front());
  return fmt::format("{} takes no '{}'", CallOf(command), rest.front());
}

}  // namespace

std::string ParseErrorText(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = Given(app);
  std::string text = error.what();
  const std::vector<std::string> rest = app.remaining(/*recurse=*/true);
  const bool wants_command = command.get_require_subcommand_min() > 0;
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
      (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && !rest.empty())) {
    text = Unexpected(app, command, rest, text);
  } else if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && wants_command) {
    text = fmt::format("{}: a command is missing", CallOf(command));
  } else if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    text = fmt::format("{}: {}", CallOf(command), text);
  } else if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {
    text = fmt::format("{} (a number is needed)", text);
  }
  return fmt::format("{}\n       `{} --help` shows how", text, CallOf(command));
}

}  // namespace slicefarm::cli
