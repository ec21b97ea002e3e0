// Subcommands of `presets` that change the presets of a farm.
#include <fmt/core.h>
#include <google/protobuf/util/time_util.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/base/revision_ref.h"
#include "common/config/presets/read_presets.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console/console.h"
#include "services/cli/farm/farm_presets.h"
#include "services/cli/farm/jobs_client.h"
#include "services/cli/farm/json_text.h"
#include "services/cli/farm/server_options.h"
#include "services/cli/job/job_options.h"
#include "services/cli/models/preset_sources.h"

namespace slicefarm::cli {
namespace {

struct FarmPresetsOptions {
  ServerOptions server;
  std::vector<std::string> sources;
  std::string name;
  bool json = false;
};

/// Makes the paths of the files relative to their source, so that bundles do not depend on where
/// the source is.
absl::StatusOr<std::vector<config::presets::PresetFile>> FilesOf(const std::string& source) {
  auto files = ReadPresetFiles({source});
  if (!files.ok()) return files.status();
  std::error_code error;
  const bool folder = std::filesystem::is_directory(source, error);
  const std::filesystem::path path(source);
  const std::filesystem::path base = folder ? path : path.parent_path();
  for (config::presets::PresetFile& file : *files)
    file.path = std::filesystem::path(file.path)
                    .lexically_relative(base.empty() ? "." : base)
                    .generic_string();
  return files;
}

ExitCode Import(FarmPresetsOptions options, Interrupt& interrupt) {
  std::vector<config::presets::PresetFile> files;
  for (const std::string& source : options.sources) {
    auto read = FilesOf(source);
    if (!read.ok()) return Fail(read.status());
    std::ranges::move(*read, std::back_inserter(files));
  }
  std::vector<BundleFiles> bundles;
  if (options.name.empty()) {
    bundles = BundlesOf(std::move(files), "user");
  } else {
    bundles.push_back({options.name, std::move(files)});
  }
  JobsClient client(ClientOptions(options.server, &interrupt));
  for (const BundleFiles& bundle : bundles) {
    // Folders of programs also have lists without presets, such as blacklist.json.
    const auto set = config::presets::ReadPresets(bundle.files);
    if (!set.ok() && bundles.size() > 1) {
      Warn({fmt::format("{} is not imported: {}", bundle.name,
                        std::string(set.status().message()))});
      continue;
    }
    const auto request = ImportRequest(bundle);
    if (!request.ok()) return Fail(request.status());
    const auto made = client.ImportPresets(*request);
    if (!made.ok()) return Fail(InFile(bundle.name, made.status()));
    Warn({made->problems().begin(), made->problems().end()});
    Print(options.json ? JsonLine(*made) + "\n"
                       : fmt::format("{}@{}: {} presets\n", made->name(), made->revision(),
                                     made->presets()));
  }
  return ExitCode::kOk;
}

ExitCode ListBundles(FarmPresetsOptions options, Interrupt& interrupt) {
  using google::protobuf::util::TimeUtil;
  JobsClient client(ClientOptions(options.server, &interrupt));
  std::string text = fmt::format("{:<40}  {:>8}  {}\n", "BUNDLE", "REVISION", "CREATED");
  if (options.json) text.clear();
  v1::ListPresetBundlesRequest request;
  do {
    const auto page = client.ListPresetBundles(request);
    if (!page.ok()) return Fail(page.status());
    for (const v1::PresetBundle& bundle : page->bundles()) {
      google::protobuf::Timestamp created = bundle.create_time();
      created.set_nanos(0);
      text += options.json ? JsonLine(bundle) + "\n"
                           : fmt::format("{:<40}  {:>8}  {}\n", bundle.name(), bundle.revision(),
                                         TimeUtil::ToString(created));
    }
    request.set_page_token(page->next_page_token());
  } while (!request.page_token().empty());
  Print(text);
  return ExitCode::kOk;
}

ExitCode DeleteBundle(FarmPresetsOptions options, Interrupt& interrupt) {
  const auto of = ParseRevisionRef(options.name);
  if (!of.ok()) return Fail(of.status());
  v1::DeletePresetBundleRequest request;
  request.set_name(of->name);
  request.set_revision(of->revision);
  JobsClient client(ClientOptions(options.server, &interrupt));
  const absl::Status deleted = client.DeletePresetBundle(request);
  return deleted.ok() ? ExitCode::kOk : Fail(deleted);
}

CLI::App* AddBundleCommand(CLI::App& parent, const char* name, const char* about,
                           const std::shared_ptr<FarmPresetsOptions>& options,
                           CommandContext& context,
                           ExitCode (*run)(FarmPresetsOptions, Interrupt&)) {
  CLI::App* command = parent.add_subcommand(name, about);
  AddServerOptions(*command, options->server);
  command->callback([options, &context, run] {
    context.run = [options, &context, run] { return run(*options, *context.interrupt); };
  });
  return command;
}

}  // namespace

void AddFarmPresets(CLI::App& presets, CommandContext& context) {
  const auto options = std::make_shared<FarmPresetsOptions>();
  CLI::App* import = AddBundleCommand(
      presets, "import", "Store presets on the farm, and print NAME@REVISION of each bundle",
      options, context, Import);
  import
      ->add_option("DIR|FILE", options->sources,
                   "Folder or file of presets, as in `slice --presets`")
      ->required();
  import
      ->add_option("--name", options->name,
                   "Name of one bundle that gets all files. Default: one bundle for each vendor, "
                   "and the bundle `user` for all other files")
      ->type_name("NAME");
  import->add_flag("--json", options->json, "Print each bundle as one line of JSON");
  AddBundleCommand(presets, "bundles", "List the bundles of presets that the farm stores", options,
                   context, ListBundles)
      ->add_flag("--json", options->json, "Print each bundle as one line of JSON");
  AddBundleCommand(presets, "delete",
                   "Remove a bundle; jobs that were made with the bundle do not change", options,
                   context, DeleteBundle)
      ->add_option("NAME", options->name, "Bundle, or NAME@REVISION for one revision")
      ->required();
}

}  // namespace slicefarm::cli
