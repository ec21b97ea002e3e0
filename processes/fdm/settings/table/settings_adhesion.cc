#include "common/model/layers/job_plan.h"
#include "common/model/limits.h"
#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

std::vector<SettingSpec> Skirt() {
  const auto shield = [](DraftShield value) { return static_cast<int>(value); };
  return {
      {.key = "skirts",
       .kind = Kind::kInteger,
       .min = 0,
       .max = limits::kMaxSkirtLoops,
       .standard = "0",
       .doc =
           "Number of loops that are printed around all objects before them, so that the filament "
           "flows steadily when the objects begin; 0: no skirt. Default in PrusaSlicer: 1",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::skirt, &SkirtOptions::loops>(),
       .orca = {{"skirt_loops"}}},
      {.key = "skirt_distance",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "6",
       .doc = "Horizontal distance between the objects and the innermost skirt loop. Objects with "
              "a brim: distance between the brim and the skirt, unless the skirt is a draft_shield",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::skirt, &SkirtOptions::distance_nm>(),
       .orca = {{"skirt_distance"}},
       .needs = {&needs::kSkirt}},
      {.key = "skirt_height",
       .kind = Kind::kInteger,
       .unit = "layers",
       .min = 0,
       .max = limits::kMaxLayers,
       .standard = "1",
       .doc = "Number of layers, counted from the bed, that have a skirt",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::skirt, &SkirtOptions::height_layers>(),
       .orca = {{"skirt_height"}},
       .needs = {&needs::kSkirt}},
      {.key = "skirt_start_angle",
       .unit = "degrees",
       .min = -360,
       .max = 360,
       .standard = "-360",
       .doc = "Direction from the middle of the skirt to the start of its loops, counter-clockwise "
              "from the x axis; -360: the loops start anywhere. OrcaSlicer's default: -135",
       .field = Bind<Scale::kDegrees, &MachineRow::plan, &JobPlanOptions::skirt,
                     &SkirtOptions::start_angle_rad>(),
       .orca = {{"skirt_start_angle"}},
       .needs = {&needs::kSkirt}},
      {.key = "skirt_speed",
       .unit = "mm/s",
       .min = 0,
       .max = 10'000,
       .standard = "0",
       .doc = "Speed of the skirt in all layers; 0: first_layer_speed in the first layer, "
              "support_material_speed in the other layers",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::skirt, &SkirtOptions::speed_mm_s>(),
       .orca = {{"skirt_speed"}},
       .needs = {&needs::kSkirt}},
      {.key = "min_skirt_length",
       .unit = "mm",
       .min = 0,
       .max = 1e6,
       .standard = "0",
       .doc = "Smallest length of filament that the skirt uses on the first layer; a skirt that "
              "uses less gets more loops than `skirts` says. 0: no additional loops",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::skirt, &SkirtOptions::min_length_nm>(),
       .orca = {{"min_skirt_length"}},
       .needs = {&needs::kSkirt}},
      {.key = "draft_shield",
       .kind = Kind::kChoice,
       .standard = "disabled",
       .doc = "Use of the skirt as a wall that shields the part from cold air. The wall is at "
              "skirt_distance from the part and cuts off brims that reach it. limited: "
              "skirt_height layers high. enabled: on all layers. disabled: an ordinary skirt. 0 "
              "and 1 are older names of disabled and enabled",
       .choices = {{"disabled", shield(DraftShield::kDisabled)},
                   {"limited", shield(DraftShield::kLimited)},
                   {"enabled", shield(DraftShield::kEnabled)},
                   {"0", shield(DraftShield::kDisabled)},
                   {"1", shield(DraftShield::kEnabled)}},
       .field = Bind<&MachineRow::plan, &JobPlanOptions::skirt, &SkirtOptions::draft_shield>(),
       .orca = {{"draft_shield"}},
       .needs = {&needs::kSkirt}},
      {.key = "skirt_type",
       .kind = Kind::kChoice,
       .standard = "combined",
       .doc = "Number of skirts. combined: one around all objects. perobject: one around each "
              "copy; copies "
              "share a skirt if theirs would meet. All skirts are printed before the objects",
       .choices = {{"combined", 0}, {"perobject", 1}},
       .field = Bind<&MachineRow::plan, &JobPlanOptions::skirt, &SkirtOptions::per_object>(),
       .orca = {{"skirt_type"}},
       .needs = {&needs::kSkirt}},
      {.key = "single_loop_draft_shield",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print only the innermost loop of the skirt above the first layer, to save filament",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::skirt, &SkirtOptions::single_upper>(),
       .orca = {{"single_loop_draft_shield"}},
       .needs = {&needs::kSkirt}},
  };
}

