// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <ostream>
#include <sstream>
#include <string>

#include "pkm_workspace/interval/affine_vector.h"
#include "support/exact_vector.h"
#include "support/random.h"

namespace pkm_workspace
{
inline std::ostream& operator<<(std::ostream& stream, const AffineForm<double>& f)
{
  return stream << std::hexfloat << f.center << " + (" << f.gradient[0] << ", " << f.gradient[1] << ", "
                << f.gradient[2] << ") . delta +- " << f.radius;
}

inline std::ostream& operator<<(std::ostream& stream, const Enclosed<double>& x)
{
  return stream << std::hexfloat << x.value << " +- " << x.radius;
}

namespace test
{
using Form = AffineForm<double>;
using Vector = AffineVector<double>;

inline std::string toText(const Vector& v)
{
  std::ostringstream text;
  for (std::size_t k = 0; k < 3; ++k)
    text << Form{ v.center[k], v.linear[k], v.radius } << " along " << v.along << " * " << v.axis[k] << "\n";
  return text.str();
}

/// Draws affine forms and members of them: functions are looked at in one point delta of the cube.
class Forms
{
public:
  explicit Forms(std::uint64_t seed) : random_(seed), scale_(random_.integer(-30, 30)) { move(); }

  Random& random() { return random_; }
  /// Chooses another delta: mostly a corner of the cube, where forms are worst.
  void move()
  {
    for (auto& d : delta_)
      d = random_.once(3) ? random_.uniform(-1.0, 1.0) : random_.sign();
  }
  const std::array<double, 3>& delta() const { return delta_; }

  /// 0, or a number of the magnitude of this case times 2^-shrink, often exact in few digits.
  double number(int shrink = 0)
  {
    if (random_.once(6))
      return 0.0;
    const double digits = random_.once(4) ? random_.integer(-8, 8) : random_.uniform(-8.0, 8.0);
    return std::ldexp(digits, scale_ - shrink);
  }
  double error() { return std::abs(number(random_.integer(0, 60))); }

  /// Half of the partners nearly cancel @p other.
  Form form(const Form* other = nullptr)
  {
    if (other != nullptr && random_.once(2))
    {
      Form opposite = -*other;
      opposite.center = std::nextafter(opposite.center, random_.sign() * 1e300);
      return opposite;
    }
    const int shrink = random_.integer(0, 20);
    return { number(), { number(shrink), number(shrink), number(shrink) }, error() };
  }
  /// Error terms of every kind are often missing.
  Vector vector()
  {
    Vector v;
    const int shrink = random_.integer(0, 20);
    for (std::size_t k = 0; k < 3; ++k)
    {
      v.center[k] = number();
      v.linear[k] = { number(shrink), number(shrink), number(shrink) };
      v.axis[k] = random_.once(4) ? 0.0 : random_.uniform(-1.0, 1.0);
    }
    v.radius = random_.once(2) ? error() : 0.0;
    v.along = random_.once(2) ? error() : 0.0;
    if (random_.once(8))
      v.center = { 0.0, 0.0, 0.0 };
    if (random_.once(3))
      v.linear = {};
    return v;
  }
  /// Only an error, along an axis that is perpendicular to that of @p other but for rounding.
  Vector errorAcross(const Vector& other)
  {
    Vector v = {};
    v.axis = { random_.uniform(-1.0, 1.0), random_.uniform(-1.0, 1.0), 0.0 };
    v.axis[2] = -(v.axis[0] * other.axis[0] + v.axis[1] * other.axis[1]) / other.axis[2];
    v.along = error();
    return v;
  }

  /// A number within +-bound, mostly an end.
  Exact within(double bound) { return Exact(random_.once(3) ? random_.uniform(-1.0, 1.0) : random_.sign()) * bound; }

  /// center + gradient . delta.
  Exact linear(double center, const std::array<double, 3>& gradient) const
  {
    return Exact(center) + Exact(gradient[0]) * delta_[0] + Exact(gradient[1]) * delta_[1] +
           Exact(gradient[2]) * delta_[2];
  }
  Exact member(const Form& f) { return linear(f.center, f.gradient) + within(f.radius); }
  ExactVector member(const Vector& v)
  {
    const Exact along = within(v.along);
    ExactVector result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = linear(v.center[k], v.linear[k]) + along * v.axis[k] + within(v.radius);
    return result;
  }

  /// Whether a function that takes this value at delta may be a member of f.
  bool holds(const Form& f, const Exact& value) const
  {
    return (value - linear(f.center, f.gradient)).mayLieIn(-f.radius, f.radius);
  }

private:
  Random random_;
  int scale_;
  std::array<double, 3> delta_;
};
}  // namespace test
}  // namespace pkm_workspace
