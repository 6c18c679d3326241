// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/machine/machine.h"
#include "upward.h"

namespace pkm_workspace
{
namespace bench
{
namespace upward
{
/// Natural interval extensions over a set of points, for psi in [0.5, 2].
struct Forms
{
  bool is_outside = false;      ///< a leg is too far across its rail at all points; the rest is void then
  std::array<Vector, 3> strut;  ///< d [m]
  Vector eta2;                  ///< eta^2 [m^2]; where it reaches below 0, what follows is about the other points
  Symmetric s_min, s_max;       ///< A A^T - psi_min^2 B^2, psi_max^2 B^2 - A A^T [m^2]
};

/// A machine with rails along axes of the root frame, of which the operations with 0 and 1 are left out.
class NaturalForms
{
public:
  /// @throws std::invalid_argument for another machine
  explicit NaturalForms(const Machine& machine);

  Forms at(const Vector& p) const;
  /// Whether det A is proved to have the machine's own sign, or the other one.
  bool isOwnAspect(const Forms& forms) const { return (aspect_ * determinantOfA(forms)).lower() > 0.0; }
  bool isOtherAspect(const Forms& forms) const { return (aspect_ * determinantOfA(forms)).upper() < 0.0; }

private:
  struct Leg
  {
    std::size_t along = 0;  ///< axis of the rail
    Vector center;
    Real squared_length;
    double mode = 1.0;
  };

  Real product(const std::array<Vector, 3>& d, std::size_t i) const;
  static Real determinantOfA(const Forms& forms);

  std::array<Leg, 3> legs_;
  std::array<std::array<bool, 3>, 3> is_same_;  ///< the legs other than i have the same d_k
  double aspect_;
};
}  // namespace upward
}  // namespace bench
}  // namespace pkm_workspace
