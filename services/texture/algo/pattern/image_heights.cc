#include "services/texture/algo/pattern/image_heights.h"

#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <cstring>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "services/texture/algo/pattern/computed_heights.h"

namespace slicefarm::texture {
namespace {

/// Reader of PNG bytes in memory by libpng. Its errors leave by longjmp.
class PngReading {
 public:
  explicit PngReading(std::string_view bytes)
      : rest_(bytes),
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &OnError, &OnWarning)),
        info_(png_create_info_struct(png_)) {
    png_set_read_fn(png_, this, &Read);
    png_set_chunk_malloc_max(png_, 1 << 20);
  }
  ~PngReading() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReading(const PngReading&) = delete;
  PngReading& operator=(const PngReading&) = delete;

  int64_t columns() const { return png_get_image_width(png_, info_); }
  int64_t rows() const { return png_get_image_height(png_, info_); }
  const std::string& words() const { return words_; }

  bool ReadHeader() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_info(png_, info_);
    return true;
  }

  /// Reads red, green, blue and alpha with 16 bits each, unchanged from the file, because gamma
  /// correction would distort heights.
  bool ReadPixels(std::vector<png_bytep>& rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_expand_16(png_);
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, 0xffff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    if (png_get_rowbytes(png_, info_) != static_cast<size_t>(columns()) * 8) return false;
    png_read_image(png_, rows.data());
    png_read_end(png_, nullptr);
    return true;
  }

 private:
  static void Read(png_structp png, png_bytep to, size_t count) {
    auto* self = static_cast<PngReading*>(png_get_io_ptr(png));
    if (count > self->rest_.size()) png_error(png, "it ends too early");
    std::memcpy(to, self->rest_.data(), count);
    self->rest_.remove_prefix(count);
  }
  [[noreturn]] static void OnError(png_structp png, png_const_charp words) {
    static_cast<PngReading*>(png_get_error_ptr(png))->words_ = words;
    png_longjmp(png, 1);
  }
  static void OnWarning(png_structp /*png*/, png_const_charp /*words*/) {}

  std::string_view rest_;
  std::string words_;
  png_structp png_;
  png_infop info_;
};

absl::Status MalformedImage(std::string_view words) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   fmt::format("the texture is not a readable PNG image: {}", words));
}

/// Returns the height, 0 to 1, of a pixel of four big-endian numbers.
double HeightShare(const png_byte* pixel) {
  const auto value = [&](int channel) { return pixel[2 * channel] * 256 + pixel[2 * channel + 1]; };
  const double luminance = (0.2126 * value(0) + 0.7152 * value(1) + 0.0722 * value(2)) / 65535;
  return luminance * value(3) / 65535;
}

}  // namespace

absl::StatusOr<HeightGrid> ImageHeights(std::string_view png, const ImageHeightOptions& options) {
  PngReading reading(png);
  if (!reading.ReadHeader()) return MalformedImage(reading.words());
  const int64_t columns = reading.columns(), rows = reading.rows();
  if (columns * rows > kMaxHeightNodes)
    return LimitError(Reason::kRequestTooLarge, "pixels of the texture", kMaxHeightNodes,
                      columns * rows);
  std::vector<png_byte> bytes(static_cast<size_t>(columns * rows) * 8);
  std::vector<png_bytep> lines;
  for (int64_t row = 0; row < rows; ++row) lines.push_back(bytes.data() + row * columns * 8);
  if (!reading.ReadPixels(lines)) return MalformedImage(reading.words());
  HeightGrid grid{static_cast<int32_t>(columns),
                  static_cast<int32_t>(rows),
                  Eigen::Vector2d(options.width_mm, options.width_mm * static_cast<double>(rows) /
                                                        static_cast<double>(columns)),
                  {}};
  grid.heights_mm.reserve(columns * rows);
  for (int64_t row = rows - 1; row >= 0; --row)  // an image's first row is at its top
    for (int64_t column = 0; column < columns; ++column)
      grid.heights_mm.push_back(options.height_mm * HeightShare(lines[row] + 8 * column));
  return grid;
}

}  // namespace slicefarm::texture
