#include "common/wire/options/settings_check.h"

#include <cmath>
#include <string>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/support/wire_error.h"
#include "google/protobuf/descriptor.h"

namespace slicefarm {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

absl::Status CheckDoubles(const Message& message, const FieldDescriptor& field) {
  const Reflection& reflection = *message.GetReflection();
  if (!field.is_repeated()) {
    if (std::isfinite(reflection.GetDouble(message, &field))) return absl::OkStatus();
    return Malformed(field.name(), "is not finite");
  }
  for (int i = 0; i < reflection.FieldSize(message, &field); ++i) {
    if (!std::isfinite(reflection.GetRepeatedDouble(message, &field, i))) {
      return Malformed(field.name(), "is not finite");
    }
  }
  return absl::OkStatus();
}

absl::Status CheckEnum(const Message& message, const FieldDescriptor& field) {
  const int value = message.GetReflection()->GetEnumValue(message, &field);
  if (value == 0) return Malformed(field.name(), "is not given");
  if (field.enum_type()->FindValueByNumber(value) == nullptr) {
    return Malformed(field.name(), "is not a value of this version");
  }
  return absl::OkStatus();
}

absl::Status CheckString(const Message& message, const FieldDescriptor& field) {
  std::string scratch;
  const auto size = static_cast<int64_t>(
      message.GetReflection()->GetStringReference(message, &field, &scratch).size());
  const int64_t most = limits::MaxSettingBytes(field.name());
  if (size <= most) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "bytes of " + field.name(), most, size);
}

absl::Status CheckMessage(const Message& message, const FieldDescriptor& field) {
  if (field.is_repeated()) return absl::OkStatus();
  const Reflection& reflection = *message.GetReflection();
  if (!reflection.HasField(message, &field) && field.has_optional_keyword())
    return absl::OkStatus();
  if (!reflection.HasField(message, &field)) return Malformed(field.name(), "is not given");
  const absl::Status status = CheckComplete(reflection.GetMessage(message, &field));
  return status.ok() ? status : Within(field.name(), status);
}

absl::Status CheckField(const Message& message, const FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return CheckDoubles(message, field);
    case FieldDescriptor::CPPTYPE_ENUM:
      return CheckEnum(message, field);
    case FieldDescriptor::CPPTYPE_STRING:
      return CheckString(message, field);
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return CheckMessage(message, field);
    default:
      return absl::OkStatus();
  }
}

}  // namespace

absl::Status CheckComplete(const Message& options) {
  for (int i = 0; i < options.GetDescriptor()->field_count(); ++i) {
    const absl::Status status = CheckField(options, *options.GetDescriptor()->field(i));
    if (!status.ok()) return status;
  }
  return absl::OkStatus();
}

absl::Status CheckLengths(std::initializer_list<NamedLength> lengths, Coord least_nm) {
  for (const auto& [field, value_nm] : lengths) {
    if (value_nm < least_nm || value_nm > limits::kMaxCoord) {
      return Malformed(field, "is out of range");
    }
  }
  return absl::OkStatus();
}

}  // namespace slicefarm
