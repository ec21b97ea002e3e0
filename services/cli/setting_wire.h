#pragma once

#include "common/config/resolve.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::cli {

inline v1::Setting ToProto(const config::Setting& setting) {
  v1::Setting proto;
  proto.set_key(setting.key);
  proto.set_value(setting.value);
  proto.set_from_profile(setting.source == config::Source::kProfile);
  return proto;
}

}  // namespace slicefarm::cli
