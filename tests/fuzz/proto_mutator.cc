#include "tests/fuzz/proto_mutator.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

// libFuzzer's own function, for bytes.
extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size);

namespace slicefarm::fuzz {
namespace {

using google::protobuf::EnumDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;
using Random = std::minstd_rand;

constexpr size_t kMaxTextBytes = 64;

bool OneIn(Random& random, unsigned int n) { return random() % n == 0; }

/// Returns a value near `value`, or at a limit of its type.
template <typename T>
T NextInteger(T value, Random& random) {
  using Limits = std::numeric_limits<T>;
  using Unsigned = std::make_unsigned_t<T>;  // unsigned arithmetic wraps around
  switch (random() % 8) {
    case 0:
      return 0;
    case 1:
      return Limits::max();
    case 2:
      return Limits::min();
    case 3:
      return static_cast<T>(static_cast<Unsigned>(value) * 2);
    case 4:
      return static_cast<T>(value / 2);
    case 5:
      return static_cast<T>(static_cast<Unsigned>(value) ^
                            Unsigned{1} << random() % std::min(31, Limits::digits));
    default:
      return static_cast<T>(static_cast<Unsigned>(value) + random() % 7 - 3);
  }
}

double NextDouble(double value, Random& random) {
  constexpr std::array kEdges = {0.0,
                                 -0.0,
                                 1.0,
                                 -1.0,
                                 1e-300,
                                 1e300,
                                 std::numeric_limits<double>::denorm_min(),
                                 std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()};
  switch (random() % 4) {
    case 0:
      return kEdges[random() % kEdges.size()];
    case 1:
      return value * 2;
    case 2:
      return value / 10;
    default:
      return value + static_cast<double>(random() % 200) / 100 - 1;
  }
}

int NextEnum(const EnumDescriptor& type, Random& random) {
  if (OneIn(random, 8)) return static_cast<int>(random());  // a value of a later version
  return type.value(static_cast<int>(random() % type.value_count()))->number();
}

std::string NextText(std::string value, bool utf8, Random& random) {
  const size_t limit = value.size() + kMaxTextBytes;
  std::string text = value;
  text.resize(limit);
  text.resize(LLVMFuzzerMutate(reinterpret_cast<uint8_t*>(text.data()), value.size(), limit));
  if (utf8 && !OneIn(random, 50)) {
    for (char& c : text) c = static_cast<char>(c & 0x7f);
  }
  return text;
}

/// Collects the sub-messages of a message, including the message itself.
void Collect(Message* message, std::vector<Message*>* all) {
  all->push_back(message);
  const Reflection& reflection = *message->GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(*message, &fields);
  for (const FieldDescriptor* field : fields) {
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE || field->is_map()) continue;
    if (!field->is_repeated()) {
      Collect(reflection.MutableMessage(message, field), all);
      continue;
    }
    for (int i = 0; i < reflection.FieldSize(*message, field); ++i)
      Collect(reflection.MutableRepeatedMessage(message, field, i), all);
  }
}

/// Applies `next` to a field, or to element `index` of a repeated one. For `index` -1 of a repeated
/// field it appends a changed copy of a standard value.
#define SLICEFARM_MUTATE(Type, next)                                                         \
  if (!field.is_repeated()) {                                                                \
    const auto value = reflection.Get##Type(*message, &field);                               \
    reflection.Set##Type(message, &field, next);                                             \
  } else if (index >= 0) {                                                                   \
    const auto value = reflection.GetRepeated##Type(*message, &field, index);                \
    reflection.SetRepeated##Type(message, &field, index, next);                              \
  } else {                                                                                   \
    const std::decay_t<decltype(reflection.GetRepeated##Type(*message, &field, 0))> value{}; \
    reflection.Add##Type(message, &field, next);                                             \
  }                                                                                          \
  return

void ChangeValue(Message* message, const FieldDescriptor& field, int index, Random& random) {
  const Reflection& reflection = *message->GetReflection();
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      SLICEFARM_MUTATE(Int32, NextInteger(value, random));
    case FieldDescriptor::CPPTYPE_INT64:
      SLICEFARM_MUTATE(Int64, NextInteger(value, random));
    case FieldDescriptor::CPPTYPE_UINT32:
      SLICEFARM_MUTATE(UInt32, NextInteger(value, random));
    case FieldDescriptor::CPPTYPE_UINT64:
      SLICEFARM_MUTATE(UInt64, NextInteger(value, random));
    case FieldDescriptor::CPPTYPE_DOUBLE:
      SLICEFARM_MUTATE(Double, NextDouble(value, random));
    case FieldDescriptor::CPPTYPE_FLOAT:
      SLICEFARM_MUTATE(Float, static_cast<float>(NextDouble(value, random)));
    case FieldDescriptor::CPPTYPE_BOOL:
      SLICEFARM_MUTATE(Bool, !value);
    case FieldDescriptor::CPPTYPE_ENUM:
      if (!field.is_repeated()) {
        reflection.SetEnumValue(message, &field, NextEnum(*field.enum_type(), random));
      } else if (index >= 0) {
        reflection.SetRepeatedEnumValue(message, &field, index,
                                        NextEnum(*field.enum_type(), random));
      } else {
        reflection.AddEnumValue(message, &field, NextEnum(*field.enum_type(), random));
      }
      return;
    case FieldDescriptor::CPPTYPE_STRING: {
      const bool utf8 = field.type() == FieldDescriptor::TYPE_STRING;
      SLICEFARM_MUTATE(String, NextText(value, utf8, random));
    }
    case FieldDescriptor::CPPTYPE_MESSAGE:
      if (field.is_repeated() && index < 0) {
        reflection.AddMessage(message, &field);
      } else if (!field.is_repeated()) {
        reflection.MutableMessage(message, &field);  // creates the message if it is missing
      }
      return;
  }
}
#undef SLICEFARM_MUTATE

/// Appends another copy of an element.
void Duplicate(Message* message, const FieldDescriptor& field, int index, Random& random) {
  const Reflection& reflection = *message->GetReflection();
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
    reflection.AddMessage(message, &field)
        ->CopyFrom(reflection.GetRepeatedMessage(*message, &field, index));
  } else {
    ChangeValue(message, field, -1, random);
  }
}

