#include "services/cli/job_options.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "common/config/ini.h"
#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/model/placement.h"
#include "common/base/text.h"
#include "common/rpc/utf8.h"
#include "services/cli/files.h"

namespace slicefarm::cli {
namespace {

constexpr int64_t kMaxConfigBytes = 512 << 20;  // a G-code file that quotes its settings is big

absl::Status Malformed(const std::string& message) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed, message);
}

/// `count` numbers between commas.
absl::StatusOr<std::vector<double>> Numbers(std::string_view option, std::string_view text,
                                            size_t count) {
  std::vector<double> numbers;
  for (const std::string_view item : Split(text, ",")) {
    const auto number = ToNumber(Trim(item));
    if (!number.has_value()) break;
    numbers.push_back(*number);
  }
  if (numbers.size() != count || Split(text, ",").size() != count) {
    return Malformed(
        fmt::format("{} {}: {} numbers between commas are needed", option, text, count));
  }
  return numbers;
}

absl::StatusOr<std::array<double, 3>> ScaleOf(const std::string& text) {
  if (text.empty()) return std::array<double, 3>{1, 1, 1};
  const bool uniform = text.find(',') == std::string::npos;
  const auto numbers = Numbers("--scale", text, uniform ? 1 : 3);
  if (!numbers.ok()) return numbers.status();
  const auto at = [&](size_t i) { return (*numbers)[uniform ? 0 : i]; };
  const std::array<double, 3> scale = {at(0), at(1), at(2)};
  for (const double factor : scale) {
    if (factor <= 0) return Malformed(fmt::format("--scale {}: it must be more than 0", text));
  }
  return scale;
}

double UnitOf(const std::string& name) {
  if (name == "inch") return 25.4;
  if (name == "m") return 1000;
  if (name == "cm") return 10;
  return 1;
}

absl::StatusOr<config::Setting> ParseSet(std::string_view option, const std::string& text) {
  const size_t equals = text.find('=');
  const std::string key(Trim(std::string_view(text).substr(0, equals)));
  if (equals == std::string::npos || key.empty()) {
    return Malformed(fmt::format("{} {}: key=value is needed", option, text));
  }
  return config::Setting{key, text.substr(equals + 1), config::Source::kRequest};
}

/// Settings travel and are reported as UTF-8.
absl::Status CheckText(const config::Setting& setting) {
  if (rpc::IsUtf8(setting.key) && rpc::IsUtf8(setting.value)) return absl::OkStatus();
  const std::string key = rpc::ToUtf8(setting.key, limits::kMaxNameBytes);
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   fmt::format("{}: is not UTF-8 text", key), {{"setting", key}});
}

/// A file's name as a part's: it goes over the wire as UTF-8, and into G-code comments, where a
/// line end would begin a command.
std::string PartName(std::string_view file) {
  return ReplaceControls(rpc::ToUtf8(file, limits::kMaxNameBytes), '?');
}

std::string NameOf(const std::string& path) {
  return PartName(std::string_view(path).substr(path.rfind('/') + 1));  // npos + 1: the whole
}

absl::StatusOr<Placement> PlacementOf(const JobOptions& options) {
  Placement placement;
  placement.unit_mm = UnitOf(options.units);
  const auto scale = ScaleOf(options.scale);
  if (!scale.ok()) return scale.status();
  placement.scale = *scale;
  placement.rotate_deg = {0, 0, options.rotate_z_deg};
  if (!std::isfinite(options.rotate_z_deg)) return Malformed("--rotate-z: not a number");
  if (!options.rotate.empty()) {
    const auto angles = Numbers("--rotate", options.rotate, 3);
    if (!angles.ok()) return angles.status();
    placement.rotate_deg = {(*angles)[0], (*angles)[1], (*angles)[2]};
  }
  for (const std::string& text : options.centers) {
    const auto center = Numbers("--center", text, 2);
    if (!center.ok()) return center.status();
    const double limit = ToMm(limits::kMaxCoord);
    if (std::abs((*center)[0]) > limit || std::abs((*center)[1]) > limit) {
      return Malformed(fmt::format("--center {}: more than {} mm from the origin", text, limit));
    }
    placement.centers.push_back({FromMm((*center)[0]), FromMm((*center)[1])});
  }
  return placement;
}

absl::StatusOr<MeshFile> ReadModel(const std::string& path) {
  auto bytes = ReadFile(path, limits::kMaxMeshBytes);
  if (!bytes.ok()) {
    const ErrorDetail detail = DetailOf(bytes.status());
    if (detail.reason != Reason::kRequestTooLarge) return bytes.status();
    return MakeError(bytes.status().code(), Reason::kMeshTooLarge,
                     std::string(bytes.status().message()), detail.metadata);
  }
  return MeshFile{.name = NameOf(path), .bytes = *std::move(bytes)};
}

/// What is said of one model on the command line: `MODEL=...`, MODEL by path or by name.
struct OfModel {
  std::string model;
  std::string what;
};

OfModel TakeApart(const std::string& text, char separator, const JobOptions& options) {
  // A path may hold the separator: the longest model that fits is meant.
  OfModel best;
  for (const std::string& path : options.models) {
    for (const std::string& model : {path, NameOf(path)}) {
      if (!text.starts_with(model + separator) || model.size() <= best.model.size()) continue;
      best = {model, text.substr(model.size() + 1)};
    }
  }
  return best;
}

bool Names(const OfModel& of, const std::string& path) {
  return of.model == path || of.model == NameOf(path);
}

