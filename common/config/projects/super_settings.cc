#include "common/config/projects/super_settings.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "common/base/text.h"
#include "common/config/table/value.h"

namespace slicefarm::config {
namespace {

/// Setting to which a percentage refers in SuperSlicer. Only settings are listed for which
/// PrusaSlicer uses another base or none. Source: `ratio_over` of SuperSlicer's option definitions,
/// 2.5.
struct SuperRelation {
  std::string_view key;
  std::string_view of;
};
constexpr SuperRelation kSuperRelations[] = {
    {"bridge_acceleration", "default_acceleration"},
    {"bridge_speed", "default_speed"},
    {"default_acceleration", "machine_max_acceleration_x"},
    {"default_speed", "machine_max_feedrate_x"},
    {"external_perimeter_acceleration", "perimeter_acceleration"},
    {"external_perimeter_extrusion_width", "nozzle_diameter"},
    {"extrusion_width", "nozzle_diameter"},
    {"first_layer_acceleration", "default_acceleration"},
    {"first_layer_acceleration_over_raft", "default_acceleration"},
    {"first_layer_extrusion_width", "nozzle_diameter"},
    {"first_layer_height", "nozzle_diameter"},
    {"fuzzy_skin_point_dist", "nozzle_diameter"},
    {"fuzzy_skin_thickness", "nozzle_diameter"},
    {"gap_fill_speed", "perimeter_speed"},
    {"infill_acceleration", "solid_infill_acceleration"},
    {"infill_extrusion_width", "nozzle_diameter"},
    {"infill_speed", "solid_infill_speed"},
    {"ironing_speed", "top_solid_infill_speed"},
    {"max_layer_height", "nozzle_diameter"},
    {"max_print_speed", "machine_max_feedrate_x"},
    {"min_layer_height", "nozzle_diameter"},
    {"perimeter_acceleration", "default_acceleration"},
    {"perimeter_extrusion_width", "nozzle_diameter"},
    {"perimeter_speed", "default_speed"},
    {"solid_infill_acceleration", "default_acceleration"},
    {"solid_infill_extrusion_width", "nozzle_diameter"},
    {"solid_infill_speed", "default_speed"},
    {"support_material_bottom_contact_distance", "nozzle_diameter"},
    {"support_material_contact_distance", "nozzle_diameter"},
    {"support_material_extrusion_width", "nozzle_diameter"},
    {"support_material_speed", "default_speed"},
    {"top_infill_extrusion_width", "nozzle_diameter"},
    {"top_solid_infill_acceleration", "solid_infill_acceleration"},
    {"top_solid_infill_speed", "solid_infill_speed"},
    {"travel_acceleration", "default_acceleration"},
};

/// Value of a SuperSlicer setting that PrusaSlicer lacks (`from`), and the value that replaces it
/// (`to`). `key`: the setting, or the end of its name.
struct SuperChoice {
  std::string_view key;
  std::string_view from;
  std::string_view to;
};
constexpr SuperChoice kSuperChoices[] = {
    {"_pattern", "concentricgapfill", "concentric"},
    {"_pattern", "monotonicgapfill", "monotonic"},
    {"_pattern", "rectilineargapfill", "rectilinear"},
    {"_pattern", "rectiwithperimeter", "rectilinear"},
    {"_pattern", "sawtooth", "rectilinear"},
    {"_pattern", "scatteredrectilinear", "rectilinear"},
    {"_pattern", "smooth", "rectilinear"},
    {"_pattern", "smoothhilbert", "rectilinear"},
    {"_pattern", "smoothtriple", "rectilinear"},
    {"gcode_flavor", "lerdge", "marlin"},
    {"gcode_flavor", "sprinter", "reprap"},
    {"seam_position", "allrandom", "random"},
    {"seam_position", "contiguous", "aligned"},
    {"seam_position", "cost", "nearest"},
};

class SuperReader {
 public:
  explicit SuperReader(std::vector<Setting> settings) : settings_(std::move(settings)) {
    for (size_t i = 0; i < settings_.size(); ++i) index_[settings_[i].key] = i;
  }

  std::vector<Setting> Run() && {
    ResolvePercentages();
    for (Setting& setting : settings_) setting.value = Chosen(setting);
    TakeFlows();
    TakeBrim();
    TakeBridgeFan();
    TakeCompensation();
    if (TextOf("only_one_perimeter_top") == "1") Set("top_one_perimeter_type", "top");
    if (TextOf("infill_connection") == "notconnected") Set("infill_anchor_max", "0");
    return std::move(settings_);
  }

 private:
  std::string_view TextOf(std::string_view key) const {
    const auto found = index_.find(key);
    return found == index_.end() ? std::string_view() : settings_[found->second].value;
  }

  /// Returns a number of the first extruder and the normal mode.
  std::optional<double> NumberOf(std::string_view key) const {
    const std::string_view text = TextOf(key);
    return AbsoluteOf(key, text.substr(0, text.find(',')));
  }

