#include "processes/fdm/settings/check_settings.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "common/base/error.h"
#include "common/config/setting_refusal.h"
#include "common/config/table/value.h"
#include "common/model/options/adhesion_options.h"
#include "common/model/options/flow_fit.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm::config::fdm {
namespace {

absl::Status CheckHeight(const SettingValues& draft, std::string_view key) {
  const double nozzle = draft.Number("nozzle_diameter");
  if (draft.Number(key) <= nozzle) return absl::OkStatus();
  return Refuse(draft, key,
                fmt::format("it must not exceed nozzle_diameter = {} mm", PrintNumber(nozzle)), 0,
                nozzle);
}

absl::Status CheckWidth(const SettingValues& draft, std::string_view key,
                        std::string_view height_key) {
  constexpr double kMaxNozzles = 3;
  const double width = draft.Number(key);
  const double height = draft.Number(height_key);
  const double max = Quantise(kMaxNozzles * draft.Number("nozzle_diameter"));
  if (width < height) {
    return Refuse(draft, key,
                  fmt::format("it must be at least {} = {} mm", height_key, PrintNumber(height)),
                  height, kUnbounded);
  }
  if (width >= max) {
    return Refuse(
        draft, key,
        fmt::format("it must be less than 3 times nozzle_diameter = {} mm", PrintNumber(max)), 0,
        max);
  }
  return absl::OkStatus();
}

absl::Status CheckWidths(const SettingValues& draft) {
  for (const std::string_view key :
       {"perimeter_extrusion_width", "external_perimeter_extrusion_width", "infill_extrusion_width",
        "solid_infill_extrusion_width", "top_infill_extrusion_width"}) {
    const absl::Status status = CheckWidth(draft, key, "layer_height");
    if (!status.ok()) return status;
  }
  return CheckWidth(draft, "first_layer_extrusion_width", "first_layer_height");
}

/// Checks that lines of a raft, with the layer height of the raft, have a positive spacing.
absl::Status CheckRaft(const SettingValues& draft) {
  constexpr std::string_view kWidth = "support_material_extrusion_width";
  if (draft.Number("raft_layers") == 0) return absl::OkStatus();
  const double height =
      std::max(draft.Number("layer_height"), 0.75 * draft.Number("nozzle_diameter"));
  const double least = Quantise(height / 2);
  if (draft.Number(kWidth) < least)
    return Refuse(draft, kWidth,
                  fmt::format("it must be at least half the height of a raft layer = {} mm",
                              PrintNumber(least)),
                  least, kUnbounded);
  return CheckWidth(draft, kWidth, "layer_height");
}

/// Refuses a tall skirt if copies are printed one after another, because the head would hit it
/// between copies.
absl::Status CheckSkirt(const SettingValues& draft) {
  if (draft.Number("complete_objects") == 0 || draft.Number("skirts") == 0) return absl::OkStatus();
  const bool shields = draft.Number("draft_shield") == static_cast<double>(DraftShield::kEnabled);
  if (!shields && draft.Number("skirt_height") <= 1) return absl::OkStatus();
  const std::string key = shields ? "draft_shield" : "skirt_height";
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
      fmt::format(
          "{} = {}: with complete_objects = 1 a skirt must have only one layer (skirt_height = 1, "
          "draft_shield = disabled), or the print head would hit the skirt",
          key, draft.At(key).written),
      {{"setting", key}, {"value", draft.At(key).written}});
}

/// Refuses mixed materials for Klipper, which has no mixing extruder.
absl::Status CheckMixing(const SettingValues& draft) {
  const bool klipper = draft.Number("gcode_flavor") == static_cast<double>(GcodeFlavor::kKlipper);
  if (draft.At("material_field").value->text.empty() || !klipper) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   "material_field: gcode_flavor = klipper cannot mix materials; use gcode_flavor "
                   "= marlin or marlin2, or leave material_field empty",
                   {{"setting", "material_field"}});
}

