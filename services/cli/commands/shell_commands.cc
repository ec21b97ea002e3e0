// Help for writing command lines: help, completion, a manual page. All are made from the parser's
// commands and options.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "common/base/build_info.h"
#include "common/base/text.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {
namespace {

struct HelpOptions {
  std::vector<std::string> words;
};

struct CompletionOptions {
  std::string shell;
};

std::vector<const CLI::App*> CommandsOf(const CLI::App& app) {
  std::vector<const CLI::App*> all;
  for (const CLI::App* each : app.get_subcommands({})) all.push_back(each);
  return all;
}

std::string NamesOfAll(const std::vector<const CLI::App*>& commands) {
  return absl::StrJoin(commands, " ",
                       [](std::string* out, const CLI::App* each) { *out += each->get_name(); });
}

std::string OptionsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return absl::StrJoin(names, " ");
}

/// Returns the completion script. The word after a command is one of its own commands, an option,
/// or a file. zsh uses the same script through bashcompinit.
std::string BashScript(const CLI::App& app) {
  std::string cases;
  for (const CLI::App* command : CommandsOf(app)) {
    std::string options = OptionsOf(*command);
    const auto inner = CommandsOf(*command);
    for (const CLI::App* each : inner) options += " " + OptionsOf(*each);
    cases += fmt::format("    {}) options='{}' commands='{}' ;;\n", command->get_name(), options,
                         NamesOfAll(inner));
  }
  return fmt::format(R"(_slicefarm() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} options='' commands=''
  if [[ $COMP_CWORD -eq 1 ]]; then
    COMPREPLY=($(compgen -W '{} --help --version' -- "$word"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  elif [[ $COMP_CWORD -eq 2 && -n $commands ]]; then
    COMPREPLY=($(compgen -W "$commands" -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}}
complete -o filenames -F _slicefarm slicefarm
)",
                     NamesOfAll(CommandsOf(app)), cases);
}

std::string Quoted(const std::string& text) {
  return "'" + absl::StrReplaceAll(text, {{"\\", "\\\\"}, {"'", "\\'"}}) + "'";
}

std::string FishScript(const CLI::App& app) {
  std::string text = "complete -c slicefarm -n __fish_use_subcommand -l help -l version\n";
  for (const CLI::App* command : CommandsOf(app)) {
    text += fmt::format("complete -c slicefarm -f -n __fish_use_subcommand -a {} -d {}\n",
                        command->get_name(), Quoted(command->get_description()));
    const std::string seen = fmt::format("'__fish_seen_subcommand_from {}'", command->get_name());
    for (const CLI::App* inner : CommandsOf(*command))
      text += fmt::format("complete -c slicefarm -f -n {} -a {} -d {}\n", seen, inner->get_name(),
                          Quoted(inner->get_description()));
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames())
        text += fmt::format("complete -c slicefarm -n {} -l {} -d {}\n", seen, name,
                            Quoted(option->get_description()));
  }
  return text;
}

/// Escapes text so that roff prints it unchanged.
std::string Roff(const std::string& text) {
  std::string lines;
  for (const std::string_view line : Split(text, "\n")) {
    if (line.starts_with('.') || line.starts_with('\'')) lines += "\\&";
    lines += absl::StrReplaceAll(std::string(line), {{"\\", "\\e"}, {"-", "\\-"}});
    lines += '\n';
  }
  return lines;
}

std::string ManualOf(const CLI::App& command) {
  std::string text =
      fmt::format(".SS {}\n{}", Roff(command.get_name()), Roff(command.get_description() + "."));
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_name() == "--help") continue;
    const std::string name(Trim(Roff(option->get_name(true))));
    text += fmt::format(".TP\n\\fB{}\\fR\n{}", name, Roff(option->get_description()));
  }
  for (const CLI::App* inner : CommandsOf(command)) text += ManualOf(*inner);
  return text;
}

std::string Manual(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH SLICEFARM 1 \"\" \"slicefarm {}\"\n.SH NAME\nslicefarm \\- {}.SH SYNOPSIS\n"
      "\\fBslicefarm\\fR COMMAND [OPTIONS]\n.SH DESCRIPTION\n.nf\n{}.fi\n.SH COMMANDS\n",
      std::string(Version()), Roff("slices 3D models for print farms"),
      Roff(app.get_description() + "\n\n" + app.get_footer()));
  for (const CLI::App* command : CommandsOf(app)) text += ManualOf(*command);
  return text;
}

ExitCode Help(const CLI::App& app, const HelpOptions& options) {
  const CLI::App* command = &app;
  std::string call = app.get_name();
  for (const std::string& word : options.words) {
    const auto inner = CommandsOf(*command);
    std::vector<std::string> names;
    const CLI::App* found = nullptr;
    for (const CLI::App* each : inner) {
      names.push_back(each->get_name());
      if (each->get_name() == word) found = each;
    }
    if (found == nullptr) return Fail(Malformed("help: " + NoSuchChoice(word, names)));
    command = found;
    call += " " + word;
  }
  // App::help() would print the help of the running command, and here another command's help is
  // needed.
  Print(command->get_formatter()->make_help(command, call, CLI::AppFormatMode::Normal));
  return ExitCode::kOk;
}

}  // namespace

void AddHelp(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("help", "Explain the program or a command");
  const auto options = std::make_shared<HelpOptions>();
  command->add_option("COMMAND", options->words,
                      "Command to explain, such as `slicefarm help profile put`");
  command->callback(
      [options, &app, &context] { context.run = [options, &app] { return Help(app, *options); }; });
}

void AddCompletion(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("completion", "Print a completion script for a shell, or the manual page");
  const auto options = std::make_shared<CompletionOptions>();
  command->add_option("SHELL", options->shell, "Shell of the script; man: the manual page, as roff")
      ->required()
      ->check(OneOf(std::vector<std::string>{"bash", "zsh", "fish", "man"}));
  command->footer(
      "Examples:\n"
      "  source <(slicefarm completion bash)\n"
      "  autoload -U bashcompinit && bashcompinit && source <(slicefarm completion zsh)\n"
      "  slicefarm completion fish > ~/.config/fish/completions/slicefarm.fish\n"
      "  slicefarm completion man | man -l -");
  command->callback([options, &app, &context] {
    context.run = [options, &app] {
      Print(options->shell == "man"    ? Manual(app)
            : options->shell == "fish" ? FishScript(app)
                                       : BashScript(app));
      return ExitCode::kOk;
    };
  });
}

}  // namespace slicefarm::cli
