#include "common/base/utf8.h"

#include <algorithm>
#include <cstdint>

namespace slicefarm {
namespace {

/// Returns the length of the UTF-8 sequence that begins with `first`, or 0 if no sequence does.
/// Two-byte forms of ASCII and code points beyond U+10FFFF are excluded by their first byte.
size_t SequenceLength(uint8_t first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  if (first >= 0xf0 && first < 0xf5) return 4;
  return 0;
}

/// Returns true if `second` may follow `first`. This excludes overlong forms and surrogates, which
/// the first byte does not exclude.
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

/// Returns the sequence at the start of `text`, or an empty text if there is no valid one.
std::string_view FirstSequence(std::string_view text) {
  const size_t length = SequenceLength(static_cast<uint8_t>(text[0]));
  const std::string_view sequence = text.substr(0, length);
  return length > 0 && sequence.size() == length && IsSequence(sequence) ? sequence
                                                                         : std::string_view();
}

}  // namespace

std::string ToUtf8(std::string_view text, size_t max_bytes) {
  std::string result;
  while (!text.empty()) {
    const std::string_view sequence = FirstSequence(text);
    const std::string_view piece = sequence.empty() ? "?" : sequence;
    if (result.size() + piece.size() > max_bytes) break;
    result.append(piece);
    text.remove_prefix(piece.size());
  }
  return result;
}

bool IsUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::string_view sequence = FirstSequence(text);
    if (sequence.empty()) return false;
    text.remove_prefix(sequence.size());
  }
  return true;
}

}  // namespace slicefarm
