#include "services/slicing/algo/mesh_io/threemf/package/element_scan.h"

#include <array>
#include <cstring>

namespace slicefarm::slicing::threemf {
namespace {

bool IsSpace(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// Tables of the bytes allowed in an attribute's name, and of the bytes allowed unescaped in its
/// value.
struct Bytes {
  std::array<bool, 256> name = {};
  std::array<bool, 256> value = {};
};

constexpr Bytes MakeBytes() {
  Bytes bytes;
  for (int c = 0x20; c < 0x7f; ++c) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    bytes.name[c] = letter || (c >= '0' && c <= '9') || c == '_' || c == ':';
    bytes.value[c] = c != '"' && c != '\'' && c != '<' && c != '&';
  }
  return bytes;
}

constexpr Bytes kBytes = MakeBytes();

const char* SkipWhile(const std::array<bool, 256>& set, const char* at, const char* end) {
  while (at != end && set[static_cast<unsigned char>(*at)]) ++at;
  return at;
}

}  // namespace

void ElementScan::SkipSpace() {
  size_t size = 0;
  while (size < rest_.size() && IsSpace(rest_[size])) lines_ += rest_[size++] == '\n';
  rest_.remove_prefix(size);
}

ScanEnd ElementScan::Next() {
  SkipSpace();
  const size_t head = name_.size() + 1;  // "<vertex"
  if (rest_.size() <= head) return ScanEnd::kMore;
  if (rest_[0] != '<' || std::memcmp(rest_.data() + 1, name_.data(), name_.size()) != 0)
    return ScanEnd::kOther;
  attributes_.clear();
  return Attributes(rest_.data() + head, rest_.data() + rest_.size());
}

ScanEnd ElementScan::Attributes(const char* at, const char* const end) {
  for (;;) {
    const char* const before = at;
    while (at != end && IsSpace(*at)) {
      if (*at == '\n') return ScanEnd::kOther;  // a line end here must not be counted twice
      ++at;
    }
    if (end - at < 2) return ScanEnd::kMore;
    if (at[0] == '/' && at[1] == '>') {
      rest_.remove_prefix(static_cast<size_t>(at + 2 - rest_.data()));
      return ScanEnd::kElement;
    }
    if (at == before) return ScanEnd::kOther;
    const char* const name = at;
    at = SkipWhile(kBytes.name, at, end);
    if (end - at < 2) return ScanEnd::kMore;
    if (at == name || at[0] != '=' || (at[1] != '"' && at[1] != '\'')) return ScanEnd::kOther;
    const char quote = at[1];
    const char* const value = at + 2;
    const std::string_view attribute(name, static_cast<size_t>(at - name));
    at = SkipWhile(kBytes.value, value, end);
    if (at == end) return ScanEnd::kMore;
    if (*at != quote || Find(attributes_, attribute).has_value()) return ScanEnd::kOther;
    attributes_.push_back({attribute, {value, static_cast<size_t>(at - value)}});
    ++at;
  }
}

}  // namespace slicefarm::slicing::threemf