/// Additional value of brim_type that is not a BrimType.
constexpr int kAutoBrim = 5;

void SetBrimType(BrimOptions& brim, const Value& value) {
  const auto type = static_cast<int>(std::lround(value.number));
  brim.automatic.on = type == kAutoBrim;
  brim.type = brim.automatic.on ? BrimType::kOuterOnly : static_cast<BrimType>(type);
}

Value BrimTypeOf(const BrimOptions& brim) {
  return {.number =
              static_cast<double>(brim.automatic.on ? kAutoBrim : static_cast<int>(brim.type))};
}

std::vector<SettingSpec> Brim() {
  const auto type = [](BrimType value) { return static_cast<int>(value); };
  return {
      {.key = "brim_type",
       .kind = Kind::kChoice,
       .standard = "outer_only",
       .doc = "Position of the brim. outer_only: around the object. inner_only: in its holes. "
              "outer_and_inner: both. brim_ears: discs at sharp corners. auto_brim: around the "
              "object, with a width that the program computes from the object's shape and material",
       .choices = {{"no_brim", type(BrimType::kNone)},
                   {"outer_only", type(BrimType::kOuterOnly)},
                   {"inner_only", type(BrimType::kInnerOnly)},
                   {"outer_and_inner", type(BrimType::kOuterAndInner)},
                   {"brim_ears", type(BrimType::kEars)},
                   {"auto_brim", kAutoBrim}},
       .field = Convert<ObjectRow>(
           [](ObjectRow& row, const Value& value) { SetBrimType(row.brim, value); },
           [](const ObjectRow& row) { return BrimTypeOf(row.brim); }),
       .orca = {{"brim_type", OrcaValue::kChoice}}},
      {.key = "brim_width",
       .unit = "mm",
       .min = 0,
       .max = 200,
       .standard = "0",
       .doc =
           "Width of the brim, or radius of brim ears; 0: no brim. Objects on a raft get no brim",
       .field = Bind<&ObjectRow::brim, &BrimOptions::width_nm>(),
       .orca = {{"brim_width"}},
       .needs = {&needs::kGivenBrimWidth, &needs::kBrim}},
      {.key = "brim_separation",
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "0",
       .doc = "Horizontal gap between an object and its brim; 0: the brim touches the object",
       .field = Bind<&ObjectRow::brim, &BrimOptions::separation_nm>(),
       .orca = {{"brim_object_gap"}},
       .needs = {&needs::kBrim}},
      {.key = "brim_ears_max_angle",
       .unit = "degrees",
       .min = 0,
       .max = 180,
       .standard = "125",
       .doc = "Inner angle of a corner below which the corner gets a brim ear; larger: also "
              "blunter corners get an ear",
       .field = Bind<Scale::kDegrees, &ObjectRow::brim, &BrimOptions::ear_max_angle_rad>(),
       .orca = {{"brim_ears_max_angle"}},
       .needs = {&needs::kBrimEars}},
      {.key = "brim_ears_detection_length",
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "1",
       .doc = "Size of details of an outline that are ignored when corners for brim ears are "
              "searched; larger: fewer ears",
       .field = Bind<&ObjectRow::brim, &BrimOptions::ear_detection_nm>(),
       .orca = {{"brim_ears_detection_length"}},
       .needs = {&needs::kBrimEars}},
      {.key = "brim_ears_outer_only",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Print brim ears only at corners of outer contours; 0: at corners that reach into "
              "holes too",
       .field = Bind<&ObjectRow::brim, &BrimOptions::ears_outside_only>(),
       .orca = {{"brim_ears_outer_only"}},
       .needs = {&needs::kBrimEars}},
      {.key = "brim_flow_ratio",
       .min = 0.1,
       .max = 2,
       .standard = "1",
       .doc = "Factor for the flow of brims; 1: the flow that fills their extrusion width",
       .field = Bind<&ObjectRow::brim, &BrimOptions::flow>(),
       .orca = {{"brim_flow_ratio"}},
       .needs = {&needs::kBrim}},
      {.key = "brim_use_efc_outline",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Begin the brim at the outline of the first layer as it is printed, with "
              "elefant_foot_compensation; 0: at the outline without the compensation, so that a "
              "gap of its size remains",
       .field = Bind<&ObjectRow::brim, &BrimOptions::compensated>(),
       .orca = {{"brim_use_efc_outline"}},
       .needs = {&needs::kElephantFoot, &needs::kBrim}},
      {.key = "combine_brims",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Join brims that meet into one, with lines around all of its objects; 0: each copy "
              "keeps a brim of its own, and the first one gets the area where two would overlap. "
              "OrcaSlicer's default: 0",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::combine_brims>(),
       .orca = {{"combine_brims"}},
       .needs = {&needs::kBrim}},
  };
}