absl::StatusOr<int> CountOf(const std::string& text, const OfModel& of) {
  const auto count = ToNumber(Trim(of.what));
  if (of.model.empty() || !count || *count != std::floor(*count) || *count < 1 ||
      *count > limits::kMaxObjects) {
    return Malformed(fmt::format("--copies {}: MODEL=N is needed, with one of the models and a "
                                 "number from 1 to {}",
                                 text, limits::kMaxObjects));
  }
  return static_cast<int>(*count);
}

/// 0: none are asked for.
absl::StatusOr<int> CopiesOf(const JobOptions& options, const std::string& path) {
  int copies = 0;
  for (const std::string& text : options.copies) {
    const OfModel of = TakeApart(text, '=', options);
    const auto count = CountOf(text, of);
    if (!count.ok()) return count.status();
    if (!options.centers.empty()) return Malformed("--copies and --center exclude each other");
    if (Names(of, path)) copies = *count;
  }
  return copies;
}

absl::StatusOr<std::vector<Setting>> SettingsOf(const JobOptions& options,
                                                const std::string& path) {
  std::vector<Setting> settings;
  for (const std::string& text : options.object_sets) {
    const OfModel of = TakeApart(text, ':', options);
    if (of.model.empty()) {
      return Malformed(fmt::format("--object-set {}: MODEL:key=value is needed, with one of the "
                                   "models",
                                   text));
    }
    if (!Names(of, path)) continue;
    const auto setting = ParseSet("--object-set", of.what);
    if (!setting.ok()) return setting.status();
    if (absl::Status ok = CheckText(*setting); !ok.ok()) return ok;
    settings.push_back(*setting);
  }
  return settings;
}

}  // namespace

void AddSettingOptions(CLI::App& app, SettingOptions& options) {
  app.add_option("-c,--config", options.config_files,
                 "PrusaSlicer config.ini, or a G-code file that quotes its settings; of several, "
                 "later ones win")
      ->type_name("FILE.ini")
      ->allow_extra_args(false);
  app.add_option("-s,--set", options.sets, "One setting; wins over --config. May be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void AddJobOptions(CLI::App& app, JobOptions& options) {
  app.add_option("MODEL", options.models,
                 "STL (binary or ASCII), OBJ or PLY file; several: a plate of them")
      ->required();
  AddSettingOptions(app, options);
  app.add_option("--copies", options.copies, "How often a model is printed; may be repeated")
      ->type_name("MODEL=N")
      ->allow_extra_args(false);
  app.add_option("--object-set", options.object_sets,
                 "A setting of one model alone; may be repeated")
      ->type_name("MODEL:KEY=VALUE")
      ->allow_extra_args(false);
  app.add_option("--units", options.units, "What a unit of the model means")
      ->check(CLI::IsMember({"mm", "cm", "m", "inch"}))
      ->capture_default_str();
  app.add_option("--scale", options.scale, "Factor, or one for each axis")->type_name("S|X,Y,Z");
  auto* rotate_z = app.add_option("--rotate-z", options.rotate_z_deg,
                                  "Turn about the vertical, counter-clockwise")
                       ->type_name("DEG");
  app.add_option("--rotate", options.rotate, "Turn about x, then y, then z")
      ->type_name("X,Y,Z")
      ->excludes(rotate_z);
  auto* center = app.add_option("--center", options.centers,
                                "Where the middle of the part lies, mm; repeated: a copy at each. "
                                "Default: the middle of the bed; several parts: arranged")
                     ->type_name("X,Y")
                     ->allow_extra_args(false);
  app.add_flag("--arrange")
      ->description("Find places for all parts and copies, as without --center")
      ->excludes(center);
  app.add_option("--report", options.report, "Write what came out as JSON; -: to stdout")
      ->type_name("REPORT.json");
  app.add_flag("-q,--quiet", options.quiet, "No progress, no summary; warnings and errors only");
}

absl::StatusOr<std::vector<config::Setting>> GivenSettings(const SettingOptions& options) {
  std::vector<config::Setting> settings;
  for (const std::string& path : options.config_files) {
    const auto text = ReadFile(path, kMaxConfigBytes);
    if (!text.ok()) return text.status();
    auto read = config::ReadIni(*text);
    if (!read.ok()) return InFile(path, read.status());
    settings.insert(settings.end(), read->begin(), read->end());
  }
  for (const std::string& text : options.sets) {
    auto setting = ParseSet("--set", text);
    if (!setting.ok()) return setting.status();
    settings.push_back(*std::move(setting));
  }
  for (const config::Setting& setting : settings) {
    if (absl::Status ok = CheckText(setting); !ok.ok()) return ok;
  }
  return settings;
}

absl::StatusOr<GivenModels> ReadModels(const JobOptions& options) {
  GivenModels given;
  const auto placement = PlacementOf(options);
  if (!placement.ok()) return placement.status();
  if (absl::Status ok = CheckPlacement(*placement); !ok.ok()) return ok;
  std::map<std::string, int32_t> files;  // by path
  for (const std::string& path : options.models) {
    const auto [file, is_new] = files.try_emplace(path, static_cast<int32_t>(given.files.size()));
    if (is_new) {
      auto read = ReadModel(path);
      if (!read.ok()) return read.status();
      given.files.push_back(*std::move(read));
    }
    const auto copies = CopiesOf(options, path);
    if (!copies.ok()) return copies.status();
    auto settings = SettingsOf(options, path);
    if (!settings.ok()) return settings.status();
    given.objects.push_back({NameOf(path), file->second, *placement, *copies, *std::move(settings)});
  }
  return given;
}

std::vector<SceneObject> SceneOf(const GivenModels& given) {
  std::vector<SceneObject> scene;
  for (const GivenObject& object : given.objects) {
    scene.push_back(ObjectOfFile(object.name, object.file, object.placement, object.copies));
    scene.back().settings = object.settings;
  }
  return scene;
}

}  // namespace slicefarm::cli
