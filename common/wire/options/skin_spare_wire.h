#pragma once

#include <utility>

#include "common/model/limits.h"
#include "common/model/options/skin_spare.h"
#include "common/wire/options/settings_check.h"
#include "common/wire/support/wire_error.h"
#include "slicefarm/v1/settings.pb.h"

namespace slicefarm {

inline v1::SkinSpare ToProto(const SkinSpare& spare) {
  v1::SkinSpare proto;
  proto.set_layers(spare.layers);
  proto.set_enough_nm(spare.enough_nm);
  return proto;
}

inline SkinSpare SpareFromProto(const v1::SkinSpare& proto) {
  return {.layers = proto.layers(), .enough_nm = proto.enough_nm()};
}

/// Of a message with fields top_spare and bottom_spare.
template <typename Message>
absl::Status CheckSpares(const Message& proto) {
  absl::Status status =
      CheckNotNegative({{"top_spare.enough_nm", proto.top_spare().enough_nm()},
                        {"bottom_spare.enough_nm", proto.bottom_spare().enough_nm()}});
  for (const auto& [field, layers] :
       {std::pair("top_spare.layers", proto.top_spare().layers()),
        std::pair("bottom_spare.layers", proto.bottom_spare().layers())})
    if (layers < 0 || layers > limits::kMaxLayers)
      status.Update(Malformed(field, "is out of range"));
  return status;
}

}  // namespace slicefarm
