#include "services/slicing/algo/mesh_io/threemf/settings/object_settings.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"
#include "services/slicing/algo/mesh_io/threemf/settings/names.h"
#include "services/slicing/algo/mesh_io/threemf/settings/setting_list.h"

namespace slicefarm::slicing::threemf {
namespace {

struct RoleName {
  std::string_view name;
  PartRole role;
};

constexpr std::array<RoleName, 14> kRoles = {{{"ModelPart", PartRole::kSolid},
                                              {"NegativeVolume", PartRole::kNegative},
                                              {"ParameterModifier", PartRole::kModifier},
                                              {"SupportEnforcer", PartRole::kSupportEnforcer},
                                              {"SupportBlocker", PartRole::kSupportBlocker},
                                              {"normal_part", PartRole::kSolid},
                                              {"negative_part", PartRole::kNegative},
                                              {"modifier_part", PartRole::kModifier},
                                              {"support_enforcer", PartRole::kSupportEnforcer},
                                              {"support_blocker", PartRole::kSupportBlocker},
                                              {"SeamEnforcer", PartRole::kSeamEnforcer},
                                              {"SeamBlocker", PartRole::kSeamBlocker},
                                              {"seam_enforcer", PartRole::kSeamEnforcer},
                                              {"seam_blocker", PartRole::kSeamBlocker}}};

/// Keys that slicers store for themselves beside the settings.
constexpr std::array<std::string_view, 24> kNotes = {
    "matrix",           "source_file",     "source_object_id",  "source_volume_id",
    "source_offset_x",  "source_offset_y", "source_offset_z",   "source_in_inches",
    "source_in_meters", "thumbnail_file",  "top_file",          "thumbnail_no_light_file",
    "pick_file",        "gcode_file",      "pattern_file",      "pattern_bbox_file",
    "identify_id",      "module",          "mesh_shared",       "source_is_builtin_volume",
    "from_other_file",  "text_info",       "filament_map_mode", "filament_maps"};

absl::StatusOr<int64_t> NumberOf(std::optional<std::string_view> text, std::string_view name) {
  int64_t number = 0;
  if (text) {
    const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), number);
    if (error == std::errc() && end == text->data() + text->size() && number >= 0) return number;
  }
  return Malformed(fmt::format("`{}` is missing or not a whole number", name));
}

absl::StatusOr<ResourceId> IdOf(std::optional<std::string_view> text, std::string_view name) {
  const absl::StatusOr<int64_t> number = NumberOf(text, name);
  if (!number.ok()) return number.status();
  if (*number == 0 || *number > INT32_MAX)
    return Malformed(fmt::format("`{}` is not a number from 1 to {}", name, INT32_MAX));
  return static_cast<ResourceId>(*number);
}

bool IsYes(std::string_view text) { return text == "1" || text == "true"; }

class ModelSettingsHandler : public XmlHandler {
 public:
  absl::Status Start(std::string_view name, XmlAttributes attributes, int64_t line) override {
    absl::Status status;
    if (path_.size() == 1 && name == "object") status = Object(attributes);
    if (path_.size() == 1 && name == "plate") status = Plate();
    if (In("object", 2) && (name == "volume" || name == "part"))
      status = Part(name, attributes, line);
    if (In("plate", 2) && name == "model_instance") status = Member();
    if (name == "metadata") status = Metadata(attributes);
    path_.emplace_back(name);
    return status;
  }

  absl::Status End(std::string_view) override {
    path_.pop_back();
    return absl::OkStatus();
  }

  ModelSettings Take() && { return std::move(settings_); }

 private:
  bool In(std::string_view name, size_t depth) const {
    return path_.size() == depth && path_.back() == name;
  }

  absl::Status Object(XmlAttributes attributes) {
    const absl::StatusOr<ResourceId> id = IdOf(Find(attributes, "id"), "id");
    if (!id.ok()) return id.status();
    if (static_cast<int64_t>(settings_.objects.size()) >= limits::kMaxParts)
      return LimitError(Reason::kMeshTooLarge, "objects with settings", limits::kMaxParts,
                        limits::kMaxParts + 1);
    settings_.objects.emplace_back().object = *id;
    return absl::OkStatus();
  }

  absl::Status Part(std::string_view name, XmlAttributes attributes, int64_t line) {
    if (++parts_ > limits::kMaxParts)
      return LimitError(Reason::kMeshTooLarge, "parts of all objects", limits::kMaxParts, parts_);
    PartSettings& part = settings_.objects.back().parts.emplace_back();
    part.line = line;
    if (name == "part") {
      const absl::StatusOr<ResourceId> id = IdOf(Find(attributes, "id"), "id");
      if (!id.ok()) return id.status();
      part.component = *id;
      return Role(Find(attributes, "subtype").value_or("normal_part"), part);
    }
    const absl::StatusOr<int64_t> first = NumberOf(Find(attributes, "firstid"), "firstid");
    if (!first.ok()) return first.status();
    const absl::StatusOr<int64_t> last = NumberOf(Find(attributes, "lastid"), "lastid");
    if (!last.ok()) return last.status();
    part.first_triangle = *first;
    part.last_triangle = *last;
    return absl::OkStatus();
  }

