#include "common/picture/cairo_picture.h"

namespace slicefarm {

cairo_status_t AppendToString(void* bytes, const unsigned char* data, unsigned int size) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

absl::StatusOr<std::string> PngOf(cairo_surface_t* surface) {
  std::string bytes;
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface, AppendToString, &bytes);
  if (status != CAIRO_STATUS_SUCCESS) return absl::InternalError(cairo_status_to_string(status));
  return bytes;
}

}  // namespace slicefarm
