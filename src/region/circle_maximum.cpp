// SPDX-License-Identifier: BSD-3-Clause
#include "circle_maximum.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <stdexcept>

#include "pkm_workspace/interval/curve.h"

namespace pkm_workspace
{
namespace
{
using Form = AffineForm<double>;
using Number = Enclosed<double>;

/// Arcs to begin with: a power of two, so that their ends are doubles.
constexpr int BEGINNING = 8;
constexpr int MOST_ARCS = 4000;
/// The smallest arc that is bisected, in turns.
constexpr double NARROWEST = 0x1p-32;

/// A part of a circle, in turns.
struct Arc
{
  double first, last;
  double bound;  ///< of the values from above

  bool operator<(const Arc& other) const { return bound < other.bound; }
};

/// cos(k t) and sin(k t) over an arc about the angle m, with half its angle b: cos(k b d) lies in [cos k b, 1], and
/// sin(k b d) within (k b)^3 / (9 sqrt 3) of d sin k b for d in [-1, 1] (the error of interpolation in -1, 0, 1).
struct Harmonic
{
  Form cosine, sine;

  Harmonic(int k, double middle, double half)
  {
    const Interval turn = Interval(2.0 * k) * pi();
    const SineCosine center(turn * Interval(middle));
    const SineCosine end(turn * Interval(half));
    const double b = (turn * Interval(half)).upper();
    const Interval level(std::min(end.cosine.lower(), 1.0), 1.0);
    Form level_form, slope_form;
    level_form.center = level.mid();
    level_form.radius = level.radius();
    slope_form.gradient[0] = end.sine.value;
    slope_form.radius = affine::widened(end.sine.radius + b * b * b / 15.0, b * b * b, 8);  // 9 sqrt 3 > 15
    cosine = center.cosine * level_form + (-center.sine) * slope_form;
    sine = center.sine * level_form + center.cosine * slope_form;
  }
};

Form over(const Trigonometric& f, const Harmonic& once, const Harmonic& twice)
{
  return Number(f.cosine) * once.cosine + Number(f.sine) * once.sine + Number(f.cosine2) * twice.cosine +
         Number(f.sine2) * twice.sine + Number(f.constant);
}

class CircleMaximum
{
public:
  CircleMaximum(const Trigonometric& linear, const Trigonometric& radicand) : linear_(linear), radicand_(radicand) {}

  Interval run(double gap)
  {
    for (int k = 0; k < BEGINNING; ++k)
      look(k / double(BEGINNING), (k + 1) / double(BEGINNING));
    for (int arcs = 0; arcs < MOST_ARCS && open_.top().bound > least_ + gap; ++arcs)
    {
      const Arc arc = open_.top();
      if (arc.last - arc.first < NARROWEST)
        break;
      open_.pop();
      const double middle = 0.5 * (arc.first + arc.last);
      look(arc.first, middle);
      look(middle, arc.last);
    }
    return { least_, std::max(least_, open_.top().bound) };
  }

private:
  void look(double first, double last)
  {
    const double middle = 0.5 * (first + last);
    least_ = std::max(least_, value(middle, 0.0).lower());
    const double bound = value(middle, 0.5 * (last - first)).upper();
    open_.push({ first, last, std::isnan(bound) ? INF : bound });
  }

  Form value(double middle, double half) const
  {
    const Harmonic once(1, middle, half);
    const Harmonic twice(2, middle, half);
    const Form radicand = over(radicand_, once, twice);
    if (radicand.upper() < 0.0)
      throw std::domain_error("joint ranges: a strut does not reach part of the region");
    return over(linear_, once, twice) + (-sqrtAbove(radicand, 0.0));
  }

  const Trigonometric& linear_;
  const Trigonometric& radicand_;
  double least_ = -INF;
  std::priority_queue<Arc> open_;
};
}  // namespace

Trigonometric dotOffset(const IntervalVector& a, const IntervalVector& c, const Circle& p)
{
  return { dot(a, p.center - c), p.radius * a[0], p.radius * a[1], 0.0, 0.0 };
}

void mapOffset(const IntervalMatrix& m, const IntervalVector& c, const Circle& p, TrigonometricVector& image)
{
  image = { dotOffset(m[0], c, p), dotOffset(m[1], c, p), dotOffset(m[2], c, p) };
}

Trigonometric squaredNorm(const TrigonometricVector& v)
{
  const Interval half(0.5);
  const Interval two(2.0);
  Trigonometric sum{ 0.0, 0.0, 0.0, 0.0, 0.0 };
  for (const Trigonometric& f : v)
  {
    sum.constant += sqr(f.constant) + half * (sqr(f.cosine) + sqr(f.sine));
    sum.cosine += two * f.constant * f.cosine;
    sum.sine += two * f.constant * f.sine;
    sum.cosine2 += half * (sqr(f.cosine) - sqr(f.sine));
    sum.sine2 += f.cosine * f.sine;
  }
  return sum;
}

Trigonometric operator-(const Interval& s, const Trigonometric& f)
{
  return { s - f.constant, -f.cosine, -f.sine, -f.cosine2, -f.sine2 };
}

Interval largestOnCircle(const Trigonometric& linear, const Trigonometric& radicand, double gap)
{
  return CircleMaximum(linear, radicand).run(gap);
}
}  // namespace pkm_workspace
