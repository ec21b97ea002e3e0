#include "processes/fdm/settings/plate_tool.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>

#include "absl/strings/escaping.h"
#include "common/base/error.h"
#include "common/base/text.h"

namespace slicefarm::config::fdm {
namespace {

using Settings = std::vector<Setting>;

constexpr std::string_view kTool = "extruder";
constexpr std::array<std::string_view, 3> kToolsOfLines = {"perimeter_extruder", "infill_extruder",
                                                           "solid_infill_extruder"};
constexpr double kMost = 255;

/// Tools for walls, infill and skins.
using Tools = std::array<int, 3>;

/// Names of the printed things, by tool, for messages to people.
using Uses = std::map<int, std::set<std::string>>;

/// Returns the tool number of a setting; 0: the tool of the enclosing scope.
absl::StatusOr<int> NumberOf(const Setting& setting) {
  const auto number = ToNumber(Trim(setting.value));
  if (number && *number >= 0 && *number <= kMost && *number == static_cast<int>(*number))
    return static_cast<int>(*number);
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
      fmt::format("{} = {}: must be a whole number, 0 to {}", setting.key, setting.value, kMost),
      {{"setting", setting.key}, {"value", setting.value}});
}

/// Returns the tools of a scope with settings `own` inside a scope with the tools `around`.
absl::StatusOr<Tools> Within(Tools around, const Settings& own) {
  Tools exact = {};
  int all = 0;
  for (const Setting& setting : own) {
    const auto line = std::ranges::find(kToolsOfLines, setting.key);
    if (setting.key != kTool && line == kToolsOfLines.end()) continue;
    const auto number = NumberOf(setting);
    if (!number.ok()) return number.status();
    (line == kToolsOfLines.end() ? all : exact[static_cast<size_t>(line - kToolsOfLines.begin())]) =
        *number;
  }
  for (size_t i = 0; i < around.size(); ++i) {
    if (all > 0) around[i] = all;
    if (exact[i] > 0) around[i] = exact[i];
  }
  return around;
}

void Add(const Tools& tools, const std::string& who, Uses& uses) {
  for (const int tool : tools) uses[tool].insert(who);
}

std::string QuotedName(const std::string& name) {
  return "\"" + absl::Utf8SafeCEscape(name) + "\"";
}

absl::Status AddObject(const SceneObject& object, const Tools& job, Uses& uses) {
  const auto tools = Within(job, object.settings);
  if (!tools.ok()) return tools.status();
  const std::string name = QuotedName(object.name);
  for (const Part& part : object.parts) {
    if (part.role != PartRole::kSolid && part.role != PartRole::kModifier) continue;
    const auto own = Within(*tools, part.settings);
    if (!own.ok()) return own.status();
    const bool counts = part.role == PartRole::kSolid || *own != *tools;
    const bool is_all = part.name.empty() || part.name == object.name || *own == *tools;
    if (counts) Add(*own, is_all ? name : name + ", " + QuotedName(part.name), uses);
    for (const HeightRange& range : object.ranges) {
      const auto there = Within(*own, range.settings);
      if (!there.ok()) return there.status();
      if (counts && *there != *own)
        Add(*there, fmt::format("{} from {} to {} mm", name, range.from_mm, range.to_mm), uses);
    }
  }
  return absl::OkStatus();
}

MissingFeature SeveralTools(const Uses& uses) {
  std::string text, objects;
  for (const auto& [tool, who] : uses) {
    std::string named;
    for (const std::string& one : who) named += (named.empty() ? "" : "; ") + one;
    text += fmt::format("{}extruder {}: {}", text.empty() ? "" : " | ", tool, named);
    objects += (objects.empty() ? "" : "; ") + named;
  }
  return {std::string(kSeveralTools),
          fmt::format("the plate needs several extruders, but a job prints with one extruder, here "
                      "number {}: {}",
                      uses.begin()->first, text),
          {{"setting", std::string(kTool)}, {"objects", objects}}};
}

void Drop(Settings& settings) {
  std::erase_if(settings, [](const Setting& setting) {
    return setting.key == kTool ||
           std::ranges::find(kToolsOfLines, setting.key) != kToolsOfLines.end();
  });
}

}  // namespace

absl::Status UnifyTool(std::vector<Setting>& job, std::vector<SceneObject>& objects,
                       std::vector<MissingFeature>& missing) {
  const auto tools = Within({1, 1, 1}, job);
  if (!tools.ok()) return tools.status();
  Uses uses;
  for (const SceneObject& object : objects) {
    if (!std::ranges::any_of(object.instances, &Instance::printable)) continue;
    if (absl::Status ok = AddObject(object, *tools, uses); !ok.ok()) return ok;
  }
  if (uses.size() > 1) missing.push_back(SeveralTools(uses));
  const int tool = uses.empty() ? tools->front() : uses.begin()->first;
  Source source = Source::kProfile;
  for (const Setting& setting : job)
    if (setting.key == kTool) source = setting.source;
  Drop(job);
  for (SceneObject& object : objects) {
    Drop(object.settings);
    for (Part& part : object.parts) Drop(part.settings);
    for (HeightRange& range : object.ranges) Drop(range.settings);
  }
  if (tool > 1) job.push_back({std::string(kTool), fmt::format("{}", tool), source});
  return absl::OkStatus();
}

}  // namespace slicefarm::config::fdm
