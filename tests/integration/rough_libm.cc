// Library for LD_PRELOAD that replaces libm. Each of its functions is wrong from the fourth digit
// on. Code with the same G-code in spite of this does not depend on libm.

#include <dlfcn.h>

#define ROUGH(name)                                                                         \
  extern "C" double name(double x) noexcept {                                               \
    static const auto real = reinterpret_cast<double (*)(double)>(dlsym(RTLD_NEXT, #name)); \
    return real(x) * 1.0001;                                                                \
  }
#define ROUGH2(name)                                                           \
  extern "C" double name(double x, double y) noexcept {                        \
    static const auto real =                                                   \
        reinterpret_cast<double (*)(double, double)>(dlsym(RTLD_NEXT, #name)); \
    return real(x, y) * 1.0001;                                                \
  }

ROUGH(sin)
ROUGH(cos)
ROUGH(tan)
ROUGH(asin)
ROUGH(acos)
ROUGH(atan)
ROUGH(sinh)
ROUGH(cosh)
ROUGH(tanh)
ROUGH(asinh)
ROUGH(acosh)
ROUGH(atanh)
ROUGH(exp)
ROUGH(exp2)
ROUGH(expm1)
ROUGH(log)
ROUGH(log2)
ROUGH(log10)
ROUGH(log1p)
ROUGH(cbrt)
ROUGH2(atan2)
ROUGH2(hypot)
ROUGH2(pow)

extern "C" void sincos(double x, double* sine, double* cosine) noexcept {
  *sine = sin(x);
  *cosine = cos(x);
}
