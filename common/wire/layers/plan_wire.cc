#include "common/wire/layers/plan_wire.h"

#include <span>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/path_wire.h"
#include "common/wire/layers/region_wire.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/geometry_wire.h"
#include "common/wire/support/repeated_wire.h"

namespace slicefarm {
namespace {

absl::Status CheckObject(int32_t object) {
  if (0 <= object && object < limits::kMaxObjects) return absl::OkStatus();
  return Malformed("object", "is not the index of an object");
}

/// Returns true if the values `key(plan)` ascend strictly, so that no value occurs twice.
template <class Plans, class Key>
bool Ascend(const Plans& plans, Key key) {
  for (size_t i = 1; i < plans.size(); ++i)
    if (!(key(plans[i - 1]) < key(plans[i]))) return false;
  return true;
}

absl::Status PackLines(std::span<const Polyline> lines, v1::PlannedInfill* proto) {
  for (const Polyline& line : lines) {
    if (absl::Status ok = PackPoints(line, proto->mutable_lines_xy_nm()); !ok.ok()) return ok;
    proto->add_line_sizes(static_cast<uint32_t>(line.size()));
  }
  return absl::OkStatus();
}

absl::StatusOr<std::vector<Polyline>> UnpackLines(const v1::PlannedInfill& proto) {
  const auto points = UnpackPoints(proto.lines_xy_nm(), "lines_xy_nm");
  if (!points.ok()) return points.status();
  std::vector<Polyline> lines;
  size_t begin = 0;
  for (const uint32_t size : proto.line_sizes()) {
    if (size < 2 || size > points->size() - begin)
      return Malformed("line_sizes", "do not add up to lines_xy_nm");
    const auto first = points->begin() + static_cast<std::ptrdiff_t>(begin);
    lines.emplace_back(first, first + static_cast<std::ptrdiff_t>(size));
    begin += size;
  }
  if (begin != points->size()) return Malformed("line_sizes", "do not add up to lines_xy_nm");
  return lines;
}

bool IsWholeUm(Point shift) { return shift.x % 1000 == 0 && shift.y % 1000 == 0; }

}  // namespace

absl::Status CheckCopyCount(int count, std::string_view field) {
  if (count <= limits::kMaxObjects) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, std::string(field), limits::kMaxObjects, count);
}

absl::Status ToProto(const Copy& copy, v1::Copy* proto) {
  proto->set_object(copy.object);
  proto->set_pass(copy.pass);
  return ToProto(copy.shift, proto->mutable_shift());
}

absl::StatusOr<Copy> FromProto(const v1::Copy& proto) {
  if (absl::Status status = CheckObject(proto.object()); !status.ok()) return status;
  if (proto.pass() < 0 || proto.pass() >= limits::kMaxObjects)
    return Malformed("pass", "is none of a job's");
  const Point shift = FromProto(proto.shift());
  if (!IsWholeUm(shift)) return Malformed("shift", "is not in whole micrometres");
  return Copy{proto.object(), shift, proto.pass()};
}

absl::Status ToProto(const PlacedCopy& copy, v1::PlacedCopy* proto) {
  proto->set_object(copy.object);
  absl::Status status = ToProto(copy.shift, proto->mutable_shift());
  if (!status.ok()) return status;
  return PackPoints(copy.footprint, proto->mutable_footprint_xy_nm());
}

absl::StatusOr<PlacedCopy> FromProto(const v1::PlacedCopy& proto) {
  if (absl::Status status = CheckObject(proto.object()); !status.ok()) return status;
  const Point shift = FromProto(proto.shift());
  if (!IsWholeUm(shift)) return Malformed("shift", "is not in whole micrometres");
  absl::StatusOr<Polygon> footprint = UnpackPoints(proto.footprint_xy_nm(), "footprint_xy_nm");
  if (!footprint.ok()) return footprint.status();
  return PlacedCopy{proto.object(), shift, *std::move(footprint)};
}

