// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/urdf_io/joint_values.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "number_text.h"

namespace pkm_workspace
{
using namespace urdf_io;

namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

/// The turn about the unit vector @p axis that takes @p from to @p to, two vectors of the same angle to it [rad].
double angleAbout(const Vector3d& axis, const Vector3d& from, const Vector3d& to)
{
  const Vector3d across = from - axis.dot(from) * axis;
  return std::atan2(axis.cross(across).dot(to), across.dot(to));
}

/// Angles of the two passive joints that turn the strut of the zero configuration into @p strut: the second joint takes
/// it to w, the first takes w on. The angles of w to both axes are known, w = alpha u + beta v + gamma u x v follows
/// (Paden and Kahan's second subproblem); the sign of gamma stays that of the zero configuration.
std::optional<Vector2d> hingeAngles(const StrutHinges& hinges, const Vector3d& strut)
{
  const Vector3d& u = hinges.axes[0];
  const Vector3d& v = hinges.axes[1];
  const Vector3d normal = u.cross(v);
  const double cosine = u.dot(v);
  const double sine_squared = normal.squaredNorm();
  const double alpha = (u.dot(strut) - cosine * v.dot(hinges.strut)) / sine_squared;
  const double beta = (v.dot(hinges.strut) - cosine * u.dot(strut)) / sine_squared;
  const Vector3d in_plane = alpha * u + beta * v;
  const double rest = (strut.squaredNorm() - in_plane.squaredNorm()) / sine_squared;
  if (!(rest >= 0.0))
    return std::nullopt;
  const double gamma = std::copysign(std::sqrt(rest), hinges.strut.dot(normal));
  const Vector3d between = in_plane + gamma * normal;
  return Vector2d(angleAbout(u, between, strut), angleAbout(v, hinges.strut, between));
}

std::invalid_argument unreachable(const Vector3d& p, const std::string& reason)
{
  return std::invalid_argument("tool point (" + vectorText(p) + ") m: " + reason);
}
}  // namespace

std::map<std::string, double> jointValues(const UrdfMachine& urdf, const Vector3d& p)
{
  const auto rho = inverseKinematics(urdf.machine, p);
  if (!rho)
    throw unreachable(p, "a strut does not reach it");
  std::map<std::string, double> masters;
  for (int i = 0; i < 3; ++i)
  {
    const Leg& leg = urdf.machine.leg(i);
    const StrutHinges& hinges = urdf.hinges[static_cast<std::size_t>(i)];
    Vector3d strut = p - sphereAt(urdf.machine.meant(i), (*rho)[i]).center;
    if (std::holds_alternative<TelescopicStrut>(leg.kind))
      strut *= hinges.strut.norm() / strut.norm();
    const auto angles = hingeAngles(hinges, strut);
    if (!angles)
      throw unreachable(p, "the passive joints '" + hinges.joints[0] + "' and '" + hinges.joints[1] +
                               "' cannot turn the strut that far");
    masters[leg.joint] = (*rho)[i];
    for (std::size_t k = 0; k < 2; ++k)
      masters[hinges.masters[k]] = (*angles)[static_cast<Eigen::Index>(k)] / hinges.factors[k];
  }
  std::map<std::string, double> values;
  for (const JointFollower& follower : urdf.followers)
  {
    const auto master = masters.find(follower.source);
    values[follower.joint] = (master == masters.end() ? 0.0 : follower.factor * master->second) + follower.offset;
  }
  return values;
}
}  // namespace pkm_workspace
