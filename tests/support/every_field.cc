#include "tests/support/every_field.h"

#include <fmt/core.h>

#include <memory>
#include <stdexcept>

#include "common/model/layers/job_plan.h"
#include "google/protobuf/descriptor.h"

namespace slicefarm {
namespace {

using google::protobuf::EnumDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

/// Returns the next value that is not 0.
int NextValue(const EnumDescriptor& type, int value) {
  return value + 1 < type.value_count() ? value + 1 : 1;
}

/// Returns the next number. The greatest number is followed by the least one.
int32_t Another(int32_t value) { return static_cast<int32_t>(static_cast<uint32_t>(value) + 1); }
int64_t Another(int64_t value) { return static_cast<int64_t>(static_cast<uint64_t>(value) + 1); }
double Another(double value) { return value / 2 + 0.125; }

void ChangeSingular(Message& message, const FieldDescriptor* field) {
  const Reflection& reflection = *message.GetReflection();
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return reflection.SetInt32(&message, field, Another(reflection.GetInt32(message, field)));
    case FieldDescriptor::CPPTYPE_INT64:
      return reflection.SetInt64(&message, field, Another(reflection.GetInt64(message, field)));
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return reflection.SetDouble(&message, field, Another(reflection.GetDouble(message, field)));
    case FieldDescriptor::CPPTYPE_BOOL:
      return reflection.SetBool(&message, field, !reflection.GetBool(message, field));
    case FieldDescriptor::CPPTYPE_ENUM:
      return reflection.SetEnumValue(
          &message, field, NextValue(*field->enum_type(), reflection.GetEnumValue(message, field)));
    case FieldDescriptor::CPPTYPE_STRING:
      return reflection.SetString(&message, field, reflection.GetString(message, field) + "x");
    default:
      throw std::logic_error("no change known for " + field->full_name());
  }
}

void ChangeElement(Message& message, const FieldDescriptor* field, int i) {
  const Reflection& reflection = *message.GetReflection();
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return reflection.SetRepeatedInt32(&message, field, i,
                                         Another(reflection.GetRepeatedInt32(message, field, i)));
    case FieldDescriptor::CPPTYPE_INT64:
      return reflection.SetRepeatedInt64(&message, field, i,
                                         Another(reflection.GetRepeatedInt64(message, field, i)));
    case FieldDescriptor::CPPTYPE_UINT32:
      return reflection.SetRepeatedUInt32(&message, field, i,
                                          reflection.GetRepeatedUInt32(message, field, i) + 1);
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return reflection.SetRepeatedDouble(&message, field, i,
                                          Another(reflection.GetRepeatedDouble(message, field, i)));
    case FieldDescriptor::CPPTYPE_ENUM:
      return reflection.SetRepeatedEnumValue(
          &message, field, i,
          NextValue(*field->enum_type(), reflection.GetRepeatedEnumValue(message, field, i)));
    case FieldDescriptor::CPPTYPE_STRING:
      return reflection.SetRepeatedString(&message, field, i,
                                          reflection.GetRepeatedString(message, field, i) + "x");
    default:
      throw std::logic_error("no change known for " + field->full_name());
  }
}

/// Function that finds a message within the given message.
using Locate = std::function<Message&(Message&)>;

class Walk {
 public:
  Walk(const Message& root, const std::function<void(const std::string&, const Message&)>& visit)
      : root_(root), visit_(visit) {}

  void Fields(const std::string& prefix, const Locate& locate) const {
    const std::unique_ptr<Message> copy = Copy();
    const Message& here = locate(*copy);
    for (int i = 0; i < here.GetDescriptor()->field_count(); ++i) {
      Field(prefix, locate, here, here.GetDescriptor()->field(i));
    }
  }

 private:
  std::unique_ptr<Message> Copy() const {
    std::unique_ptr<Message> copy(root_.New());
    copy->CopyFrom(root_);
    return copy;
  }

  void Field(const std::string& prefix, const Locate& locate, const Message& here,
             const FieldDescriptor* field) const {
    const std::string path = prefix + field->name();
    const Reflection& reflection = *here.GetReflection();
    const bool is_message = field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
    if (field->is_repeated()) {
      for (int i = 0; i < reflection.FieldSize(here, field); ++i) {
        Element(fmt::format("{}[{}]", path, i), locate, field, i, is_message);
      }
    } else if (!is_message) {
      const std::unique_ptr<Message> changed = Copy();
      ChangeSingular(locate(*changed), field);
      visit_(path, *changed);
    } else if (reflection.HasField(here, field)) {
      Fields(path + ".", [&](Message& root) -> Message& {
        Message& parent = locate(root);
        return *parent.GetReflection()->MutableMessage(&parent, field);
      });
    }
  }

  void Element(const std::string& path, const Locate& locate, const FieldDescriptor* field, int i,
               bool is_message) const {
    if (is_message) {
      return Fields(path + ".", [&](Message& root) -> Message& {
        Message& parent = locate(root);
        return *parent.GetReflection()->MutableRepeatedMessage(&parent, field, i);
      });
    }
    const std::unique_ptr<Message> changed = Copy();
    ChangeElement(locate(*changed), field, i);
    visit_(path, *changed);
  }

  const Message& root_;
  const std::function<void(const std::string&, const Message&)>& visit_;
};

}  // namespace

void ForEachChangedField(
    const Message& original,
    const std::function<void(const std::string& path, const Message&)>& visit) {
  Walk(original, visit).Fields("", [](Message& root) -> Message& { return root; });
}

}  // namespace slicefarm
