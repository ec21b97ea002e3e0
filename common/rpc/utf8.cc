#include "common/rpc/utf8.h"

#include <algorithm>
#include <cstdint>

namespace slicefarm::rpc {
namespace {

/// Length of the sequence that begins with `first`; 0 if none does. Two-byte forms of ASCII and
/// what lies beyond U+10FFFF are out by their first byte.
size_t SequenceLength(uint8_t first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  if (first >= 0xf0 && first < 0xf5) return 4;
  return 0;
}

/// The first continuation byte narrows what the first byte leaves open: no overlong forms, no
/// surrogates.
bool IsSecond(uint8_t first, uint8_t second) {
  const uint8_t least = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
  const uint8_t most = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
  return least <= second && second <= most;
}

bool IsSequence(std::string_view bytes) {
  if (bytes.size() == 1) return true;
  return IsSecond(bytes[0], bytes[1]) && std::all_of(bytes.begin() + 2, bytes.end(), [](char c) {
           return (static_cast<uint8_t>(c) & 0xc0) == 0x80;
         });
}

}  // namespace

std::string ToUtf8(std::string_view text, size_t max_bytes) {
  std::string result;
  for (size_t i = 0; i < text.size();) {
    const size_t length = SequenceLength(static_cast<uint8_t>(text[i]));
    const std::string_view sequence = text.substr(i, length);
    const bool good = length > 0 && sequence.size() == length && IsSequence(sequence);
    if (result.size() + (good ? length : 1) > max_bytes) break;
    good ? result.append(sequence) : result.append(1, '?');
    i += good ? length : 1;
  }
  return result;
}

}  // namespace slicefarm::rpc
