#include "common/gcode/binary/meatpack.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

#include "common/base/text.h"

namespace slicefarm::gcode {
namespace {

constexpr std::string_view kSignal = "\xff\xff";
constexpr char kEnable = '\xfb';
constexpr char kDisable = '\xfa';
constexpr char kNoSpaces = '\xf7';
constexpr char kSpaces = '\xf6';
constexpr char kReset = '\xf9';

constexpr uint8_t kWhole = 15;  // the unpacked character follows
/// Characters in the order of their codes. `E` has the code of the blank, which is not packed.
constexpr std::string_view kPacked = "0123456789.E\nGX";

uint8_t NumberOf(char c) {
  static constexpr auto kNumbers = [] {
    std::array<uint8_t, 256> numbers{};
    for (uint8_t& number : numbers) number = kWhole;
    for (size_t i = 0; i < kPacked.size(); ++i)
      numbers[static_cast<unsigned char>(kPacked[i])] = static_cast<uint8_t>(i);
    return numbers;
  }();
  return kNumbers[static_cast<unsigned char>(c)];
}

/// Returns true if a command is G and a number: its words need no blanks between them.
bool IsMove(std::string_view line) {
  return line.size() > 1 && line[0] == 'G' && std::isdigit(static_cast<unsigned char>(line[1]));
}

/// Returns the part of a line that firmwares need; empty if there is none.
std::string Command(std::string_view line) {
  line = Trim(line.substr(0, line.find(';')));
  std::string command(line);
  if (IsMove(line)) std::erase(command, ' ');
  if (!command.empty()) command += '\n';
  if (command.size() % 2 != 0) command += '\n';
  return command;
}

class Packer {
 public:
  explicit Packer(size_t bytes) {
    text_.reserve(bytes / 2);
    WriteCommand(kEnable);
    WriteCommand(kNoSpaces);
  }

  void AddComment(std::string_view line) {
    if (packs_) WriteCommand(kDisable);
    packs_ = false;
    text_ += line;
    text_ += '\n';
  }

  void AddCommand(std::string_view pairs) {
    if (pairs.empty()) return;
    if (!packs_) WriteCommand(kEnable);
    packs_ = true;
    for (size_t i = 0; i < pairs.size(); i += 2) {
      const uint8_t low = NumberOf(pairs[i]), high = NumberOf(pairs[i + 1]);
      text_ += static_cast<char>(high << 4 | low);
      if (low == kWhole) text_ += pairs[i];
      if (high == kWhole) text_ += pairs[i + 1];
    }
  }

  std::string Take() { return std::move(text_); }

 private:
  void WriteCommand(char command) {
    text_ += kSignal;
    text_ += command;
  }

  std::string text_;
  bool packs_ = true;
};

}  // namespace

std::string MeatPack(std::string_view lines) {
  std::string text(lines);
  std::ranges::replace(text, '\xff', '?');
  std::ranges::replace(text, '\0', '?');
  Packer packer(text.size());
  for (std::string_view rest = text; !rest.empty();) {
    const size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with(';')) {
      packer.AddComment(line);
    } else {
      packer.AddCommand(Command(line));
    }
  }
  return packer.Take();
}

namespace {

class Unpacker {
 public:
  absl::Status Take(std::string_view packed) {
    for (size_t at = 0; at < packed.size();) {
      if (packed.substr(at).starts_with(kSignal)) {
        if (at + kSignal.size() == packed.size() || !Obey(packed[at + kSignal.size()]))
          return absl::InvalidArgumentError("contains an unknown MeatPack command");
        at += kSignal.size() + 1;
        continue;
      }
      const char byte = packed[at++];
      if (!packs_) {
        text_ += byte;
        continue;
      }
      const auto pair = static_cast<uint8_t>(byte);
      for (const int number : {pair & 15, pair >> 4}) {
        if (number == kWhole && at == packed.size())
          return absl::InvalidArgumentError("ends within a character");
        text_ += number == kWhole ? packed[at++] : Character(number);
      }
    }
    return absl::OkStatus();
  }

  std::string Text() && { return std::move(text_); }

 private:
  bool Obey(char command) {
    if (command == kEnable || command == kDisable || command == kReset) packs_ = command == kEnable;
    if (command == kNoSpaces || command == kSpaces) spaces_ = command == kSpaces;
    return command == kEnable || command == kDisable || command == kReset || command == kNoSpaces ||
           command == kSpaces;
  }

  char Character(int number) const {
    const char c = kPacked[static_cast<size_t>(number)];
    return c == 'E' && spaces_ ? ' ' : c;
  }

  bool packs_ = false;
  bool spaces_ = true;
  std::string text_;
};

}  // namespace

absl::StatusOr<std::string> MeatUnpack(std::string_view packed) {
  Unpacker unpacker;
  if (absl::Status taken = unpacker.Take(packed); !taken.ok()) return taken;
  return std::move(unpacker).Text();
}

}  // namespace slicefarm::gcode
