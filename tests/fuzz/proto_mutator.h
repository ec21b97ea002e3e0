#pragma once

#include <cstddef>
#include <cstdint>

#include "google/protobuf/message.h"

namespace slicefarm::fuzz {

/// Changes a serialized message into another one, most often field by field, so that it can still
/// be parsed: what bytes alone seldom do to nested messages. `scratch` is an empty message of its
/// type. To be called by LLVMFuzzerCustomMutator; gives the new size.
size_t MutateProto(google::protobuf::Message& scratch, uint8_t* data, size_t size, size_t max_size,
                   unsigned int seed);

/// Joins two messages. To be called by LLVMFuzzerCustomCrossOver.
size_t JoinProtos(google::protobuf::Message& scratch, const uint8_t* first, size_t first_size,
                  const uint8_t* second, size_t second_size, uint8_t* out, size_t max_size);

}  // namespace slicefarm::fuzz

/// libFuzzer's entry points for a fuzzer whose inputs are messages of type `Message`, which
/// `Run(const Message&)` is to survive.
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
