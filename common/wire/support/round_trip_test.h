#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/error.h"
#include "google/protobuf/util/message_differencer.h"
#include "tests/support/every_field.h"

namespace slicefarm {

/// Helpers to test converters of the form `absl::Status ToProto(const Model&, Proto*)` and
/// `absl::StatusOr<Model> FromProto(const Proto&)`.
template <typename Proto, typename Model>
Proto ProtoOf(const Model& model) {
  Proto proto;
  const absl::Status status = ToProto(model, &proto);
  EXPECT_TRUE(status.ok()) << status;
  return proto;
}

template <typename Proto, typename Model>
void ExpectReturns(const Model& model) {
  const absl::StatusOr<Model> back = FromProto(ProtoOf<Proto>(model));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(*back, model);
}

/// Expects that the message returns unchanged from the model when any single field is changed.
/// `refused`: parts of the paths of fields with a rule that the change violates; the message is
/// then refused. `apart`: parts of the paths of fields that are read from another source and do not
/// return.
template <typename Proto, typename Model>
void ExpectEveryChangeReturns(const Proto& original,
                              const std::vector<std::string_view>& refused = {},
                              const std::vector<std::string_view>& apart = {}) {
  const auto is_one_of = [](const std::string& path, const std::vector<std::string_view>& fields) {
    return std::ranges::any_of(
        fields, [&](std::string_view field) { return path.find(field) != std::string::npos; });
  };
  int accepted = 0;
  ForEachChangedField(
      original, [&](const std::string& path, const google::protobuf::Message& message) {
        SCOPED_TRACE(path);
        const auto& changed = dynamic_cast<const Proto&>(message);
        const absl::StatusOr<Model> meant = FromProto(changed);
        if (!meant.ok()) {
          EXPECT_TRUE(is_one_of(path, refused)) << meant.status();
          return;
        }
        ++accepted;
        if (is_one_of(path, apart)) return;
        EXPECT_TRUE(
            google::protobuf::util::MessageDifferencer::Equals(ProtoOf<Proto>(*meant), changed));
      });
  EXPECT_GE(accepted, 2);
}

/// Expects a REQUEST_MALFORMED error that names the field.
inline void ExpectMalformed(const absl::Status& status, std::string_view field) {
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed) << status;
  EXPECT_EQ(DetailOf(status).metadata["field"], field) << status;
}

}  // namespace slicefarm
