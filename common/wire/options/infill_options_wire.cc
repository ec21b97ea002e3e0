#include "common/wire/options/infill_options_wire.h"

#include <map>
#include <tuple>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/options/settings_check.h"
#include "common/wire/options/skin_spare_wire.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

static_assert(v1::FILL_PATTERN_GRID == static_cast<int>(FillPattern::kGrid) + 1);
static_assert(v1::FillPattern_MAX == kFillPatternCount);
static_assert(v1::SHELL_THICKNESS_DISABLED == static_cast<int>(ShellThickness::kDisabled) + 1);
static_assert(v1::SHELL_THICKNESS_ENABLED == static_cast<int>(ShellThickness::kEnabled) + 1);
static_assert(v1::FILL_GOAL_STRENGTH == static_cast<int>(FillGoal::kStrength) + 1);
static_assert(v1::FILL_GOAL_FLEXIBILITY == static_cast<int>(FillGoal::kFlexibility) + 1);
static_assert(v1::IRONING_TYPE_TOP == static_cast<int>(IroningType::kTop) + 1);
static_assert(v1::IRONING_TYPE_SOLID == static_cast<int>(IroningType::kSolid) + 1);

absl::Status Check(const v1::InfillOptions& proto) {
  absl::Status status = CheckComplete(proto);
  status.Update(CheckSpares(proto));
  for (const auto& [field, layers] : {std::pair("top_solid_layers", proto.top_solid_layers()),
                                      std::pair("bottom_solid_layers", proto.bottom_solid_layers()),
                                      std::pair("field_halo_layers", proto.field_halo_layers())}) {
    if (layers < 0 || layers > limits::kMaxLayers) {
      status.Update(Malformed(field, "is out of range"));
    }
  }
  if (proto.density() < 0 || proto.density() > 1) {
    status.Update(Malformed("density", "is not in [0, 1]"));
  }
  if (proto.solid_below_area_mm2() < 0) {
    status.Update(Malformed("solid_below_area_mm2", "is negative"));
  }
  status.Update(CheckPositive({{"sparse_width_nm", proto.sparse_width_nm()},
                               {"solid_width_nm", proto.solid_width_nm()},
                               {"top_width_nm", proto.top_width_nm()},
                               {"first_layer_width_nm", proto.first_layer_width_nm()},
                               {"nozzle_nm", proto.nozzle_nm()}}));
  status.Update(CheckLengths({{"overlap_nm", proto.overlap_nm()}}, -limits::kMaxCoord));
  status.Update(CheckNotNegative({{"anchor_nm", proto.anchor_nm()},
                                  {"anchor_max_nm", proto.anchor_max_nm()},
                                  {"smoothing_nm", proto.smoothing_nm()}}));
  if (proto.solid_every_layers() < 0) status.Update(Malformed("solid_every_layers", "is negative"));
  if (proto.every_layers() < 1) status.Update(Malformed("every_layers", "is below 1"));
  if (!(proto.bridge_flow() > 0)) status.Update(Malformed("bridge_flow", "is not above 0"));
  if (proto.ironing().flow() < 0) status.Update(Malformed("ironing.flow", "is negative"));
  status.Update(CheckPositive({{"ironing.spacing_nm", proto.ironing().spacing_nm()}}));
  return status;
}

/// Numbers texts, from 1; none has 0.
class TextWriter {
 public:
  explicit TextWriter(RowTexts* texts) : texts_(texts) {}
  int32_t NumberOf(std::string_view text) {
    if (text.empty()) return 0;
    const auto [known, added] = numbers_.try_emplace(text, texts_->size() + 1);
    if (added) texts_->Add(std::string(text));
    return known->second;
  }

 private:
  RowTexts* texts_;
  std::map<std::string_view, int32_t> numbers_;  ///< of the table's own texts
};

class TextReader {
 public:
  explicit TextReader(const RowTexts& texts) : texts_(texts.begin(), texts.end()) {}
  bool Has(int32_t number) const { return 0 <= number && number <= std::ssize(texts_); }
  /// REQUIRES: Has(number).
  SharedText Text(int32_t number) const {
    return number == 0 ? SharedText() : texts_[static_cast<size_t>(number - 1)];
  }

 private:
  const std::vector<SharedText> texts_;
};