absl::Status ToProto(const SectionPlan& plan, v1::SectionPlan* proto) {
  proto->set_stack(plan.stack);
  if (absl::Status status = ToProto(plan.entry, proto->mutable_entry()); !status.ok()) {
    return Within("entry", status);
  }
  if (plan.exit) {
    if (absl::Status status = ToProto(*plan.exit, proto->mutable_exit()); !status.ok())
      return Within("exit", status);
  }
  if (!plan.above_supports.empty())
    if (absl::Status status = ToProto(plan.above_supports, proto->mutable_above_supports());
        !status.ok())
      return Within("above_supports", status);
  if (!plan.curled.empty())
    if (absl::Status status = ToProto(plan.curled, proto->mutable_curled()); !status.ok())
      return Within("curled", status);
  if (!plan.air.empty())
    if (absl::Status status = ToProto(plan.air, proto->mutable_air()); !status.ok())
      return Within("air", status);
  if (plan.spiral)
    if (absl::Status status = ToProto(*plan.spiral, proto->mutable_spiral()); !status.ok())
      return Within("spiral", status);
  return PackPoints(plan.seams, proto->mutable_seams_xy_nm());
}

absl::StatusOr<SectionPlan> FromProto(const v1::SectionPlan& proto) {
  if (absl::Status status = CheckStack("stack", proto.stack()); !status.ok()) return status;
  absl::StatusOr<std::vector<Point>> seams = UnpackPoints(proto.seams_xy_nm(), "seams_xy_nm");
  if (!seams.ok()) return seams.status();
  absl::StatusOr<MultiPolygon> above_supports = FromProto(proto.above_supports());
  if (!above_supports.ok()) return Within("above_supports", above_supports.status());
  absl::StatusOr<MultiPolygon> curled = FromProto(proto.curled());
  if (!curled.ok()) return Within("curled", curled.status());
  absl::StatusOr<MultiPolygon> air = FromProto(proto.air());
  if (!air.ok()) return Within("air", air.status());
  SectionPlan plan{
      proto.stack(), FromProto(proto.entry()), {}, *std::move(seams), *std::move(above_supports)};
  if (proto.has_exit()) plan.exit = FromProto(proto.exit());
  if (proto.has_spiral()) plan.spiral = FromProto(proto.spiral());
  plan.curled = *std::move(curled);
  plan.air = *std::move(air);
  return plan;
}

absl::Status ToProto(const PlannedInfill& plan, v1::PlannedInfill* proto) {
  proto->set_stack(plan.stack);
  proto->set_settings(plan.settings);
  proto->set_pattern(EnumToProto<int32_t>(plan.pattern));
  proto->set_combined_height_nm(plan.combined_height_nm);
  absl::Status status = PackLines(plan.lines, proto);
  status.Update(ToProto(plan.left_out, proto->mutable_left_out()));
  status.Update(ToProto(plan.combined, proto->mutable_combined()));
  status.Update(PackPoints(plan.body_middles, proto->mutable_body_middles_xy_nm()));
  return status;
}

absl::StatusOr<PlannedInfill> FromProto(const v1::PlannedInfill& proto) {
  if (absl::Status status = CheckStack("stack", proto.stack()); !status.ok()) return status;
  if (proto.settings() < 0 || proto.settings() >= limits::kMaxRegionSettings)
    return Malformed("settings", "is no row of a table of region settings");
  if (proto.combined_height_nm() < 0 || proto.combined_height_nm() > limits::kMaxCoord)
    return Malformed("combined_height_nm", "is out of range");
  const auto pattern = EnumFromProto<FillPattern>(proto.pattern(), kFillPatternCount, "pattern");
  if (!pattern.ok()) return pattern.status();
  auto lines = UnpackLines(proto);
  if (!lines.ok()) return lines.status();
  auto left_out = FromProto(proto.left_out());
  if (!left_out.ok()) return Within("left_out", left_out.status());
  auto combined = FromProto(proto.combined());
  if (!combined.ok()) return Within("combined", combined.status());
  auto middles = UnpackPoints(proto.body_middles_xy_nm(), "body_middles_xy_nm");
  if (!middles.ok()) return middles.status();
  return PlannedInfill{proto.stack(),
                       proto.settings(),
                       *pattern,
                       *std::move(lines),
                       *std::move(left_out),
                       *std::move(combined),
                       proto.combined_height_nm(),
                       *std::move(middles)};
}

