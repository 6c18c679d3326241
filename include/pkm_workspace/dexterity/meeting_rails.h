// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/dexterity/strut_sphere.h"

namespace pkm_workspace
{
/// Three rails whose lines c + t e meet in one point o, with struts of one length L: all struts are one where
/// |p - o| = L, and det A has a double zero there (docs/theory.md). In numbers of a type Real.
template <class Real>
struct MeetingRails
{
  bool exist = false;
  EnclosedVector<Real> center;         ///< o [m]
  EnclosedMatrix<Real> identity;       ///< its image is p - o
  EnclosedMatrix<Real> along;          ///< rows w = s e, towards the struts; its image is w . (p - o)
  EnclosedMatrix<Real> across;         ///< rows w_2 x w_3, w_3 x w_1, w_1 x w_2
  std::array<Enclosed<Real>, 3> sign;  ///< s
  Enclosed<Real> volume;               ///< det(w_1, w_2, w_3)
  Enclosed<Real> squared_length{};     ///< L^2 [m^2]

  MeetingRails() = default;

  /// Of a machine; only where the point o is known exactly, as for its strut spheres.
  explicit MeetingRails(const Machine& machine)
  {
    const std::vector<StrutSphere> spheres = strutSpheres(machine);
    exist =
        spheres.size() == 3 && spheres[0].center() == spheres[1].center() && spheres[0].center() == spheres[2].center();
    if (!exist)
      return;
    IntervalMatrix w;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const SlidingStrut& strut = slidingStrut(machine.legs()[i]);
      const Interval mode(strut.working_mode);
      w[i] = mode * strut.axis;
      sign[i] = Enclosed<Real>(mode);
    }
    const auto unit = [](int axis) { return enclose(Eigen::Vector3d::Unit(axis)); };
    center = EnclosedVector<Real>(enclose(spheres[0].center()));
    identity = EnclosedMatrix<Real>(IntervalMatrix{ unit(0), unit(1), unit(2) });
    along = EnclosedMatrix<Real>(w);
    across = EnclosedMatrix<Real>(IntervalMatrix{ cross(w[1], w[2]), cross(w[2], w[0]), cross(w[0], w[1]) });
    volume = Enclosed<Real>(dot(w[0], cross(w[1], w[2])));
    squared_length = Enclosed<Real>(sqr(Interval(spheres[0].radius())));
  }

  /// The same in another type of number.
  template <class Other>
  explicit MeetingRails(const MeetingRails<Other>& other)
    : exist(other.exist)
    , center(other.center)
    , identity(other.identity)
    , along(other.along)
    , across(other.across)
    , sign{ Enclosed<Real>(other.sign[0]), Enclosed<Real>(other.sign[1]), Enclosed<Real>(other.sign[2]) }
    , volume(other.volume)
    , squared_length(other.squared_length)
  {}
};
}  // namespace pkm_workspace