  static absl::Status Role(std::string_view name, PartSettings& part) {
    const auto* const known = std::find_if(
        kRoles.begin(), kRoles.end(), [name](const RoleName& each) { return each.name == name; });
    if (known == kRoles.end())
      return Malformed(fmt::format("a part of unknown type `{}`", CleanName(name)));
    part.role = known->role;
    return absl::OkStatus();
  }

  absl::Status Plate() {
    if (static_cast<int64_t>(settings_.plates.size()) >= limits::kMaxProjectPlates)
      return LimitError(Reason::kMeshTooLarge, "plates", limits::kMaxProjectPlates,
                        limits::kMaxProjectPlates + 1);
    settings_.plates.emplace_back();
    return absl::OkStatus();
  }

  absl::Status Member() {
    if (++members_ > limits::kMaxObjects)
      return LimitError(Reason::kMeshTooLarge, "objects on plates, copies included",
                        limits::kMaxObjects, members_);
    settings_.plates.back().members.emplace_back();
    return absl::OkStatus();
  }

  absl::Status Metadata(XmlAttributes attributes) {
    const std::optional<std::string_view> key = Find(attributes, "key");
    if (!key || key->empty()) return absl::OkStatus();  // face counts have no key
    const std::string_view value = Find(attributes, "value").value_or("");
    if (In("object", 2)) return OfObject(*key, value);
    if (In("volume", 3) || In("part", 3)) return OfPart(*key, value);
    if (In("plate", 2)) return OfPlate(*key, value);
    if (In("model_instance", 3)) return OfMember(*key, value);
    return absl::OkStatus();
  }

  absl::Status OfObject(std::string_view key, std::string_view value) {
    ObjectSettings& object = settings_.objects.back();
    if (key != "name") return Add(key, value, object.settings);
    object.name = CleanName(value);
    return absl::OkStatus();
  }

  absl::Status OfPart(std::string_view key, std::string_view value) {
    if (settings_.objects.empty() || settings_.objects.back().parts.empty())
      return absl::OkStatus();
    PartSettings& part = settings_.objects.back().parts.back();
    if (key == "volume_type") return Role(value, part);
    if (key == "modifier") {  // from early versions of PrusaSlicer
      if (IsYes(value)) part.role = PartRole::kModifier;
      return absl::OkStatus();
    }
    if (key != "name") return Add(key, value, part.settings);
    part.name = CleanName(value);
    return absl::OkStatus();
  }

  absl::Status OfPlate(std::string_view key, std::string_view value) {
    PlateSettings& plate = settings_.plates.back();
    if (key == "plater_id") return Set(NumberOf(value, key), plate.number);
    if (key == "plater_name")
      plate.name = CleanName(value);
    else if (key == "locked")
      plate.locked = IsYes(value);
    else
      return Add(key, value, plate.settings);
    return absl::OkStatus();
  }

  absl::Status OfMember(std::string_view key, std::string_view value) {
    if (settings_.plates.empty() || settings_.plates.back().members.empty())
      return absl::OkStatus();
    PlateSettings::Member& member = settings_.plates.back().members.back();
    if (key == "object_id") return Set(IdOf(value, key), member.object);
    return key == "instance_id" ? Set(NumberOf(value, key), member.instance) : absl::OkStatus();
  }

  template <typename T>
  static absl::Status Set(const absl::StatusOr<T>& number, T& into) {
    if (number.ok()) into = *number;
    return number.status();
  }

  absl::Status Add(std::string_view key, std::string_view value, std::vector<Setting>& into) {
    if (std::find(kNotes.begin(), kNotes.end(), key) != kNotes.end()) return absl::OkStatus();
    if (!NamesScripts(key)) return AddSetting(key, ReplaceControls(value, ' '), into);
    settings_.has_scripts |= !value.empty();
    return absl::OkStatus();
  }

  ModelSettings settings_;
  std::vector<std::string> path_;
  int64_t parts_ = 0;
  int64_t members_ = 0;
};

}  // namespace

const ObjectSettings* ModelSettings::Of(ResourceId object) const {
  const auto found = std::find_if(objects.begin(), objects.end(),
                                  [object](const auto& each) { return each.object == object; });
  return found == objects.end() ? nullptr : &*found;
}

absl::StatusOr<ModelSettings> ReadModelSettings(std::string_view text, const std::string& part) {
  ModelSettingsHandler handler;
  absl::Status status = ParseXml(text, part, handler);
  if (!status.ok()) return status;
  ModelSettings settings = std::move(handler).Take();
  settings.part = part;
  return settings;
}

}  // namespace slicefarm::slicing::threemf
