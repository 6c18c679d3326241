// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pkm_workspace/machine/sliding_strut_forms.h"

namespace pkm_workspace
{
/// What forms need of a sliding strut with tolerances, in doubles. A strut of the set has, for some parameters p,
/// c = center + sum of p_k center_slopes_k, e = axis + sum of p_k axis_slopes_k and
/// L^2 = squared_length + p_6 squared_length_slope, each within its error.
struct StrutSpread
{
  StrutOfForms<double> nominal;
  std::array<PlainVector<double>, 4> center_slopes;  ///< of p_0 to p_3 [m]
  double center_error;                               ///< of each coordinate [m]
  std::array<PlainVector<double>, 2> axis_slopes;    ///< of p_4 and p_5
  double axis_error;
  Enclosed<double> squared_length;  ///< [m^2]
  double squared_length_slope;      ///< [m^2]
  ParameterSet set;
};

StrutSpread spreadOf(const SlidingStrut& strut);

/// A strut with tolerances in the constants of one arithmetic, whose forms depend on its parameters.
template <class Real>
struct ToleratedStrut
{
  EnclosedMatrix<Real> identity;
  EnclosedVector<Real> center;                  ///< of the set [m]
  std::array<Gradient<Real>, 3> center_slopes;  ///< minus those of c [component][symbol] [m]
  AffineVector<Real> axis;                      ///< e
  AffineForm<Real> squared_length;              ///< L^2 [m^2]
  Enclosed<Real> sign;                          ///< s, the working mode
  PlainStrut<Real> near;                        ///< the strut in the middle
};

/// @param leg whose parameters these are: they are STRUT_PARAMETERS from 3 + leg STRUT_PARAMETERS on
template <class Real>
ToleratedStrut<Real> tolerated(const StrutSpread& spread, std::size_t leg)
{
  const std::size_t first = 3 + leg * STRUT_PARAMETERS;
  const StrutOfForms<Real> nominal = ofForms<Real>(spread.nominal);
  ToleratedStrut<Real> strut;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      strut.identity.value[i][k] = Real(i == k ? 1.0 : 0.0);
  strut.identity.magnitude = Real(1);
  strut.center = nominal.center;
  strut.center.radius = Real(spread.nominal.center.radius + spread.center_error);
  strut.axis.center = nominal.axis.value;
  strut.axis.radius = Real(spread.nominal.axis.radius + spread.axis_error);
  for (std::size_t k = 0; k < 3; ++k)
  {
    strut.center_slopes[k].fill(Real(0));
    strut.axis.linear[k].fill(Real(0));
    for (std::size_t j = 0; j < spread.center_slopes.size(); ++j)
      strut.center_slopes[k][first + j] = Real(-spread.center_slopes[j][k]);
    for (std::size_t j = 0; j < spread.axis_slopes.size(); ++j)
      strut.axis.linear[k][first + 4 + j] = Real(spread.axis_slopes[j][k]);
  }
  strut.squared_length.center = Real(spread.squared_length.value);
  strut.squared_length.gradient[first + 6] = Real(spread.squared_length_slope);
  strut.squared_length.radius = Real(spread.squared_length.radius);
  strut.sign = nominal.sign;
  strut.near = plain(nominal);
  return strut;
}

template <class Real>
const PlainStrut<Real>& plain(const ToleratedStrut<Real>& strut)
{
  return strut.near;
}

namespace affine
{
/// p - c.
template <class Real, class Points>
inline void offset(const ToleratedStrut<Real>& strut, const Points& p, AffineVector<Real>& image)
{
  mapOffset(strut.identity, strut.center, p, image);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t j = 3; j < image.linear[k].size(); ++j)
      image.linear[k][j] = strut.center_slopes[k][j];
}
}  // namespace affine

/// The whole leg (sliding_strut_forms.h), for all struts of the set.
template <class Real, class Points, class Root, class State>
inline void evaluate(const ToleratedStrut<Real>& strut, const Points& p, const Root& root, State& state)
{
  affine::offset(strut, p, state.row);
  addAlong(state.row, -dot(strut.axis, state.row), strut.axis);
  affine::spreadError(state.row);
  state.squared_drive = strut.squared_length - squaredNorm(state.row);
  state.drive = strut.sign * root(state.squared_drive);
  addAlong(state.row, state.drive, strut.axis);
}

template <class Real, class State, class Drive, class Row>
inline AffineForm<Real> weighed(const ToleratedStrut<Real>& strut, const State& state, const Drive& drive,
                                const Row& row)
{
  return drive * state.squared_drive + row * strut.squared_length;
}

template <class Real, class Points, class State>
inline AffineForm<Real> jointOf(const ToleratedStrut<Real>& strut, const Points& p, const State& state)
{
  AffineVector<Real> from_center;
  affine::offset(strut, p, from_center);
  return dot(strut.axis, from_center) - state.drive;
}

template <class Real, class Points, class State>
inline AffineForm<Real> limitForm(const ToleratedStrut<Real>& strut, const Points& p, const State& state,
                                  const JointLimit<Real>& limit)
{
  return fromLimit(jointOf(strut, p, state), limit);
}

template <class Real, class Points, class State>
inline AffineForm<Real> turningOf(const ToleratedStrut<Real>& strut, const Points& /*p*/, const State& /*state*/,
                                  AffineVector<Real> tangent, const AffineForm<Real>& speed)
{
  addAlong(tangent, -speed, strut.axis);
  return dot(tangent, tangent);
}
}  // namespace pkm_workspace
