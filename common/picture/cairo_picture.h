#pragma once

#include <cairo.h>

#include <memory>
#include <string>

#include "absl/status/statusor.h"

namespace slicefarm {

/// Releases Cairo's objects for std::unique_ptr.
struct CairoRelease {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

using CairoSurface = std::unique_ptr<cairo_surface_t, CairoRelease>;
using CairoContext = std::unique_ptr<cairo_t, CairoRelease>;

/// Appends data from Cairo to the std::string `bytes`; the function is a cairo_write_func_t.
cairo_status_t AppendToString(void* bytes, const unsigned char* data, unsigned int size);

/// Returns an image surface as PNG. Errors: Internal, with Cairo's message.
absl::StatusOr<std::string> PngOf(cairo_surface_t* surface);

}  // namespace slicefarm