absl::Status RefuseWords(std::string_view key, std::string_view why) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("{} = 1: {}", key, why),
                   {{"setting", std::string(key)}, {"value", "1"}});
}

/// Refuses commands that the firmware does not support. A firmware retraction cannot be combined
/// with a wipe.
absl::Status CheckWords(const SettingValues& draft) {
  const auto flavor = static_cast<GcodeFlavor>(std::lround(draft.Number("gcode_flavor")));
  constexpr std::string_view kByFirmware = "use_firmware_retraction";
  if (draft.Number(kByFirmware) != 0) {
    if (draft.Number("wipe") != 0)
      return RefuseWords(kByFirmware,
                         "wipe must be 0, because the firmware retracts without moving the nozzle");
    if (flavor == GcodeFlavor::kPrusaBuddy || flavor == GcodeFlavor::kBambu)
      return RefuseWords(kByFirmware,
                         "gcode_flavor must be marlin, marlin2, klipper or "
                         "reprapfirmware");
  }
  if (draft.Number("use_volumetric_e") != 0 && flavor == GcodeFlavor::kKlipper)
    return RefuseWords(
        "use_volumetric_e",
        "gcode_flavor = klipper cannot measure filament by volume: use_volumetric_e must be 0");
  return absl::OkStatus();
}

/// Checks the range of layer heights for adaptive layers.
absl::Status CheckAdaptiveHeights(const SettingValues& draft) {
  if (draft.Number("adaptive_layer_height") == 0) return absl::OkStatus();
  const double most = draft.Number("max_layer_height"), least = draft.Number("min_layer_height");
  if (most == 0 || least <= most) return absl::OkStatus();
  return Refuse(draft, "max_layer_height",
                fmt::format("it must be at least min_layer_height = {} mm", PrintNumber(least)),
                least, kUnbounded);
}

/// Checks the coefficients of the filament's flow, which are empty if they have no effect.
absl::Status CheckFlowFit(const SettingValues& draft) {
  const std::string key = "volumetric_speed_coefficients";
  const std::string& text = draft.At(key).value->text.str();
  const absl::Status parsed = FlowFit::Parse(text).status();
  if (parsed.ok()) return parsed;
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   fmt::format("{} = {}: it {}", key, text, std::string(parsed.message())),
                   {{"setting", key}, {"value", text}});
}

}  // namespace

absl::Status CheckSettings(const SettingValues& draft) {
  for (const std::string_view key : {"layer_height", "first_layer_height"}) {
    if (absl::Status status = CheckHeight(draft, key); !status.ok()) return status;
  }
  if (absl::Status status = CheckWidths(draft); !status.ok()) return status;
  if (absl::Status status = CheckRaft(draft); !status.ok()) return status;
  if (absl::Status status = CheckAdaptiveHeights(draft); !status.ok()) return status;
  if (absl::Status status = CheckSkirt(draft); !status.ok()) return status;
  if (absl::Status status = CheckFlowFit(draft); !status.ok()) return status;
  if (absl::Status status = CheckMixing(draft); !status.ok()) return status;
  if (absl::Status status = CheckWords(draft); !status.ok()) return status;

  const double length = draft.Number("retract_length");
  if (length > 0 && draft.Number("retract_restart_extra") < -length)
    return Refuse(
        draft, "retract_restart_extra",
        fmt::format("it must be at least -{} mm (minus retract_length)", PrintNumber(length)),
        -length, kUnbounded);
  if (length > 0 && draft.Number("retract_speed") == 0) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                     "retract_speed = 0 is out of range: it must be more than 0 mm/s if "
                     "retract_length is more than 0",
                     {{"setting", "retract_speed"}, {"value", "0"}});
  }
  const double widest_gap = draft.Number("gap_fill_max_width");
  if (draft.Number("gap_fill_min_width") > widest_gap) {
    return Refuse(
        draft, "gap_fill_min_width",
        fmt::format("it must not exceed gap_fill_max_width = {} mm", PrintNumber(widest_gap)), 0,
        widest_gap);
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::config::fdm
