// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/interval/box.h"
#include "pkm_workspace/interval/interval_vector.h"

namespace pkm_workspace
{
namespace mean_value
{
/// A function of the tool point over one box: enclosures of its value at the box's center, and of its values and of its
/// derivatives with respect to x, y, z on the whole box (automatic differentiation, forward mode).
struct Form
{
  Interval center;
  Interval range;
  IntervalVector gradient;
};

using FormVector = std::array<Form, 3>;

inline Form operator+(const Form& f, const Form& g)
{
  return { f.center + g.center, f.range + g.range, f.gradient + g.gradient };
}

inline Form operator-(const Form& f, const Form& g)
{
  return { f.center - g.center, f.range - g.range, f.gradient - g.gradient };
}

inline Form operator*(const Interval& s, const Form& f)
{
  return { s * f.center, s * f.range, s * f.gradient };
}

inline Form operator*(const Form& f, const Form& g)
{
  return { f.center * g.center, f.range * g.range, f.range * g.gradient + g.range * f.gradient };
}

inline Form operator-(const Interval& s, const Form& f)
{
  return { s - f.center, s - f.range, Interval(-1.0) * f.gradient };
}

inline Form sqr(const Form& f)
{
  return { sqr(f.center), sqr(f.range), (Interval(2.0) * f.range) * f.gradient };
}

/// @pre f is positive on the box
inline Form sqrt(const Form& f)
{
  const Interval root = sqrt(f.range);
  return { sqrt(f.center), root, (Interval(0.5) / root) * f.gradient };
}

/// The box that forms are about.
class Chart
{
public:
  explicit Chart(const Box& box) : center(enclose(box.center())), range(enclose(box)), offset_(range - center) {}

  const IntervalVector center;
  const IntervalVector range;

  /// Narrows f by its mean-value form: f(p) - f(c) = f'(.) (p - c) somewhere on the line from c to p.
  Form tightened(Form f) const
  {
    f.range = intersection(f.range, f.center + dot(f.gradient, offset_));
    return f;
  }

private:
  IntervalVector offset_;
};
}  // namespace mean_value
}  // namespace pkm_workspace
