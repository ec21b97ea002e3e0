#pragma once

#include <cstddef>
#include <cstdint>

#include "google/protobuf/message.h"

namespace slicefarm::fuzz {

/// Changes a serialized message into another message, usually field by field, so that the result
/// can still be parsed. Random changes of bytes rarely achieve this for nested messages. `scratch`:
/// an empty message of the same type. Called by LLVMFuzzerCustomMutator. Returns the new size.
size_t MutateProto(google::protobuf::Message& scratch, uint8_t* data, size_t size, size_t max_size,
                   unsigned int seed);

/// Joins two messages. Called by LLVMFuzzerCustomCrossOver.
size_t JoinProtos(google::protobuf::Message& scratch, const uint8_t* first, size_t first_size,
                  const uint8_t* second, size_t second_size, uint8_t* out, size_t max_size);

}  // namespace slicefarm::fuzz

/// Defines libFuzzer's entry points for a fuzzer with inputs of the message type `Message`.
/// `Run(const Message&)` must not crash.
#define SLICEFARM_PROTO_FUZZER(Message, Run)                                                 \
  extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {                  \
    Message message;                                                                         \
    if (message.ParseFromArray(data, static_cast<int>(size))) Run(message);                  \
    return 0;                                                                                \
  }                                                                                          \
  extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t max_size,     \
                                            unsigned int seed) {                             \
    Message message;                                                                         \
    return slicefarm::fuzz::MutateProto(message, data, size, max_size, seed);                \
  }                                                                                          \
  extern "C" size_t LLVMFuzzerCustomCrossOver(const uint8_t* first, size_t first_size,       \
                                              const uint8_t* second, size_t second_size,     \
                                              uint8_t* out, size_t max_size, unsigned int) { \
    Message message;                                                                         \
    return slicefarm::fuzz::JoinProtos(message, first, first_size, second, second_size, out, \
                                       max_size);                                            \
  }
