#include "services/coordinator/server/messages/result_wire.h"

#include <cstddef>

#include "services/coordinator/algo/pipeline/print_shares.h"

namespace slicefarm::coordinator {
namespace {

v1::PrintShare ShareToProto(const PrintShare& share, const Cost& cost) {
  v1::PrintShare proto;
  proto.set_time_s(share.time_s);
  proto.set_filament_mm(share.filament.length_mm);
  proto.set_filament_mm3(share.filament.volume_mm3);
  proto.set_filament_g(share.filament.mass_g);
  *proto.mutable_cost() = ToProto(cost);
  return proto;
}

void AddTo(const Cost& cost, Cost& sum) {
  sum.currency = cost.currency;
  sum.setup += cost.setup;
  sum.machine += cost.machine;
  sum.energy += cost.energy;
  sum.filament += cost.filament;
}

}  // namespace

v1::Cost ToProto(const Cost& cost) {
  v1::Cost proto;
  proto.set_currency(cost.currency);
  proto.set_setup(cost.setup);
  proto.set_machine(cost.machine);
  proto.set_energy(cost.energy);
  proto.set_filament(cost.filament);
  proto.set_total(cost.Total());
  return proto;
}

v1::JobResult ToProto(const JobResult& result) {
  v1::JobResult proto;
  proto.set_gcode_sha256(result.gcode_sha256);
  proto.set_gcode_size(result.gcode_size);
  proto.set_report_sha256(result.report_sha256);
  proto.set_print_time_s(result.print_time_s);
  proto.set_filament_mm(result.filament_mm);
  proto.set_filament_mm3(result.filament_mm3);
  proto.set_filament_g(result.filament_g);
  proto.set_layers(result.layers);
  proto.set_cached(result.cached);
  *proto.mutable_cost() = ToProto(result.cost);
  return proto;
}

void AddShares(const JobResult& result, v1::JobResult& proto) {
  if (result.shares.objects.empty()) return;
  PrintShare total;
  total.time_s = result.print_time_s;
  total.filament.mass_g = result.filament_g;
  const CostShares costs = DivideCost(result.cost, result.shares, total);
  size_t copy = 0;
  for (const ObjectShares& object : result.shares.objects) {
    v1::ObjectShare* share = proto.add_objects();
    share->set_name(object.name);
    Cost sum;
    for (const PrintShare& each : object.copies) {
      AddTo(costs.copies[copy], sum);
      *share->add_copies() = ShareToProto(each, costs.copies[copy++]);
    }
    *share->mutable_total() = ShareToProto(object.Total(), sum);
  }
  *proto.mutable_shared() = ShareToProto(result.shares.shared, costs.shared);
  proto.mutable_shared()->mutable_cost()->set_total(costs.shared_total);
}

}  // namespace slicefarm::coordinator
