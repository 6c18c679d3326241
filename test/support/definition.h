// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <optional>
#include <set>

#include "pkm_workspace/dexterity/criterion_bounds.h"
#include "pkm_workspace/machine/machine.h"
#include "support/driven_tool.h"

namespace pkm_workspace
{
namespace test
{
/// A machine at a point in doubles, by its geometry: struts from A to B, and their parts along the rails.
struct Standing
{
  DrivenToolOf<double>::Matrix strut;
  DrivenToolOf<double>::Vector eta;
  Eigen::Vector3d rho;
  Eigen::Matrix3d rows;  ///< the struts again
};

/// Nothing where a strut does not reach.
inline std::optional<Standing> standing(const Machine& machine, const Eigen::Vector3d& p)
{
  Standing there;
  for (int i = 0; i < 3; ++i)
  {
    const SlidingStrut& leg = slidingStrut(machine.leg(i));
    const Eigen::Vector3d axis = mid(leg.axis);
    const Eigen::Vector3d offset = p + mid(leg.platform) - mid(leg.origin);
    const double along = axis.dot(offset);
    const double square = std::pow(leg.length.mid(), 2) - (offset - along * axis).squaredNorm();
    if (square <= 0.0)
      return std::nullopt;
    const auto k = static_cast<std::size_t>(i);
    there.eta[k] = leg.working_mode * std::sqrt(square);
    there.rho[i] = along - there.eta[k];
    there.rows.row(i) = offset - there.rho[i] * axis;
    there.strut[k] = { there.rows(i, 0), there.rows(i, 1), there.rows(i, 2) };
  }
  return there;
}

/// What of a criterion on reach, joints, factors, speeds and angles a point violates, by the definitions in doubles.
/// @param slack by which it has to, without unit
inline std::set<ConditionKind> violatedAt(const Machine& machine, const Criterion& criterion, const Eigen::Vector3d& p,
                                          double slack = 0.0)
{
  using Kind = ConditionKind;
  const auto there = standing(machine, p);
  if (!there)
    return { Kind::REACH };
  std::set<Kind> violated;
  const auto limit = [&](bool is_asked, Kind kind, double value, bool is_least, double bound) {
    if (is_asked && (is_least ? bound - value : value - bound) > slack)
      violated.insert(kind);
  };
  for (int i = 0; i < 3; ++i)
  {
    const Interval& range = machine.leg(i).limits;
    limit(criterion.joint_limits, Kind::JOINT_LOWER, there->rho[i], true, range.lower());
    limit(criterion.joint_limits, Kind::JOINT_UPPER, there->rho[i], false, range.upper());
  }
  Eigen::Matrix3d to_joints = there->rows;
  for (int i = 0; i < 3; ++i)
    to_joints.row(i) /= there->eta[static_cast<std::size_t>(i)];
  const Eigen::Vector3d psi = Eigen::JacobiSVD<Eigen::Matrix3d>(to_joints).singularValues();
  const bool is_dextrous = criterion.set == Criterion::Set::DEXTROUS;
  limit(is_dextrous, Kind::PSI_MIN, psi[2], true, criterion.psi_min);
  limit(is_dextrous, Kind::PSI_MAX, psi[0], false, criterion.psi_max);
  if (const int sign = criterion.wantedSign(machine.aspect()))
    limit(true, Kind::ASPECT, sign * there->rows.determinant(), true, 0.0);
  const DrivenToolOf<double> tool(criterion, there->strut, there->eta);
  for (const Kind kind : { Kind::TOOL_SPEED_MIN, Kind::STRUT_ANGLE_MIN, Kind::STRUT_ANGLE_MAX })
  {
    const CriterionBound& bound = *boundOf(kind);
    if (bound.isAskedBy(criterion))
      limit(true, kind, tool.valueOf(kind), bound.is_lower, criterion.*bound.value);
  }
  return violated;
}
}  // namespace test
}  // namespace pkm_workspace