std::vector<SettingSpec> Raft() {
  return {
      {.key = "raft_layers",
       .kind = Kind::kInteger,
       .min = 0,
       .max = limits::kMaxRaftLayers,
       .standard = "0",
       .doc = "Number of raft layers below the object; 0: no raft",
       .field = Bind<&ObjectRow::raft, &RaftOptions::heights, &RaftHeights::layers>(),
       .orca = {{"raft_layers"}}},
      {.key = "raft_contact_distance",
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "0.1",
       .doc = "Vertical gap between the top of the raft and the object, so that the raft can be "
              "removed; 0: no gap",
       .field = Bind<&ObjectRow::raft, &RaftOptions::heights, &RaftHeights::contact_distance_nm>(),
       .orca = {{"raft_contact_distance"}},
       .needs = {&needs::kRaft}},
      {.key = "raft_expansion",
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "1.5",
       .doc = "Distance by which the top of the raft extends beyond the object",
       .field = Bind<&ObjectRow::raft, &RaftOptions::expansion_nm>(),
       .orca = {{"raft_expansion"}},
       .needs = {&needs::kRaft}},
      {.key = "raft_first_layer_expansion",
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "3",
       .doc = "Distance by which the first raft layer extends beyond the rest of the raft. Without "
              "a raft: distance by which organic supports are wider on the bed",
       .field = Bind<&ObjectRow::raft, &RaftOptions::first_layer_expansion_nm>(),
       .orca = {{"raft_first_layer_expansion", OrcaValue::kOrAuto}},
       .needs = {&needs::kRaftOrTree}},
      {.key = "raft_first_layer_density",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 10,
       .max = 100,
       .standard = "90%",
       .doc = "Share of the area that the lines of the first raft layer, or of the first support "
              "layer, cover; 100%: solid",
       .field = Bind<Scale::kPercent, &ObjectRow::raft, &RaftOptions::lines,
                     &RaftLines::first_layer_density>(),
       .orca = {{"raft_first_layer_density", OrcaValue::kPercent}},
       .needs = {&needs::kRaftOrSupports}},
      {.key = "support_material_extrusion_width",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 20,
       .standard = "0",
       .doc = "Extrusion width of supports, and of all raft layers except the first; 0: "
              "extrusion_width",
       .relative_to = "layer_height",
       .field = Bind<&ObjectRow::raft, &RaftOptions::lines, &RaftLines::width_nm>(),
       .also = Bind<&ObjectRow::support, &SupportOptions::width_nm>(),
       .orca = {{"support_line_width", OrcaValue::kPercentOf, "nozzle_diameter"}}},
      {.key = "support_material_spacing",
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "2.5",
       .doc = "Gap between lines of supports and of the raft base; larger: less material",
       .field = Bind<&ObjectRow::raft, &RaftOptions::lines, &RaftLines::spacing_nm>(),
       .also = Bind<&ObjectRow::support, &SupportOptions::spacing_nm>(),
       .orca = {{"support_base_pattern_spacing"}},
       .needs = {&needs::kRaftOrSupports}},
      {.key = "support_material_angle",
       .unit = "degrees",
       .min = 0,
       .max = 359,
       .standard = "0",
       .doc = "Direction of the lines of supports and of the raft base, from the x axis; interface "
              "lines are perpendicular to these lines",
       .field =
           Bind<Scale::kDegrees, &ObjectRow::raft, &RaftOptions::lines, &RaftLines::angle_rad>(),
       .also = Bind<Scale::kDegrees, &ObjectRow::support, &SupportOptions::angle_rad>(),
       .orca = {{"support_angle"}},
       .needs = {&needs::kRaftOrSupports}},
  };
}

}  // namespace

std::vector<SettingSpec> AdhesionSettings() {
  std::vector<SettingSpec> settings = Skirt();
  for (const auto& section : {Brim, Raft})
    for (SettingSpec& spec : section()) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
