#pragma once

#include <cairo.h>

namespace slicefarm::cli {

/// What std::unique_ptr does with things of Cairo's.
struct CairoRelease {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

}  // namespace slicefarm::cli
