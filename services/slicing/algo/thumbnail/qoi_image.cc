#include "services/slicing/algo/thumbnail/qoi_image.h"

#include <array>
#include <string_view>

namespace slicefarm::slicing {
namespace {

// The first bits of a chunk say what it is.
constexpr uint8_t kIndex = 0x00;
constexpr uint8_t kSmallChange = 0x40;
constexpr uint8_t kChangeByGreen = 0x80;
constexpr uint8_t kRun = 0xc0;
constexpr uint8_t kRgb = 0xfe;
constexpr uint8_t kRgba = 0xff;
constexpr int kLongestRun = 62;
constexpr uint8_t kChannels = 4;
constexpr uint8_t kLinearOpacity = 0;
constexpr std::string_view kEnd("\0\0\0\0\0\0\0\1", 8);

size_t PlaceOf(const Rgba& p) { return (p[0] * 3u + p[1] * 5u + p[2] * 7u + p[3] * 11u) % 64; }

class Encoder {
 public:
  explicit Encoder(std::string& out) : out_(out) {}

  void Add(const Rgba& pixel) {
    if (pixel == last_) {
      if (++run_ == kLongestRun) EndRun();
      return;
    }
    EndRun();
    Rgba& seen = seen_[PlaceOf(pixel)];
    if (seen == pixel) {
      Byte(kIndex | static_cast<int>(PlaceOf(pixel)));
    } else {
      seen = pixel;
      if (pixel[3] == last_[3]) {
        AddChange(pixel);
      } else {
        Byte(kRgba);
        for (const uint8_t channel : pixel) Byte(channel);
      }
    }
    last_ = pixel;
  }

  void EndRun() {
    if (run_ > 0) Byte(kRun | (run_ - 1));
    run_ = 0;
  }

 private:
  void Byte(int value) { out_.push_back(static_cast<char>(value)); }

  /// Of the same opacity as the pixel before; differences wrap round.
  void AddChange(const Rgba& pixel) {
    const auto change = [&](size_t channel) {
      return static_cast<int>(static_cast<int8_t>(pixel[channel] - last_[channel]));
    };
    const auto within = [](int value, int low, int high) { return low <= value && value <= high; };
    const int red = change(0), green = change(1), blue = change(2);
    const int red_over = red - green, blue_over = blue - green;
    if (within(red, -2, 1) && within(green, -2, 1) && within(blue, -2, 1)) {
      Byte(kSmallChange | (red + 2) << 4 | (green + 2) << 2 | (blue + 2));
    } else if (within(green, -32, 31) && within(red_over, -8, 7) && within(blue_over, -8, 7)) {
      Byte(kChangeByGreen | (green + 32));
      Byte((red_over + 8) << 4 | (blue_over + 8));
    } else {
      Byte(kRgb);
      for (size_t channel = 0; channel < 3; ++channel) Byte(pixel[channel]);
    }
  }

  std::string& out_;
  Rgba last_ = {0, 0, 0, 255};
  std::array<Rgba, 64> seen_ = {};
  int run_ = 0;
};

void Append(int32_t number, std::string& out) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<char>(number >> shift));
}

}  // namespace

std::string EncodeQoi(std::span<const Rgba> pixels, int32_t width, int32_t height) {
  std::string out = "qoif";
  Append(width, out);
  Append(height, out);
  out.push_back(static_cast<char>(kChannels));
  out.push_back(static_cast<char>(kLinearOpacity));
  Encoder encoder(out);
  for (const Rgba& pixel : pixels) encoder.Add(pixel);
  encoder.EndRun();
  return out.append(kEnd);
}

}  // namespace slicefarm::slicing
