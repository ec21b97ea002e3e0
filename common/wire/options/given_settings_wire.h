#pragma once

#include <vector>

#include "common/model/setting.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm {

// Conversion of settings in the form in which clients give them.

/// Converts a setting to its message.
inline v1::Setting ToProto(const Setting& setting) {
  v1::Setting proto;
  proto.set_key(setting.key);
  proto.set_value(setting.value);
  proto.set_from_profile(setting.source == Source::kProfile);
  return proto;
}

/// Returns the setting of a message, including its source (profile or request).
inline Setting FromProto(const v1::Setting& proto) {
  return {proto.key(), proto.value(), proto.from_profile() ? Source::kProfile : Source::kRequest};
}

/// Converts all settings and appends their messages.
inline void SettingsToProto(const std::vector<Setting>& settings,
                            google::protobuf::RepeatedPtrField<v1::Setting>* proto) {
  for (const Setting& setting : settings) *proto->Add() = ToProto(setting);
}

/// Returns the settings of all messages.
inline std::vector<Setting> SettingsFromProto(
    const google::protobuf::RepeatedPtrField<v1::Setting>& proto) {
  std::vector<Setting> settings;
  settings.reserve(proto.size());
  for (const v1::Setting& setting : proto) settings.push_back(FromProto(setting));
  return settings;
}

}  // namespace slicefarm
