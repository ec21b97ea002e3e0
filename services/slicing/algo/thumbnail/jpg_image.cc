#include "services/slicing/algo/thumbnail/jpg_image.h"

#include <jpeglib.h>

#include <csetjmp>
#include <cstdio>
#include <cstdlib>

#include "common/base/error.h"
#include "common/model/layers/layer.h"

namespace slicefarm::slicing {
namespace {

constexpr int kJpgQuality = 85;  // quality of PrusaSlicer

/// Error state. libjpeg reports an error by calling a function that must not return.
struct JpgErrors {
  jpeg_error_mgr manager;
  std::jmp_buf back;
  char text[JMSG_LENGTH_MAX] = {};
};

[[noreturn]] void Leave(j_common_ptr jpeg) {
  auto* errors = reinterpret_cast<JpgErrors*>(jpeg->err);
  jpeg->err->format_message(jpeg, errors->text);
  std::longjmp(errors->back, 1);
}

/// Returns three bytes per pixel, over a black background.
std::vector<uint8_t> OnBlack(const std::vector<Rgba>& pixels) {
  std::vector<uint8_t> bytes;
  bytes.reserve(pixels.size() * 3);
  for (const Rgba& pixel : pixels)
    for (size_t i = 0; i < 3; ++i)
      bytes.push_back(static_cast<uint8_t>((pixel[i] * pixel[3] + 127) / 255));
  return bytes;
}

struct JpgBuffer {
  unsigned char* bytes = nullptr;
  unsigned long size = 0;  // NOLINT: libjpeg's type
};

/// Compresses the pixels. The function has no local objects with a destructor, because an error
/// leaves it by longjmp.
bool Compress(uint8_t* pixels, int32_t width, int32_t height, JpgErrors* errors,
              JpgBuffer* buffer) {
  jpeg_compress_struct jpeg = {};
  jpeg.err = jpeg_std_error(&errors->manager);
  errors->manager.error_exit = Leave;
  if (setjmp(errors->back) != 0) {
    jpeg_destroy_compress(&jpeg);
    return false;
  }
  jpeg_create_compress(&jpeg);
  jpeg_mem_dest(&jpeg, &buffer->bytes, &buffer->size);
  jpeg.image_width = static_cast<JDIMENSION>(width);
  jpeg.image_height = static_cast<JDIMENSION>(height);
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg.dct_method = JDCT_ISLOW;  // gives equal results on all processors
  jpeg_set_quality(&jpeg, kJpgQuality, TRUE);
  jpeg_start_compress(&jpeg, TRUE);
  while (jpeg.next_scanline < jpeg.image_height) {
    JSAMPROW row = pixels + size_t{jpeg.next_scanline} * jpeg.image_width * 3;
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  return true;
}

}  // namespace

absl::StatusOr<std::string> EncodeJpg(const std::vector<Rgba>& pixels, int32_t width,
                                      int32_t height) {
  std::vector<uint8_t> bytes = OnBlack(pixels);
  JpgErrors errors;
  JpgBuffer buffer;
  const bool good = Compress(bytes.data(), width, height, &errors, &buffer);
  std::string file;
  if (good) file.assign(reinterpret_cast<const char*>(buffer.bytes), buffer.size);
  std::free(buffer.bytes);
  if (good) return file;
  return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                   std::string("JPEG: ") + errors.text);
}

}  // namespace slicefarm::slicing
