// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

#include "pkm_workspace/machine/assembly.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Where three spheres meet: the two points of |p - center_i| = length_i (trilateration), or none.
std::optional<std::array<Vector3d, 2>> meet(const Matrix3d& centers, const Vector3d& lengths)
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
}  // namespace

std::optional<Configuration> configurationAt(const Machine& machine, const IntervalVector& p)
{
  Configuration configuration;
  for (int i = 0; i < 3; ++i)
  {
    const auto index = static_cast<std::size_t>(i);
    const Leg& leg = machine.leg(i);
    const IntervalVector offset = p - machine.center(i);
    const IntervalVector across = machine.projector(i) * offset;
    const Interval radicand = sqr(leg.length) - squaredNorm(across);
    if (radicand.lower() < 0.0)
      return std::nullopt;
    const Interval eta = Interval(leg.working_mode) * sqrt(radicand);
    configuration.eta[index] = eta;
    configuration.strut[index] = across + eta * leg.axis;
    configuration.rho[index] = dot(leg.axis, offset) - eta;
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
  Vector3d rho;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3d offset = p - mid(machine.center(i));
    const Vector3d axis = mid(machine.leg(i).axis);
    const double along = axis.dot(offset);
    const double length = machine.leg(i).length.mid();
    const double across = (offset - along * axis).norm();
    if (!(across <= length))
      return std::nullopt;
    rho[i] = along - machine.leg(i).working_mode * std::sqrt((length - across) * (length + across));
  }
  return rho;
}

std::optional<Vector3d> forwardKinematics(const Machine& machine, const Vector3d& rho)
{
  return assemble(machine, rho, machine.aspect());
}

std::optional<Vector3d> assemble(const Machine& machine, const Vector3d& rho, int aspect)
{
  Matrix3d centers;
  Vector3d lengths;
  for (int i = 0; i < 3; ++i)
  {
    centers.col(i) = mid(machine.center(i)) + rho[i] * mid(machine.leg(i).axis);
    lengths[i] = machine.leg(i).length.mid();
  }
  const auto points = meet(centers, lengths);
  if (!points)
    return std::nullopt;
  for (const Vector3d& p : *points)
  {
    const Matrix3d struts = p.replicate<1, 3>() - centers;  // columns d_i
    bool fits = aspect * struts.determinant() > 0.0;
    for (int i = 0; i < 3; ++i)
      fits = fits && machine.leg(i).working_mode * struts.col(i).dot(mid(machine.leg(i).axis)) > 0.0;
    if (fits)
      return p;
  }
  return std::nullopt;
}

std::optional<Jacobians> jacobians(const Machine& machine, const Vector3d& p)
{
  const auto rho = inverseKinematics(machine, p);
  if (!rho)
    return std::nullopt;
  Jacobians result;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3d axis = mid(machine.leg(i).axis);
    const Vector3d strut = p - mid(machine.center(i)) - (*rho)[i] * axis;
    result.a.row(i) = strut.transpose();
    result.b[i] = strut.dot(axis);
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

SingularityMeasures singularityMeasures(const Machine& machine, const Jacobians& jacobians)
{
  Vector3d lengths;
  for (int i = 0; i < 3; ++i)
    lengths[i] = machine.leg(i).length.mid();
  return { (jacobians.b.cwiseAbs().cwiseQuotient(lengths)).minCoeff(),
           std::abs(jacobians.a.determinant()) / lengths.prod() };
}
}  // namespace pkm_workspace