void ChangeRepeated(Message* message, const FieldDescriptor& field, Random& random) {
  const Reflection& reflection = *message->GetReflection();
  const int size = reflection.FieldSize(*message, &field);
  if (size == 0) return ChangeValue(message, field, -1, random);
  const int index = static_cast<int>(random() % size);
  switch (random() % 6) {
    case 0:
      return ChangeValue(message, field, -1, random);
    case 1:
      return Duplicate(message, field, index, random);
    case 2:
      return reflection.RemoveLast(message, &field);
    case 3:
      return reflection.SwapElements(message, &field, index, size - 1);
    default:
      return ChangeValue(message, field, index, random);
  }
}

void Change(Message* message, Random& random) {
  const auto& type = *message->GetDescriptor();
  if (type.field_count() == 0) return;
  const FieldDescriptor& field = *type.field(static_cast<int>(random() % type.field_count()));
  if (field.is_repeated()) return ChangeRepeated(message, field, random);
  if (OneIn(random, 6)) return message->GetReflection()->ClearField(message, &field);
  ChangeValue(message, field, 0, random);
}

/// Returns the size of the serialized message; 0 if it is too large.
size_t Store(const Message& message, uint8_t* data, size_t max_size) {
  const size_t size = message.ByteSizeLong();
  if (size > max_size || !message.SerializeToArray(data, static_cast<int>(max_size))) return 0;
  return size;
}

}  // namespace

size_t MutateProto(Message& scratch, uint8_t* data, size_t size, size_t max_size,
                   unsigned int seed) {
  Random random(seed);
  if (OneIn(random, 20) || !scratch.ParseFromArray(data, static_cast<int>(size))) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  for (unsigned int i = 1 + random() % 3; i > 0; --i) {
    std::vector<Message*> all;
    Collect(&scratch, &all);
    Change(all[random() % all.size()], random);
  }
  const size_t stored = Store(scratch, data, max_size);
  return stored > 0 ? stored : LLVMFuzzerMutate(data, size, max_size);
}

size_t JoinProtos(Message& scratch, const uint8_t* first, size_t first_size, const uint8_t* second,
                  size_t second_size, uint8_t* out, size_t max_size) {
  // Fields of the second message are appended to, or replace, the fields of the first.
  if (!scratch.ParseFromArray(first, static_cast<int>(first_size))) return 0;
  std::string bytes(reinterpret_cast<const char*>(first), first_size);
  bytes.append(reinterpret_cast<const char*>(second), second_size);
  if (bytes.size() > max_size) return 0;
  std::memcpy(out, bytes.data(), bytes.size());
  return bytes.size();
}

}  // namespace slicefarm::fuzz
