#include "common/gcode/binary/heatshrink.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace slicefarm::gcode {
namespace {

constexpr int kWindowBits = 12;
constexpr int kLengthBits = 4;
constexpr size_t kWindow = size_t{1} << kWindowBits;
constexpr size_t kLongest = size_t{1} << kLengthBits;
constexpr uint32_t kLiteralBits = 1 + 8;
constexpr uint32_t kMatchBits = 1 + kWindowBits + kLengthBits;
constexpr size_t kShortest = 2;  // a single byte is shorter as a literal

struct Match {
  uint16_t length = 0;  ///< 0: no match
  uint16_t back = 0;
};

/// Last positions of byte sequences, by their hash. Each position has a link to the previous one.
class Chains {
 public:
  Chains(size_t bytes, int hash_bits)
      : last_(size_t{1} << hash_bits, kNowhere), before_(bytes, kNowhere) {}

  static constexpr int32_t kNowhere = -1;

  int32_t Last(uint32_t hash) const { return last_[hash]; }
  int32_t Before(int32_t place) const { return before_[static_cast<size_t>(place)]; }
  void Add(uint32_t hash, int32_t place) {
    before_[static_cast<size_t>(place)] = last_[hash];
    last_[hash] = place;
  }

 private:
  std::vector<int32_t> last_;
  std::vector<int32_t> before_;
};

class Matches {
 public:
  explicit Matches(std::string_view bytes)
      : bytes_(bytes), pairs_(bytes.size(), 16), triples_(bytes.size(), kTripleBits) {}

  /// Returns the longest match at a position. Call it for each position in ascending order.
  Match At(size_t place) {
    Match best;
    if (place + kShortest > bytes_.size()) return best;
    const auto here = static_cast<int32_t>(place);
    const uint32_t pair = Byte(place) << 8 | Byte(place + 1);
    if (const int32_t from = pairs_.Last(pair); Reaches(from, place))
      best = {kShortest, static_cast<uint16_t>(here - from)};
    if (place + kShortest < bytes_.size()) {
      const uint32_t triple = HashOf(pair << 8 | Byte(place + 2));
      Longest(triple, place, best);
      triples_.Add(triple, here);
    }
    pairs_.Add(pair, here);
    return best;
  }

 private:
  static constexpr int kTripleBits = 15;

  uint32_t Byte(size_t place) const { return static_cast<unsigned char>(bytes_[place]); }
  static uint32_t HashOf(uint32_t three) { return three * 2654435761u >> (32 - kTripleBits); }
  static bool Reaches(int32_t from, size_t place) {
    return from != Chains::kNowhere && place - static_cast<size_t>(from) <= kWindow;
  }

  void Longest(uint32_t triple, size_t place, Match& best) const {
    const size_t most = std::min(kLongest, bytes_.size() - place);
    const char* const here = bytes_.data() + place;
    for (int32_t from = triples_.Last(triple); Reaches(from, place) && best.length < most;
         from = triples_.Before(from)) {
      const char* const there = bytes_.data() + from;
      if (there[best.length] != here[best.length]) continue;
      const auto length = static_cast<size_t>(std::mismatch(here, here + most, there).first - here);
      if (length > best.length)
        best = {static_cast<uint16_t>(length),
                static_cast<uint16_t>(place - static_cast<size_t>(from))};
    }
  }

  const std::string_view bytes_;
  Chains pairs_;
  Chains triples_;
};

class BitWriter {
 public:
  void Write(uint32_t value, int bits) {
    kept_ = kept_ << bits | value;
    for (count_ += bits; count_ >= 8; count_ -= 8)
      text_ += static_cast<char>(kept_ >> (count_ - 8) & 0xff);
  }
  std::string Take() {
    if (count_ > 0) Write(0, 8 - count_);
    return std::move(text_);
  }

 private:
  uint64_t kept_ = 0;
  int count_ = 0;
  std::string text_;
};

/// Removes the matches that are not part of a shortest stream, from the last byte to the first. A
/// shorter remainder never costs more bits than a longer one, so a chosen match is used in its full
/// length.
void ChooseMatches(std::vector<Match>& matches) {
  std::vector<uint32_t> bits(matches.size() + 1, 0);
  for (size_t i = matches.size(); i-- > 0;) {
    const uint32_t by_byte = kLiteralBits + bits[i + 1];
    const uint32_t by_match = kMatchBits + bits[i + matches[i].length];
    if (matches[i].length > 0 && by_match >= by_byte) matches[i].length = 0;
    bits[i] = matches[i].length > 0 ? by_match : by_byte;
  }
}

}  // namespace

std::string Heatshrink(std::string_view bytes) {
  std::vector<Match> matches(bytes.size());
  Matches found(bytes);
  for (size_t i = 0; i < bytes.size(); ++i) matches[i] = found.At(i);
  ChooseMatches(matches);
  BitWriter out;
  for (size_t i = 0; i < bytes.size();) {
    const Match& match = matches[i];
    if (match.length == 0) {
      out.Write(0x100u | static_cast<unsigned char>(bytes[i++]), kLiteralBits);
      continue;
    }
    out.Write(static_cast<uint32_t>(match.back - 1) << kLengthBits | (match.length - 1u),
              kMatchBits);
    i += match.length;
  }
  return out.Take();
}

namespace {

class BitReader {
 public:
  explicit BitReader(std::string_view bytes) : bytes_(bytes) {}

  /// Reads a number of bits. Returns -1 if there are too few bits.
  int32_t Read(int bits) {
    while (count_ < bits) {
      if (at_ == bytes_.size()) return -1;
      kept_ = kept_ << 8 | static_cast<unsigned char>(bytes_[at_++]);
      count_ += 8;
    }
    count_ -= bits;
    return static_cast<int32_t>(kept_ >> count_ & ((uint64_t{1} << bits) - 1));
  }

 private:
  const std::string_view bytes_;
  size_t at_ = 0;
  uint64_t kept_ = 0;
  int count_ = 0;
};

}  // namespace

absl::StatusOr<std::string> Unheatshrink(std::string_view stream, size_t size, int window_bits) {
  const auto broken = [] { return absl::InvalidArgumentError("is not a Heatshrink stream"); };
  BitReader in(stream);
  std::string bytes;
  bytes.reserve(size);
  while (bytes.size() < size) {
    const int32_t is_literal = in.Read(1);
    if (is_literal == 1) {
      const int32_t byte = in.Read(8);
      if (byte < 0) return broken();
      bytes += static_cast<char>(byte);
      continue;
    }
    const int32_t back = in.Read(window_bits), length = in.Read(kLengthBits);
    if (is_literal < 0 || back < 0 || length < 0) return broken();
    if (static_cast<size_t>(back) + 1 > bytes.size()) return broken();
    if (bytes.size() + static_cast<size_t>(length) + 1 > size) return broken();
    for (int32_t i = 0; i <= length; ++i)
      bytes += bytes[bytes.size() - static_cast<size_t>(back) - 1];
  }
  return bytes;
}

}  // namespace slicefarm::gcode