v1::InfillOptions RowToProto(const InfillOptions& options, TextWriter& texts) {
  v1::InfillOptions proto;
  proto.set_top_solid_layers(options.top_solid_layers);
  proto.set_bottom_solid_layers(options.bottom_solid_layers);
  *proto.mutable_top_spare() = ToProto(options.top_spare);
  *proto.mutable_bottom_spare() = ToProto(options.bottom_spare);
  proto.set_density(options.density);
  proto.set_pattern(EnumToProto<v1::FillPattern>(options.pattern));
  proto.set_solid_pattern(EnumToProto<v1::FillPattern>(options.solid_pattern));
  proto.set_top_pattern(EnumToProto<v1::FillPattern>(options.top_pattern));
  proto.set_bottom_pattern(EnumToProto<v1::FillPattern>(options.bottom_pattern));
  proto.set_angle_rad(options.angle_rad);
  proto.set_sparse_width_nm(options.sparse_width_nm);
  proto.set_solid_width_nm(options.solid_width_nm);
  proto.set_top_width_nm(options.top_width_nm);
  proto.set_first_layer_width_nm(options.first_layer_width_nm);
  proto.set_overlap_nm(options.overlap_nm);
  proto.set_solid_below_area_mm2(options.solid_below_area_mm2);
  proto.set_anchor_nm(options.anchor_nm);
  proto.set_anchor_max_nm(options.anchor_max_nm);
  proto.set_smoothing_nm(options.smoothing_nm);
  proto.set_solid_every_layers(options.solid_every_layers);
  proto.set_bridge_angle_rad(options.bridge_angle_rad);
  proto.set_density_text(texts.NumberOf(options.density_field));
  proto.set_stress_text(texts.NumberOf(options.stress_field));
  proto.set_angle_text(texts.NumberOf(options.angle_template));
  proto.set_solid_angle_text(texts.NumberOf(options.solid_angle_template));
  proto.set_flow_text(texts.NumberOf(options.small_area_flow_table));
  proto.set_field_halo_layers(options.field_halo_layers);
  proto.set_choose_pattern(options.choose_pattern);
  proto.set_goal(EnumToProto<v1::FillGoal>(options.goal));
  proto.set_bridge_flow(options.bridge_flow);
  proto.set_every_layers(options.every_layers);
  proto.set_only_where_needed(options.only_where_needed);
  proto.set_shells(EnumToProto<v1::ShellThickness>(options.shells));
  proto.set_overhang_lines(options.overhang_lines);
  proto.set_thick_bridges(options.thick_bridges);
  proto.set_nozzle_nm(options.nozzle_nm);
  proto.set_over_bridges(options.over_bridges);
  proto.set_walls_nm(options.walls_nm);
  proto.set_interface_shells(options.interface_shells);
  proto.set_small_area_flow(options.small_area_flow);
  v1::IroningOptions& ironing = *proto.mutable_ironing();
  ironing.set_enabled(options.ironing.enabled);
  ironing.set_type(EnumToProto<v1::IroningType>(options.ironing.type));
  ironing.set_flow(options.ironing.flow);
  ironing.set_spacing_nm(options.ironing.spacing_nm);
  return proto;
}

absl::StatusOr<InfillOptions> RowFromProto(const v1::InfillOptions& proto,
                                           const TextReader& texts) {
  if (absl::Status status = Check(proto); !status.ok()) return status;
  InfillOptions options;
  options.top_solid_layers = proto.top_solid_layers();
  options.bottom_solid_layers = proto.bottom_solid_layers();
  options.top_spare = SpareFromProto(proto.top_spare());
  options.bottom_spare = SpareFromProto(proto.bottom_spare());
  options.density = proto.density();
  options.pattern = Known<FillPattern>(proto.pattern());
  options.solid_pattern = Known<FillPattern>(proto.solid_pattern());
  options.top_pattern = Known<FillPattern>(proto.top_pattern());
  options.bottom_pattern = Known<FillPattern>(proto.bottom_pattern());
  options.angle_rad = proto.angle_rad();
  options.sparse_width_nm = proto.sparse_width_nm();
  options.solid_width_nm = proto.solid_width_nm();
  options.top_width_nm = proto.top_width_nm();
  options.first_layer_width_nm = proto.first_layer_width_nm();
  options.overlap_nm = proto.overlap_nm();
  options.solid_below_area_mm2 = proto.solid_below_area_mm2();
  options.anchor_nm = proto.anchor_nm();
  options.anchor_max_nm = proto.anchor_max_nm();
  options.smoothing_nm = proto.smoothing_nm();
  options.solid_every_layers = proto.solid_every_layers();
  options.bridge_angle_rad = proto.bridge_angle_rad();
  for (const auto& [number, field, text] :
       {std::tuple(proto.density_text(), "density_text", &options.density_field),
        std::tuple(proto.stress_text(), "stress_text", &options.stress_field),
        std::tuple(proto.angle_text(), "angle_text", &options.angle_template),
        std::tuple(proto.solid_angle_text(), "solid_angle_text", &options.solid_angle_template),
        std::tuple(proto.flow_text(), "flow_text", &options.small_area_flow_table)}) {
    if (!texts.Has(number)) return Malformed(field, "is none of the texts");
    *text = texts.Text(number);
  }
  options.field_halo_layers = proto.field_halo_layers();
  options.choose_pattern = proto.choose_pattern();
  options.goal = Known<FillGoal>(proto.goal());
  options.bridge_flow = proto.bridge_flow();
  options.every_layers = proto.every_layers();
  options.only_where_needed = proto.only_where_needed();
  options.shells = Known<ShellThickness>(proto.shells());
  options.overhang_lines = proto.overhang_lines();
  options.thick_bridges = proto.thick_bridges();
  options.nozzle_nm = proto.nozzle_nm();
  options.over_bridges = proto.over_bridges();
  options.walls_nm = proto.walls_nm();
  options.interface_shells = proto.interface_shells();
  options.small_area_flow = proto.small_area_flow();
  options.ironing = {proto.ironing().enabled(), Known<IroningType>(proto.ironing().type()),
                     proto.ironing().flow(), proto.ironing().spacing_nm()};
  return options;
}

}  // namespace

void ToProto(const std::vector<InfillOptions>& table, InfillRows* rows, RowTexts* texts) {
  TextWriter writer(texts);
  for (const InfillOptions& row : table) *rows->Add() = RowToProto(row, writer);
}

absl::StatusOr<std::vector<InfillOptions>> FromProto(const InfillRows& rows, const RowTexts& texts,
                                                     std::string_view field) {
  for (const std::string& text : texts)
    if (std::ssize(text) > limits::kMaxFieldBytes)
      return LimitError(Reason::kRequestTooLarge, "texts", limits::kMaxFieldBytes,
                        std::ssize(text));
  const TextReader reader(texts);
  std::vector<InfillOptions> table;
  for (int i = 0; i < rows.size(); ++i) {
    absl::StatusOr<InfillOptions> row = RowFromProto(rows[i], reader);
    if (!row.ok()) return Within(field, static_cast<size_t>(i), row.status());
    table.push_back(*std::move(row));
  }
  return table;
}

}  // namespace slicefarm
