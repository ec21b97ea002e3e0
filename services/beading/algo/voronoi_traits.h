#pragma once

#include <boost/polygon/voronoi_builder.hpp>
#include <cmath>
#include <cstdint>

namespace slicefarm::beading {

/// A double that Boost.Polygon's Voronoi builder takes for its own floating-point type.
///
/// The builder works out each circle in doubles with a bound on the error, and again in exact
/// integers if the bound exceeds 64 ulps. Along two almost parallel sides, which is what gaps have,
/// it nearly always does, and the integers take nine tenths of the time. With this type the bound
/// is not kept and the doubles stand. They are good enough for most regions (measured: 98.5 % of
/// the gaps of a boat); the caller has to check the diagram, and to build it anew with the
/// builder's own type where it is wrong.
class Untracked {
 public:
  Untracked() = default;
  // Implicit, because the builder mixes its type with numbers.
  template <typename Number>
  Untracked(Number value)
      : value_(static_cast<double>(value)) {}  // NOLINT(google-explicit-constructor)

  // Arithmetic is that of doubles.
  operator double() const { return value_; }  // NOLINT(google-explicit-constructor)

  Untracked operator-() const { return -value_; }
  Untracked& operator+=(Untracked b) { return value_ += b.value_, *this; }
  Untracked& operator-=(Untracked b) { return value_ -= b.value_, *this; }
  Untracked& operator*=(Untracked b) { return value_ *= b.value_, *this; }
  Untracked& operator/=(Untracked b) { return value_ /= b.value_, *this; }
  friend Untracked get_sqrt(Untracked a) { return std::sqrt(a.value_); }

 private:
  double value_ = 0;
};

/// Events nearer than this, in units of the input, are taken for simultaneous, as the builder does
/// within 64 ulps.
struct UntrackedComparison {
  static constexpr double kTolerance = 1e-4;

  enum Result { LESS = -1, EQUAL = 0, MORE = 1 };  // names that the builder uses
  Result operator()(Untracked a, Untracked b, unsigned /*max_ulps*/) const {
    const double difference = double{a} - double{b};
    return difference < -kTolerance ? LESS : difference > kTolerance ? MORE : EQUAL;
  }
};

struct ToUntracked {
  template <typename Number>
  Untracked operator()(const Number& value) const {
    return static_cast<double>(value);
  }
  Untracked operator()(const boost::polygon::detail::extended_int<64>& value) const {
    return value.d();
  }
  Untracked operator()(const boost::polygon::detail::extended_exponent_fpt<double>& value) const {
    return value.d();
  }
};

/// Traits of a builder for 32-bit coordinates that computes with Untracked.
struct UntrackedTraits : boost::polygon::detail::voronoi_ctype_traits<int32_t> {
  using fpt_type = Untracked;
  using ulp_cmp_type = UntrackedComparison;
  using to_fpt_converter_type = ToUntracked;
};

}  // namespace slicefarm::beading

/// The builder's number with an error bound; here without.
template <>
class boost::polygon::detail::robust_fpt<slicefarm::beading::Untracked> {
  using Number = slicefarm::beading::Untracked;

 public:
  using floating_point_type = Number;
  using relative_error_type = Number;

  robust_fpt() = default;
  explicit robust_fpt(Number value) : value_(value) {}
  robust_fpt(Number value, Number /*error*/) : value_(value) {}

  Number fpv() const { return value_; }
  Number re() const { return 0; }
  Number ulp() const { return 0; }
  bool has_pos_value() const { return value_ > 0; }
  bool has_neg_value() const { return value_ < 0; }
  bool has_zero_value() const { return value_ == 0; }

  robust_fpt operator-() const { return robust_fpt(-value_); }
  robust_fpt& operator+=(robust_fpt b) { return value_ += b.value_, *this; }
  robust_fpt& operator-=(robust_fpt b) { return value_ -= b.value_, *this; }
  robust_fpt& operator*=(robust_fpt b) { return value_ *= b.value_, *this; }
  robust_fpt& operator/=(robust_fpt b) { return value_ /= b.value_, *this; }
  robust_fpt operator+(robust_fpt b) const { return robust_fpt(value_ + b.value_); }
  robust_fpt operator-(robust_fpt b) const { return robust_fpt(value_ - b.value_); }
  robust_fpt operator*(robust_fpt b) const { return robust_fpt(value_ * b.value_); }
  robust_fpt operator/(robust_fpt b) const { return robust_fpt(value_ / b.value_); }
  bool operator<(int b) const { return value_ < b; }
  bool operator>(int b) const { return value_ > b; }
  robust_fpt sqrt() const { return robust_fpt(get_sqrt(value_)); }

 private:
  Number value_;
};
