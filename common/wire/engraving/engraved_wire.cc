#include "common/wire/engraving/engraved_wire.h"

#include <cmath>
#include <iterator>
#include <utility>

#include "common/model/limits.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

void PutSpread(const Spread& spread, v1::Spread* proto) {
  proto->set_p1(spread.p1);
  proto->set_p50(spread.p50);
  proto->set_p99(spread.p99);
}

Spread SpreadIn(const v1::Spread& proto) { return {proto.p1(), proto.p50(), proto.p99()}; }

void PutNumbers(const LayerNumbers& numbers, v1::LayerNumbers* proto) {
  proto->set_layer(numbers.layer);
  proto->set_height_mm(numbers.height_mm);
  proto->set_offset_mm(numbers.offset_mm);
  proto->set_spacing_mm(numbers.spacing_mm);
  proto->set_runs(numbers.runs);
  proto->set_points(numbers.points);
  proto->set_on_mm(numbers.on_mm);
  proto->set_off_mm(numbers.off_mm);
  proto->set_section_mm2(numbers.section_mm2);
  proto->set_folds(numbers.folds);
  proto->set_folds_mm(numbers.folds_mm);
  for (const double c : numbers.first_fold_mm) proto->add_first_fold_mm(c);
}

absl::StatusOr<LayerNumbers> NumbersIn(const v1::LayerNumbers& proto) {
  if (proto.first_fold_mm_size() != 3) return Malformed("first_fold_mm", "not three numbers");
  LayerNumbers numbers;
  numbers.layer = proto.layer();
  numbers.height_mm = proto.height_mm();
  numbers.offset_mm = proto.offset_mm();
  numbers.spacing_mm = proto.spacing_mm();
  numbers.runs = proto.runs();
  numbers.points = proto.points();
  numbers.on_mm = proto.on_mm();
  numbers.off_mm = proto.off_mm();
  numbers.section_mm2 = proto.section_mm2();
  numbers.folds = proto.folds();
  numbers.folds_mm = proto.folds_mm();
  numbers.first_fold_mm = {proto.first_fold_mm(0), proto.first_fold_mm(1), proto.first_fold_mm(2)};
  return numbers;
}

void PutFacts(const ProgramFacts& facts, v1::ProgramFacts* proto) {
  proto->set_seconds(facts.seconds);
  proto->set_filament_mm(facts.filament_mm);
  proto->set_moves(facts.moves);
  for (const double angle : facts.least_deg) proto->add_least_deg(angle);
  for (const double angle : facts.most_deg) proto->add_most_deg(angle);
}

absl::StatusOr<ProgramFacts> FactsIn(const v1::ProgramFacts& proto) {
  if (proto.least_deg_size() != 2 || proto.most_deg_size() != 2)
    return Malformed("least_deg, most_deg", "not two angles");
  return ProgramFacts{proto.seconds(),
                      proto.filament_mm(),
                      proto.moves(),
                      {proto.least_deg(0), proto.least_deg(1)},
                      {proto.most_deg(0), proto.most_deg(1)}};
}

}  // namespace

absl::Status ToProto(const EngraveLayout& layout, v1::EngraveLayout* proto) {
  proto->set_layer_count(layout.layer_count);
  proto->set_header(layout.header);
  proto->set_footer(layout.footer);
  v1::MapReport* map = proto->mutable_map();
  map->set_faces(layout.map.faces);
  map->set_area_mm2(layout.map.area_mm2);
  map->set_energy_mean(layout.map.energy_mean);
  map->set_energy_max(layout.map.energy_max);
  PutSpread(layout.map.stretch, map->mutable_stretch());
  PutSpread(layout.map.line_distance_mm, map->mutable_line_distance_mm());
  map->set_line_even(layout.map.line_even);
  return absl::OkStatus();
}

absl::StatusOr<EngraveLayout> FromProto(const v1::EngraveLayout& proto) {
  if (proto.layer_count() < 0 || proto.layer_count() > limits::kMaxLayers)
    return Malformed("layer_count", "is no number of layers");
  const v1::MapReport& map = proto.map();
  return EngraveLayout{
      proto.layer_count(),
      proto.header(),
      proto.footer(),
      {map.faces(), map.area_mm2(), map.energy_mean(), map.energy_max(), SpreadIn(map.stretch()),
       SpreadIn(map.line_distance_mm()), map.line_even()}};
}

absl::Status ToProto(const EngravedLayer& layer, v1::EngravedLayer* proto) {
  PutNumbers(layer.numbers, proto->mutable_numbers());
  PutFacts(layer.program, proto->mutable_program());
  return absl::OkStatus();
}

absl::StatusOr<EngravedLayer> FromProto(const v1::EngravedLayer& proto) {
  auto numbers = NumbersIn(proto.numbers());
  if (!numbers.ok()) return Within("numbers", numbers.status());
  auto facts = FactsIn(proto.program());
  if (!facts.ok()) return Within("program", facts.status());
  return EngravedLayer{*std::move(numbers), *std::move(facts), {}};
}

absl::Status TakePiece(const v1::EngravedPiece& piece, std::vector<EngravedLayer>* layers) {
  if (piece.has_layer()) {
    absl::StatusOr<EngravedLayer> layer = FromProto(piece.layer());
    if (!layer.ok()) return Within("layer", layer.status());
    layers->push_back(*std::move(layer));
    return absl::OkStatus();
  }
  if (layers->empty()) return Malformed("text", "is of no layer");
  layers->back().text += piece.text();
  if (std::ssize(layers->back().text) <= limits::kMaxProgramBytes) return absl::OkStatus();
  return Malformed("text", "is longer than a program may be");
}

}  // namespace slicefarm
