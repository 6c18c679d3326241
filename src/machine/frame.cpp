// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/frame.h"

#include <cmath>
#include <stdexcept>

#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/machine/rails.h"

namespace pkm_workspace
{
namespace
{
void validate(const Pose& pose)
{
  const auto& q = pose.orientation;
  TextStream problems;
  bool finite = true;
  for (std::size_t k = 0; k < 4; ++k)
    if (!std::isfinite(q[k]))
    {
      finite = false;
      problems << "orientation "
               << "xyzw"[k] << " = " << q[k] << " must be finite\n";
    }
  const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (finite && !(std::abs(norm - 1.0) <= NORM_TOLERANCE))
    problems << "orientation (x, y, z, w) = (" << q[0] << ", " << q[1] << ", " << q[2] << ", " << q[3]
             << ") must be a unit quaternion: its norm is " << norm << ", allowed are 1 - " << NORM_TOLERANCE
             << " to 1 + " << NORM_TOLERANCE << "\n";
  for (int k = 0; k < 3; ++k)
    if (!std::isfinite(pose.translation[k]))
      problems << "translation "
               << "xyz"[k] << " = " << pose.translation[k] << " m must be finite\n";
  std::string text = problems.str();
  if (text.empty())
    return;
  text.pop_back();
  throw std::invalid_argument(text);
}

/// Entry (i, i): (w^2 + x_i^2 - x_j^2 - x_k^2) / n = 1 - 2 (x_j^2 + x_k^2) / n, each exact where the other one is not.
Interval diagonal(const Interval& w, const Interval& xi, const Interval& xj, const Interval& xk, const Interval& n)
{
  return intersection(((w - xj) * (w + xj) + (xi - xk) * (xi + xk)) / n,
                      Interval(1.0) - Interval(2.0) * (sqr(xj) + sqr(xk)) / n);
}

/// Entry (i, j) where (i, j, k) is a cyclic order of the axes: 2 (x_i x_j - w x_k) / n; the entry (j, i) has -w for w.
Interval mixed(const Interval& w, const Interval& xi, const Interval& xj, const Interval& xk, const Interval& n)
{
  return intersection(Interval(2.0) * (xi * xj - w * xk) / n, Interval(-1.0, 1.0));
}
}  // namespace

IntervalMatrix rotationOf(const Pose& pose)
{
  validate(pose);
  const Interval x = pose.orientation[0];
  const Interval y = pose.orientation[1];
  const Interval z = pose.orientation[2];
  const Interval w = pose.orientation[3];
  const Interval n = (sqr(x) + sqr(y)) + (sqr(z) + sqr(w));
  return { IntervalVector{ diagonal(w, x, y, z, n), mixed(w, x, y, z, n), mixed(-w, z, x, y, n) },
           IntervalVector{ mixed(-w, x, y, z, n), diagonal(w, y, z, x, n), mixed(w, y, z, x, n) },
           IntervalVector{ mixed(w, z, x, y, n), mixed(-w, y, z, x, n), diagonal(w, z, x, y, n) } };
}

IntervalVector transformed(const Pose& pose, const IntervalVector& p)
{
  return rotationOf(pose) * p + enclose(pose.translation);
}

Machine machineInFrame(const Machine& machine, const Pose& pose)
{
  const IntervalMatrix rotation = rotationOf(pose);  // says all that is wrong with the pose
  return machineInFrame(machine, { rotation, enclose(pose.translation) });
}

Machine machineInFrame(const Machine& machine, const EnclosedMotion& motion)
{
  const auto& [rotation, translation] = motion;
  Machine::Legs legs = machine.legs();
  setDirections(legs, sharedDirections(legs));
  for (Leg& leg : legs)
    leg.kind = visitLeg([&](const auto& kind) -> LegKind { return moved(kind, rotation, translation); }, leg.kind);
  Machine turned(machine.name(), legs, mid(rotation * enclose(machine.zero()) + translation));
  if (turned.aspect() != machine.aspect())
    throw std::invalid_argument("machine '" + machine.name() +
                                "': rounding its zero configuration in this frame leads into another aspect");
  return turned;
}
}  // namespace pkm_workspace
