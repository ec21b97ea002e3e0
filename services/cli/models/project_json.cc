#include "services/cli/models/project_json.h"

#include <nlohmann/json.hpp>

#include "common/config/projects/project.h"

namespace slicefarm::cli {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson ToJson(const std::vector<Setting>& settings) {
  OrderedJson json = OrderedJson::object();
  for (const Setting& setting : settings) json[setting.key] = setting.value;
  return json;
}

OrderedJson ToJson(const Transform& transform) {
  OrderedJson json = OrderedJson::array();
  for (int i = 0; i < 12; ++i) json.push_back(transform(i / 4, i % 4));
  return json;
}

std::string_view RoleName(PartRole role) {
  switch (role) {
    case PartRole::kSolid:
      return "solid";
    case PartRole::kNegative:
      return "negative";
    case PartRole::kModifier:
      return "modifier";
    case PartRole::kSupportEnforcer:
      return "support_enforcer";
    case PartRole::kSupportBlocker:
      return "support_blocker";
    case PartRole::kSeamEnforcer:
      return "seam_enforcer";
    case PartRole::kSeamBlocker:
      return "seam_blocker";
  }
  return "unknown";
}

OrderedJson ToJson(const Part& part) {
  return {{"name", part.name},
          {"role", RoleName(part.role)},
          {"mesh", part.mesh.mesh},
          {"first_triangle", part.mesh.first_triangle},
          {"triangle_count", part.mesh.triangle_count},
          {"to_object", ToJson(part.to_object)},
          {"settings", ToJson(part.settings)}};
}

OrderedJson ToJson(const SceneObject& object) {
  OrderedJson json = {{"name", object.name}, {"settings", ToJson(object.settings)}};
  json["parts"] = OrderedJson::array();
  for (const Part& part : object.parts) json["parts"].push_back(ToJson(part));
  json["height_ranges"] = OrderedJson::array();
  for (const HeightRange& range : object.ranges)
    json["height_ranges"].push_back(
        {{"from_mm", range.from_mm}, {"to_mm", range.to_mm}, {"settings", ToJson(range.settings)}});
  json["copies"] = OrderedJson::array();
  for (const Instance& instance : object.instances)
    json["copies"].push_back({{"printable", instance.printable},
                              {"placed", instance.placed},
                              {"to_plate", ToJson(instance.to_plate)}});
  return json;
}

std::vector<ProjectPlate> PlatesOf(const Project& project) {
  if (!project.plates.empty()) return project.plates;
  ProjectPlate all;
  for (size_t object = 0; object < project.objects.size(); ++object)
    for (size_t copy = 0; copy < project.objects[object].instances.size(); ++copy)
      all.members.push_back({static_cast<int32_t>(object), static_cast<int32_t>(copy)});
  return {all};
}

OrderedJson ToJson(const ProjectPlate& plate, size_t number) {
  OrderedJson json = {
      {"number", number}, {"name", plate.name}, {"settings", ToJson(plate.settings)}};
  json["objects"] = OrderedJson::array();
  for (const ProjectPlate::Member& member : plate.members)
    json["objects"].push_back({{"object", member.object}, {"copy", member.instance}});
  return json;
}

}  // namespace

std::string ProjectJson(const Project& given) {
  const Project project = config::InPrusaNames(given);
  OrderedJson json = {{"application", project.application},
                      {"settings", ToJson(project.settings)},
                      {"without_effect", project.without_effect},
                      {"painted_objects", project.painted}};
  json["objects"] = OrderedJson::array();
  for (const SceneObject& object : project.objects) json["objects"].push_back(ToJson(object));
  json["plates"] = OrderedJson::array();
  const std::vector<ProjectPlate> plates = PlatesOf(project);
  for (size_t i = 0; i < plates.size(); ++i) json["plates"].push_back(ToJson(plates[i], i + 1));
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace slicefarm::cli