  /// Returns the absolute value, or nullopt for a percentage of an unknown value. The relations
  /// have no cycles.
  std::optional<double> AbsoluteOf(std::string_view key, std::string_view text) const {
    text = Trim(text);
    if (!text.ends_with('%')) return ToNumber(text);
    text.remove_suffix(1);
    const auto* const relation =
        std::ranges::find(kSuperRelations, key, [](const SuperRelation& each) { return each.key; });
    if (relation == std::end(kSuperRelations)) return std::nullopt;
    const std::optional<double> percent = ToNumber(Trim(text));
    const std::optional<double> whole = NumberOf(relation->of);
    if (!percent || !whole) return std::nullopt;
    return *percent / 100 * *whole;
  }

  void ResolvePercentages() {
    std::vector<std::pair<size_t, std::string>> resolved;
    for (const SuperRelation& relation : kSuperRelations) {
      const std::string_view text = TextOf(relation.key);
      if (text.find('%') == std::string_view::npos) continue;
      std::string list;
      for (const std::string_view item : Split(text, ",")) {
        const std::optional<double> number = AbsoluteOf(relation.key, item);
        list.append(list.empty() ? "" : ",");
        list.append(number ? PrintNumber(Quantise(*number)) : std::string(item));
      }
      resolved.emplace_back(index_.find(relation.key)->second, std::move(list));
    }
    for (auto& [at, text] : resolved) settings_[at].value = std::move(text);
  }

  static std::string Chosen(const Setting& setting) {
    const auto* const found = std::ranges::find_if(kSuperChoices, [&](const SuperChoice& choice) {
      return setting.key.ends_with(choice.key) && setting.value == choice.from;
    });
    return found == std::end(kSuperChoices) ? setting.value : std::string(found->to);
  }

  /// Converts flows from percentages. A flow of the print multiplies the flow of the filament.
  void TakeFlows() {
    const std::optional<double> bridges = PercentOf("bridge_flow_ratio");
    if (bridges) Set("bridge_flow_ratio", PrintNumber(Quantise(*bridges / 100)));
    const std::optional<double> print = PercentOf("print_extrusion_multiplier");
    if (!print || *print == 100) return;
    const double filament = NumberOf("extrusion_multiplier").value_or(1);
    Set("extrusion_multiplier", PrintNumber(Quantise(*print / 100 * filament)));
  }

  std::optional<double> PercentOf(std::string_view key) const {
    std::string_view text = TextOf(key);
    if (!text.ends_with('%')) return std::nullopt;
    text.remove_suffix(1);
    return ToNumber(Trim(text));
  }

  /// Converts the brim: SuperSlicer has a width for each side, PrusaSlicer one width and a choice
  /// of sides.
  void TakeBrim() {
    const std::optional<double> inside = NumberOf("brim_width_interior");
    if (!inside) return;
    const double outside = NumberOf("brim_width").value_or(0);
    if (*inside > 0 && outside <= 0) Set("brim_width", PrintNumber(Quantise(*inside)));
    if (*inside > 0) Set("brim_type", outside > 0 ? "outer_and_inner" : "inner_only");
  }

  /// Converts a fan speed of -1: bridges then have the usual fan speed. That setting has another
  /// name since 2.5.
  void TakeBridgeFan() {
    const auto own = NumberOf("bridge_fan_speed");
    if (!own || *own >= 0) return;
    const auto usual =
        NumberOf(index_.contains("default_fan_speed") ? "default_fan_speed" : "min_fan_speed");
    if (usual && *usual >= 0) Set("bridge_fan_speed", PrintNumber(Quantise(*usual)));
  }

  /// Converts the growth of the first layer. PrusaSlicer's value is a shrinkage and cannot be
  /// negative.
  void TakeCompensation() {
    const auto compensation = NumberOf("first_layer_size_compensation");
    if (compensation)
      Set("elefant_foot_compensation", PrintNumber(Quantise(std::max(-*compensation, 0.0))));
  }

  void Set(std::string_view key, std::string value) {
    if (const auto found = index_.find(key); found != index_.end()) {
      settings_[found->second].value = std::move(value);
      return;
    }
    index_.emplace(key, settings_.size());
    settings_.push_back({std::string(key), std::move(value), Source::kProfile});
  }

  std::vector<Setting> settings_;
  /// Index of each key in settings_; the last one of repeated keys.
  std::map<std::string, size_t, std::less<>> index_;
};

}  // namespace

bool IsSuperSlicers(std::string_view text) {
  return text.substr(0, text.find('\n')).find("generated by SuperSlicer") != std::string_view::npos;
}

std::vector<Setting> FromSuperSlicer(std::vector<Setting> settings) {
  return SuperReader(std::move(settings)).Run();
}

}  // namespace slicefarm::config