absl::Status CheckOrder(std::span<const PlannedInfill> plans) {
  const auto place = [](const PlannedInfill& plan) { return std::pair(plan.stack, plan.settings); };
  if (Ascend(plans, place)) return absl::OkStatus();
  return Malformed("infill", "its stacks and their rows do not ascend");
}

absl::Status ToProto(const LayerPlan& plan, v1::LayerPlan* proto) {
  if (absl::Status status = ToProto(plan.entry, proto->mutable_entry()); !status.ok()) {
    return Within("entry", status);
  }
  proto->set_begins_ready(plan.begins_ready);
  proto->set_ends_ready(plan.ends_ready);
  proto->set_paths_height_nm(plan.paths_height_nm);
  absl::Status status = AllToProto(plan.sections, "sections", proto->mutable_sections());
  if (!status.ok()) return status;
  status = AllToProto(plan.paths, "paths", proto->mutable_paths());
  if (!status.ok()) return status;
  return AllToProto(plan.infill, "infill", proto->mutable_infill());
}

absl::StatusOr<LayerPlan> FromProto(const v1::LayerPlan& proto) {
  LayerPlan plan;
  plan.entry = FromProto(proto.entry());
  plan.begins_ready = proto.begins_ready();
  plan.ends_ready = proto.ends_ready();
  plan.paths_height_nm = proto.paths_height_nm();
  if (plan.paths_height_nm < 0 || plan.paths_height_nm > limits::kMaxCoord)
    return Malformed("paths_height_nm", "is not a height");
  absl::Status status = AllFromProto(proto.sections(), "sections", &plan.sections);
  status.Update(AllFromProto(proto.paths(), "paths", &plan.paths));
  status.Update(AllFromProto(proto.infill(), "infill", &plan.infill));
  if (!status.ok()) return status;
  if (!Ascend(plan.sections, [](const SectionPlan& section) { return section.stack; }))
    return Malformed("sections", "their stacks do not ascend");
  if (absl::Status ok = CheckOrder(plan.infill); !ok.ok()) return ok;
  return plan;
}

absl::Status ToProto(const AddedStack& added, v1::AddedStack* proto) {
  ToProto(added.stack, proto->mutable_stack());
  proto->set_lift_nm(added.lift_nm);
  return absl::OkStatus();
}

absl::StatusOr<AddedStack> FromProto(const v1::AddedStack& proto) {
  const absl::StatusOr<Stack> stack = FromProto(proto.stack());
  if (!stack.ok()) return stack.status();
  if (absl::Status ok = CheckLift("lift_nm", proto.lift_nm()); !ok.ok()) return ok;
  return AddedStack{*stack, proto.lift_nm(), {}};
}

absl::Status CheckLift(std::string_view field, int64_t lift_nm) {
  if (0 <= lift_nm && lift_nm <= limits::kMaxCoord) return absl::OkStatus();
  return Malformed(field, "is not a height");
}

absl::Status ToProto(const Skirt& skirt, v1::Skirt* proto) {
  proto->set_layers(skirt.layers);
  absl::Status status = AllToProto(skirt.loops, "loops", proto->mutable_loops());
  status.Update(AllToProto(skirt.upper_loops, "upper_loops", proto->mutable_upper_loops()));
  return status;
}

absl::StatusOr<Skirt> FromProto(const v1::Skirt& proto) {
  if (proto.layers() < 0 || proto.layers() > limits::kMaxLayers)
    return Malformed("layers", "is not a number of layers");
  Skirt skirt{{}, proto.layers(), {}};
  absl::Status status = AllFromProto(proto.loops(), "loops", &skirt.loops);
  status.Update(AllFromProto(proto.upper_loops(), "upper_loops", &skirt.upper_loops));
  if (!status.ok()) return status;
  return skirt;
}

