#include "services/slicing/algo/thumbnail/qoi_image.h"

#include <cstdlib>
#include <memory>

#define QOI_IMPLEMENTATION
#define QOI_NO_STDIO
#include <qoi.h>

namespace slicefarm::slicing {

std::string EncodeQoi(std::span<const Rgba> pixels, int32_t width, int32_t height) {
  const qoi_desc size = {static_cast<uint32_t>(width), static_cast<uint32_t>(height),
                         /*channels=*/4, QOI_SRGB};
  int bytes = 0;
  const std::unique_ptr<void, decltype(&std::free)> encoded(
      qoi_encode(pixels.data(), &size, &bytes), &std::free);
  if (encoded == nullptr) std::abort();  // no memory, or no pixels
  return {static_cast<const char*>(encoded.get()), static_cast<size_t>(bytes)};
}

}  // namespace slicefarm::slicing
