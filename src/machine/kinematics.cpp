// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <utility>

#include "pkm_workspace/machine/assembly.h"
#include "pkm_workspace/machine/leg_forms.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// @return nothing where a leg does not reach
std::optional<std::array<LegAtPoint, 3>> legsAt(const Machine& machine, const Vector3d& p)
{
  std::array<LegAtPoint, 3> legs;
  for (int i = 0; i < 3; ++i)
    if (!visitLeg([&](const auto& kind) { return evaluateNear(kind, p, legs[static_cast<std::size_t>(i)]); },
                  machine.meant(i)))
      return std::nullopt;
  return legs;
}

bool isInModeOf(const Machine& machine, int leg, double joint, const Vector3d& strut)
{
  return visitLeg([&](const auto& kind) { return isInMode(kind, joint, strut); }, machine.meant(leg));
}
}  // namespace

std::optional<std::array<Vector3d, 2>> meetingPoints(const Matrix3d& centers, const Vector3d& lengths)
{
  const Vector3d origin = centers.col(0);
  const Vector3d u = centers.col(1) - origin;
  const Vector3d v = centers.col(2) - origin;
  const Vector3d normal = u.cross(v);
  const double area_squared = normal.squaredNorm();
  if (!(area_squared > 0.0))
    return std::nullopt;  // the slider points lie on a line: a parallel singularity
  const double along_u = 0.5 * (u.squaredNorm() + (lengths[0] - lengths[1]) * (lengths[0] + lengths[1]));
  const double along_v = 0.5 * (v.squaredNorm() + (lengths[0] - lengths[2]) * (lengths[0] + lengths[2]));
  const Vector3d in_plane = (along_u * v.cross(normal) + along_v * normal.cross(u)) / area_squared;
  const double height_squared = lengths[0] * lengths[0] - in_plane.squaredNorm();
  if (!(height_squared >= 0.0))
    return std::nullopt;
  const Vector3d height = std::sqrt(height_squared / area_squared) * normal;
  return std::array<Vector3d, 2>{ origin + in_plane + height, origin + in_plane - height };
}

std::optional<Configuration> configurationAt(const Machine& machine, const IntervalVector& p)
{
  Configuration configuration;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const EnclosedLeg& leg = machine.enclosed(static_cast<int>(i));
    LegState<Interval, IntervalVector> state;
    evaluate(leg, p, sqrtAboveZero, state);
    if (state.squared_drive.lower() < 0.0)
      return std::nullopt;
    configuration.eta[i] = state.drive;
    configuration.strut[i] = state.row;
    configuration.rho[i] = jointOf(leg, p, state);
  }
  configuration.det_a = determinant(configuration.strut[0], configuration.strut[1], configuration.strut[2]);
  return configuration;
}

std::optional<Configuration> configurationAt(const Machine& machine, const Vector3d& p)
{
  return configurationAt(machine, enclose(p));
}

std::optional<Vector3d> inverseKinematics(const Machine& machine, const Vector3d& p)
{
  const auto legs = legsAt(machine, p);
  return legs ? std::make_optional<Vector3d>((*legs)[0].joint, (*legs)[1].joint, (*legs)[2].joint) : std::nullopt;
}

std::optional<Vector3d> forwardKinematics(const Machine& machine, const Vector3d& rho)
{
  return assemble(machine, rho, machine.aspect());
}

namespace
{
/// What the struts end on: centers one a column, and radii [m].
std::pair<Matrix3d, Vector3d> spheresAt(const Machine& machine, const Vector3d& rho)
{
  std::pair<Matrix3d, Vector3d> spheres;
  for (int i = 0; i < 3; ++i)
  {
    const LegSphere sphere = sphereAt(machine.meant(i), rho[i]);
    spheres.first.col(i) = sphere.center;
    spheres.second[i] = sphere.radius;
  }
  return spheres;
}
}  // namespace

std::optional<std::array<Vector3d, 2>> assemblies(const Machine& machine, const Vector3d& rho)
{
  const auto [centers, radii] = spheresAt(machine, rho);
  return meetingPoints(centers, radii);
}

std::optional<Vector3d> assemble(const Machine& machine, const Vector3d& rho, int aspect)
{
  const auto [centers, radii] = spheresAt(machine, rho);
  const auto points = meetingPoints(centers, radii);
  if (!points)
    return std::nullopt;
  for (const Vector3d& p : *points)
  {
    const Matrix3d struts = p.replicate<1, 3>() - centers;  // columns d_i
    bool fits = aspect * struts.determinant() > 0.0;
    for (int i = 0; i < 3; ++i)
      fits = fits && isInModeOf(machine, i, rho[i], struts.col(i));
    if (fits)
      return p;
  }
  return std::nullopt;
}

std::optional<Jacobians> jacobians(const Machine& machine, const Vector3d& p)
{
  const auto legs = legsAt(machine, p);
  if (!legs)
    return std::nullopt;
  Jacobians result;
  for (int i = 0; i < 3; ++i)
  {
    const LegAtPoint& leg = (*legs)[static_cast<std::size_t>(i)];
    result.a.row(i) = Eigen::Map<const Eigen::RowVector3d>(leg.state.row.data());
    result.b[i] = leg.state.drive;
    if (result.b[i] == 0.0)
      return std::nullopt;
  }
  result.j_inverse = result.b.cwiseInverse().asDiagonal() * result.a;
  result.j = result.j_inverse.inverse();
  return result;
}

Vector3d transmissionFactors(const Jacobians& jacobians)
{
  const Eigen::JacobiSVD<Matrix3d> svd(jacobians.j_inverse);
  return svd.singularValues().reverse();
}

SingularityMeasures singularityMeasures(const Jacobians& jacobians)
{
  const Vector3d lengths = jacobians.a.rowwise().norm();
  return { std::min(1.0, jacobians.b.cwiseAbs().cwiseQuotient(lengths).minCoeff()),
           std::min(1.0, std::abs(jacobians.a.determinant()) / lengths.prod()) };
}
}  // namespace pkm_workspace
