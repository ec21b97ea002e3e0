#include "common/wire/calibration_wire.h"

namespace slicefarm {

v1::CalibrationTable ToProto(const CalibrationTable& table) {
  v1::CalibrationTable proto;
  proto.set_kind(table.kind);
  proto.set_unit(table.unit);
  proto.set_setting(table.setting);
  for (const CalibrationRow& row : table.rows) {
    v1::CalibrationValue& value = *proto.add_values();
    value.set_label(row.label);
    value.set_value(row.value);
    value.set_object(row.object);
    value.set_from_mm(row.from_mm);
    value.set_to_mm(row.to_mm);
  }
  return proto;
}

CalibrationTable FromProto(const v1::CalibrationTable& proto) {
  CalibrationTable table = {proto.kind(), proto.unit(), proto.setting(), {}};
  for (const v1::CalibrationValue& value : proto.values())
    table.rows.push_back(
        {value.label(), value.value(), value.from_mm(), value.to_mm(), value.object()});
  return table;
}

}  // namespace slicefarm
