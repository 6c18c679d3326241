// SPDX-License-Identifier: BSD-3-Clause
#include "placement.h"

#include <algorithm>
#include <cmath>

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
bool isSingle(const IntervalVector& v)
{
  return v[0].isSingle() && v[1].isSingle() && v[2].isSingle();
}

/// Whether a b = c d is proved: the rounded products and their rounding errors agree, and none of them is lost to
/// underflow.
bool sameProduct(double a, double b, double c, double d)
{
  if (a == 0.0 || b == 0.0)
    return c == 0.0 || d == 0.0;
  const double left = a * b;
  const double right = c * d;
  return left == right && std::abs(left) > 1e-250 && std::fma(a, b, -left) == std::fma(c, d, -right);
}

/// The vector with its largest component of a size between 1/2 and 1, by a power of two; exact but for underflow.
IntervalVector scaledDown(const Eigen::Vector3d& v)
{
  int exponent = 0;
  std::frexp(v.cwiseAbs().maxCoeff(), &exponent);
  // Two factors: one alone may be out of range.
  const Interval half_scale = std::ldexp(1.0, -(exponent / 2));
  const Interval rest = std::ldexp(1.0, -(exponent - exponent / 2));
  return half_scale * (rest * enclose(v));
}

IntervalVector withinUnit(const IntervalVector& v)
{
  const Interval unit(-1.0, 1.0);
  return { intersection(v[0], unit), intersection(v[1], unit), intersection(v[2], unit) };
}
}  // namespace

IntervalMatrix rotation(const Angles& rpy)
{
  const Interval zero = 0.0;
  const Interval one = 1.0;
  const Interval sr = sin(rpy[0]);
  const Interval cr = cos(rpy[0]);
  const Interval sp = sin(rpy[1]);
  const Interval cp = cos(rpy[1]);
  const Interval sy = sin(rpy[2]);
  const Interval cy = cos(rpy[2]);
  const IntervalMatrix roll{ IntervalVector{ one, zero, zero }, IntervalVector{ zero, cr, -sr },
                             IntervalVector{ zero, sr, cr } };
  const IntervalMatrix pitch{ IntervalVector{ cp, zero, sp }, IntervalVector{ zero, one, zero },
                              IntervalVector{ -sp, zero, cp } };
  const IntervalMatrix yaw{ IntervalVector{ cy, -sy, zero }, IntervalVector{ sy, cy, zero },
                            IntervalVector{ zero, zero, one } };
  return yaw * (pitch * roll);
}

Interval lengthOf(const IntervalVector& v)
{
  const auto not_zero = [](const Interval& entry) { return entry != Interval(0.0); };
  return std::count_if(v.begin(), v.end(), not_zero) > 1 ? norm(v) : abs(v[0] + v[1] + v[2]);
}

IntervalVector unitVector(const Eigen::Vector3d& v)
{
  const IntervalVector scaled = scaledDown(v);
  const Interval length = lengthOf(scaled);
  return withinUnit({ scaled[0] / length, scaled[1] / length, scaled[2] / length });
}

Frame Frame::then(const Origin& origin) const
{
  Frame frame = *this;
  frame.position = toOuter(enclose(origin.xyz));
  if (origin.rpy != Angles{})
  {
    frame.turns.push_back(origin.rpy);
    frame.rotation = rotation * urdf_io::rotation(origin.rpy);
  }
  return frame;
}

Direction directionIn(const Frame& frame, const Eigen::Vector3d& axis)
{
  Direction direction{ frame.turns, axis, {} };
  while (!direction.turns.empty())
  {
    const IntervalVector turned = rotation(direction.turns.back()) * enclose(direction.axis);
    if (!isSingle(turned))
      break;
    direction.axis = mid(turned);
    direction.turns.pop_back();
  }
  direction.enclosure = unitVector(direction.axis);
  for (auto turn = direction.turns.rbegin(); turn != direction.turns.rend(); ++turn)
    direction.enclosure = withinUnit(rotation(*turn) * direction.enclosure);
  return direction;
}

int exactlyParallel(const Direction& a, const Direction& b)
{
  const auto& u = a.axis;
  const auto& v = b.axis;
  const bool parallel = a.turns == b.turns && sameProduct(u.x(), v.y(), u.y(), v.x()) &&
                        sameProduct(u.y(), v.z(), u.z(), v.y()) && sameProduct(u.z(), v.x(), u.x(), v.z());
  if (!parallel)
    return 0;
  Eigen::Index largest = 0;
  u.cwiseAbs().maxCoeff(&largest);
  return (u[largest] > 0.0) == (v[largest] > 0.0) ? 1 : -1;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
