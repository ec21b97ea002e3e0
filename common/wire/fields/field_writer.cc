#include "common/wire/fields/field_writer.h"

#include <array>
#include <bit>
#include <cstring>

namespace slicefarm::internal {

static_assert(std::endian::native == std::endian::little, "all machines of a farm are");

void FieldWriter::WriteInteger(int64_t value) {
  std::array<char, sizeof value> bytes;
  std::memcpy(bytes.data(), &value, sizeof value);
  bytes_.append(bytes.data(), bytes.size());
}

void FieldWriter::Write(double value) { WriteInteger(std::bit_cast<int64_t>(value)); }

void FieldWriter::Write(const std::string& text) {
  WriteInteger(static_cast<int64_t>(text.size()));
  bytes_ += text;
}

void FieldWriter::Write(const SharedText& text) {
  const auto number = static_cast<int64_t>(texts_.size()) + 1;
  const auto [known, is_new] = texts_.try_emplace(text.str(), number);
  WriteInteger(known->second);
  if (is_new) Write(text.str());
}

void FieldWriter::Write(const Cutter& cutter) { Write(cutter.name()); }

}  // namespace slicefarm::internal
