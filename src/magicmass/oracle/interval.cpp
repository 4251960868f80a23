// Each end is computed exactly and then rounded down or up to a multiple of 2^-p.
#include "magicmass/oracle/interval.hpp"

#include <algorithm>

namespace magicmass::oracle {

Interval::Interval(int value) : low_(value), high_(value), precision_(0) {}

Interval::Interval(const cl_RA& x, long precision) : Interval(x, x, precision) {}

Interval::Interval(const cl_RA& low, const cl_RA& high, long precision)
    : low_(cln::floor1(low * cln::ash(cl_I(1), precision))),
      high_(cln::ceiling1(high * cln::ash(cl_I(1), precision))),
      precision_(precision) {}

Interval::Interval(const cl_I& low, const cl_I& high, long precision)
    : low_(low), high_(high), precision_(precision) {}

cl_RA Interval::low() const { return cl_RA(low_) / cln::ash(cl_I(1), precision_); }
cl_RA Interval::high() const { return cl_RA(high_) / cln::ash(cl_I(1), precision_); }

Sign Interval::sign() const {
  if (cln::plusp(low_)) return Sign::positive;
  if (cln::minusp(high_)) return Sign::negative;
  return cln::zerop(low_) && cln::zerop(high_) ? Sign::zero : Sign::open;
}

Interval Interval::at(long precision) const {
  const long shift = precision - precision_;
  return {cln::ash(low_, shift), cln::ash(high_, shift), precision};
}

Interval operator+(const Interval& x, const Interval& y) {
  const long p = std::max(x.precision_, y.precision_);
  const Interval u = x.at(p), v = y.at(p);
  return {u.low_ + v.low_, u.high_ + v.high_, p};
}

Interval operator-(const Interval& x, const Interval& y) {
  return x + Interval(-y.high_, -y.low_, y.precision_);
}

Interval operator*(const Interval& x, const Interval& y) {
  if (cln::minusp(x.low_) && !cln::minusp(y.low_)) return y * x;
  if (cln::minusp(x.high_)) return Interval(0) - (Interval(0) - x) * y;
  // Ends at 2^-(px + py), cut back to the larger of the two; ash rounds down.
  const long p = std::max(x.precision_, y.precision_);
  const long cut = std::min(x.precision_, y.precision_);
  cl_I low = (cln::minusp(y.low_) ? x.high_ : x.low_) * y.low_;
  cl_I high = (cln::minusp(y.high_) ? x.low_ : x.high_) * y.high_;
  if (cln::minusp(x.low_)) low = cln::min(low, x.low_ * y.high_);  // so is y.low_
  if (cln::minusp(x.low_)) high = cln::max(high, x.low_ * y.low_);
  return {cln::ash(low, -cut), -cln::ash(-high, -cut), p};
}

Interval operator/(const Interval& x, const Interval& y) {
  if (y.sign() == Sign::zero || y.sign() == Sign::open)
    throw Undecided("division by an interval that reaches zero");
  if (y.sign() == Sign::negative) return (Interval(0) - x) / (Interval(0) - y);
  // u / v = (u 2^p / v) / 2^p at precision p; for v > 0 the extremes are u's ends over one of v's.
  const long p = std::max(x.precision_, y.precision_);
  const Interval u = x.at(p), v = y.at(p);
  const cl_I& below_low = cln::minusp(u.low_) ? v.low_ : v.high_;
  const cl_I& below_high = cln::minusp(u.high_) ? v.high_ : v.low_;
  return {cln::floor1(cln::ash(u.low_, p), below_low),
          cln::ceiling1(cln::ash(u.high_, p), below_high), p};
}

}  // namespace magicmass::oracle