v1::SeamQuality ToProto(const SeamQuality& quality) {
  v1::SeamQuality proto;
  proto.set_loops(quality.loops);
  proto.set_followers(quality.followers);
  proto.set_jumps(quality.jumps);
  proto.set_steps_mm(quality.steps_mm);
  proto.set_with_corner(quality.with_corner);
  proto.set_on_corner(quality.on_corner);
  proto.set_overhanging(quality.overhanging);
  return proto;
}

absl::StatusOr<SeamQuality> FromProto(const v1::SeamQuality& proto) {
  for (const int64_t part : {proto.followers(), proto.with_corner(), proto.overhanging()})
    if (part < 0 || part > proto.loops())
      return Malformed("loops", "are not as many as their parts");
  if (proto.jumps() < 0 || proto.jumps() > proto.followers())
    return Malformed("jumps", "are not some of the followers");
  if (proto.on_corner() < 0 || proto.on_corner() > proto.with_corner())
    return Malformed("on_corner", "are not some of the loops with corners");
  if (!(proto.steps_mm() >= 0)) return Malformed("steps_mm", "is negative");
  return SeamQuality{proto.loops(),       proto.followers(), proto.jumps(),      proto.steps_mm(),
                     proto.with_corner(), proto.on_corner(), proto.overhanging()};
}

v1::CopyName ToProto(const CopyName& name) {
  v1::CopyName proto;
  proto.set_object_name(name.object_name);
  proto.set_object(name.object);
  proto.set_copy(name.copy);
  proto.set_copies(name.copies);
  return proto;
}

absl::StatusOr<CopyName> FromProto(const v1::CopyName& proto) {
  if (absl::Status status = CheckObject(proto.object()); !status.ok()) return status;
  if (proto.copy() < 0 || proto.copy() >= proto.copies() || proto.copies() > limits::kMaxObjects) {
    return Malformed("copy", "is not one of the object's copies");
  }
  return CopyName{proto.object_name(), proto.object(), proto.copy(), proto.copies()};
}

v1::PassFacts ToProto(const PassFacts& facts) {
  v1::PassFacts proto;
  proto.set_layers_before(facts.layers_before);
  proto.set_first_layer(facts.first_layer);
  proto.set_top_before_nm(facts.top_before_nm);
  return proto;
}

absl::StatusOr<PassFacts> FromProto(const v1::PassFacts& proto) {
  if (proto.layers_before() < 0 || proto.layers_before() > limits::kMaxLayerPrograms)
    return Malformed("layers_before", "is not a number of layers");
  if (proto.first_layer() < 0 || proto.first_layer() >= limits::kMaxLayers)
    return Malformed("first_layer", "is not a layer");
  if (proto.top_before_nm() < 0 || proto.top_before_nm() > limits::kMaxCoord)
    return Malformed("top_before_nm", "is out of range");
  return PassFacts{proto.layers_before(), proto.first_layer(), proto.top_before_nm()};
}

v1::JobFacts ToProto(const JobFacts& facts) {
  v1::JobFacts proto;
  proto.set_layer_count(facts.layer_count);
  for (const CopyName& name : facts.copies) *proto.add_copies() = ToProto(name);
  for (const PassFacts& pass : facts.passes) *proto.add_passes() = ToProto(pass);
  return proto;
}

absl::StatusOr<JobFacts> FromProto(const v1::JobFacts& proto) {
  if (proto.layer_count() < 0 || proto.layer_count() > limits::kMaxLayerPrograms) {
    return Malformed("layer_count", "is not a number of layers");
  }
  absl::Status status = CheckCopyCount(proto.copies_size(), "copies");
  status.Update(CheckCopyCount(proto.passes_size(), "passes"));
  if (!status.ok()) return status;
  JobFacts facts{proto.layer_count(), {}, {}};
  status.Update(AllFromProto(proto.copies(), "copies", &facts.copies));
  status.Update(AllFromProto(proto.passes(), "passes", &facts.passes));
  if (!status.ok()) return status;
  return facts;
}

}  // namespace slicefarm
