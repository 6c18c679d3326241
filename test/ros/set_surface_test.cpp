// SPDX-License-Identifier: BSD-3-Clause
// Colours of the set by condition, held against the definitions beyond each part of its surface.
#include "pkm_workspace/ros/set_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "../../src/ros/condition_color.h"
#include "drawing.h"
#include "pkm_workspace/report/binding_limit.h"
#include "support/definition.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;
using Kind = ConditionKind;

const std::vector<Kind> KINDS = {
  Kind::REACH,           Kind::JOINT_LOWER,   Kind::JOINT_UPPER,        Kind::ASPECT,
  Kind::PSI_MIN,         Kind::PSI_MAX,       Kind::KAPPA_MAX,          Kind::TOOL_SPEED_MIN,
  Kind::TOOL_FORCE_MIN,  Kind::STIFFNESS_MIN, Kind::POSITION_ERROR_MAX, Kind::STRUT_ANGLE_MIN,
  Kind::STRUT_ANGLE_MAX, Kind::BALL_TILT_MAX, Kind::HINGE_LOWER,        Kind::HINGE_UPPER,
  Kind::KEEP_IN,         Kind::KEEP_OUT
};

struct Case
{
  std::string name;
  Machine machine;
  Criterion criterion;
  std::vector<Kind> kinds;  ///< that end the set
  double share;             ///< of its surface that has one of their colours, at least
  std::optional<Box> box = {};
};

std::vector<Case> pictures()
{
  Criterion driven;
  driven.joint_speed_max = { 1.0, 1.1, 1.2 };
  driven.tool_speed_min = 0.85;
  driven.strut_angle_max = 0.7;
  Criterion limited;
  limited.joint_limits = true;
  return { { "psi", orthoglide(), Criterion(), { Kind::PSI_MIN, Kind::PSI_MAX }, 0.99 },
           { "driven", orthoglide(), driven, { Kind::PSI_MIN, Kind::TOOL_SPEED_MIN, Kind::STRUT_ANGLE_MAX }, 0.99 },
           { "limits", orthoglidePrototype(), limited, { Kind::JOINT_LOWER, Kind::JOINT_UPPER, Kind::PSI_MIN }, 0.99 },
           { "flat", uranesx(), Criterion(), { Kind::PSI_MAX }, 0.05 } };
}

Paving pavingOf(const Case& each)
{
  PavingQuery query;
  query.criterion = each.criterion;
  query.resolution = 0.03 * each.machine.scale();
  query.box = each.box;
  return pave(each.machine, query);
}

visualization_msgs::MarkerArray shown(const SetSurface& set, const Case& each, double ceiling)
{
  return markersOf(set, premisesOf(each.machine, each.criterion), each.machine, Workspace(), ceiling);
}

Color of(const std_msgs::ColorRGBA& color)
{
  return { color.r, color.g, color.b, color.a };
}

/// Whether they differ in nothing but the shade of a face.
bool isShadeOf(const Color& color, const Color& full)
{
  for (const float shade : { 0.92F, 0.84F, 1.0F })
    if (std::abs(color.r - shade * full.r) + std::abs(color.g - shade * full.g) + std::abs(color.b - shade * full.b) <
        1e-4F)
      return true;
  return false;
}

/// A rectangle of a surface: two triangles.
struct Face
{
  Vector3d middle;
  Vector3d outwards;
  double area;
  std::optional<Kind> kind;
};

std::vector<Face> facesOf(const Marker& surface)
{
  std::vector<Face> faces;
  for (std::size_t i = 0; i < surface.points.size(); i += 6)
  {
    const Vector3d first = vectorOf(surface.points[i]);
    const Vector3d second = vectorOf(surface.points[i + 1]);
    const Vector3d third = vectorOf(surface.points[i + 2]);
    const Vector3d across = (second - first).cross(third - first);
    Face face{ 0.5 * (first + third), across.normalized(), across.norm(), {} };
    for (const Kind kind : KINDS)
      if (isShadeOf(of(surface.colors[i]), conditionColor(kind)))
        face.kind = kind;
    faces.push_back(face);
  }
  return faces;
}

/// The first points beyond a face that are bad by the definitions, and what is violated there; none where the set goes
/// on for some boxes.
std::set<Kind> firstViolated(const Case& each, const Face& face, double width)
{
  constexpr int STEPS = 400;
  for (int k = 0; k <= STEPS; ++k)
  {
    const Vector3d point = face.middle + 4.0 * width * k / STEPS * face.outwards;
    const std::set<Kind> violated = violatedAt(each.machine, each.criterion, point);
    if (!violated.empty())
      return violated;
  }
  return {};
}

/// What is violated first from somewhere near a face in its plane: where two conditions meet, its parts differ.
bool isFirstNear(const Case& each, const Face& face, double width)
{
  for (int u = -1; u <= 1; ++u)
    for (int v = -1; v <= 1; ++v)
    {
      Face near = face;
      const Vector3d along = face.outwards.unitOrthogonal();
      near.middle += width * (u * along + v * face.outwards.cross(along));
      if (firstViolated(each, near, width).count(*face.kind) > 0)
        return true;
    }
  return false;
}
}  // namespace

TEST(SetSurface, hasTheColorsOfWhatEndsTheSetByTheDefinitions)
{
  for (const Case& each : pictures())
  {
    SCOPED_TRACE(each.name);
    const Paving paving = pavingOf(each);
    const Box smallest = paving.tree.bisection().box({ 0, 0, 0 }, paving.tree.levels() - 1);
    const double width = (smallest.upper - smallest.lower).maxCoeff();
    const SetSurface set(paving, each.machine, SetColors::CONDITION, false);
    int exact = 0;
    int straight = 0;
    double colored = 0.0;
    double whole = 0.0;
    for (const Face& face : facesOf(inNamespace(shown(set, each, 1e9), "inside")[0]))
    {
      whole += face.area;
      colored += face.kind ? face.area : 0.0;
      const bool is_flat_side = each.name == "flat" && std::abs(face.outwards.z()) > 0.5;
      if (!face.kind || is_flat_side || firstViolated(each, face, width).empty())
        continue;
      ++straight;
      exact += firstViolated(each, face, width).count(*face.kind) > 0 ? 1 : 0;
      EXPECT_TRUE(isFirstNear(each, face, width)) << name(*face.kind) << " beyond " << face.middle.transpose();
    }
    EXPECT_GT(straight, 100);
    EXPECT_GE(exact, 0.97 * straight);
    EXPECT_GE(colored, each.share * whole);
  }
}

TEST(SetSurface, hasALegendOfTheConditionsThatOccur)
{
  for (const Case& each : pictures())
  {
    SCOPED_TRACE(each.name);
    const SetSurface set(pavingOf(each), each.machine, SetColors::CONDITION, true);
    std::vector<std::string> expected;
    for (const Kind kind : each.kinds)
      expected.push_back(briefly(kind, each.criterion));
    std::vector<std::string> told;
    std::set<Kind> of_legend;
    for (const LegendRow& row : set.legend())
    {
      told.push_back(row.text);
      for (const Kind kind : each.kinds)
        if (isShadeOf(row.color, conditionColor(kind)))
          of_legend.insert(kind);
    }
    EXPECT_EQ(expected, told);
    EXPECT_EQ(std::set<Kind>(each.kinds.begin(), each.kinds.end()), of_legend);
    std::set<Kind> drawn;
    for (const char* ns : { "inside", "boundary" })
      for (const Face& face : facesOf(inNamespace(shown(set, each, 1e9), ns)[0]))
        if (face.kind)
          drawn.insert(*face.kind);
    EXPECT_EQ(of_legend, drawn);
  }
}

TEST(SetSurface, hasNoEndWhereItIsOnlyCutOff)
{
  const Case psi = pictures()[0];
  const SetSurface set(pavingOf(psi), psi.machine, SetColors::CONDITION, false);
  const Marker all = inNamespace(shown(set, psi, 1e9), "inside")[0];
  const Marker cut = inNamespace(shown(set, psi, 0.0), "inside")[0];
  double plain = 0.0;
  for (const Face& face : facesOf(cut))
  {
    EXPECT_LE(face.middle.z(), 0.0);
    if (!face.kind)
      plain += face.area;
  }
  EXPECT_GT(plain, 1.0) << "the section through the middle";
  for (const Face& face : facesOf(all))
    EXPECT_TRUE(face.kind) << face.middle.transpose();
}

TEST(SetSurface, hasOneColorByVerdict)
{
  const Case psi = pictures()[0];
  const SetSurface set(pavingOf(psi), psi.machine, SetColors::VERDICT, false);
  EXPECT_TRUE(set.legend().empty());
  for (const Face& face : facesOf(inNamespace(shown(set, psi, 1e9), "inside")[0]))
    EXPECT_FALSE(face.kind);
}

namespace
{
using Matrix = Eigen::Matrix3d;

double linear(float value)
{
  return value <= 0.04045F ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// CIELAB, as seen by those whose colour vision the matrix simulates.
Vector3d seen(const Color& color, const Matrix& vision)
{
  Matrix to_xyz;
  to_xyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const Vector3d rgb =
      (vision * Vector3d(linear(color.r), linear(color.g), linear(color.b))).cwiseMax(0.0).cwiseMin(1.0);
  const Vector3d f = (to_xyz * rgb).cwiseQuotient(Vector3d(0.9505, 1.0, 1.089)).unaryExpr([](double t) {
    return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0;
  });
  return { 116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2]) };
}
}  // namespace

/// Simulations by Machado, Oliveira and Fernandes (2009), of full severity.
TEST(ConditionColor, isToldApartWhateverColorsOneSees)
{
  Matrix protan, deutan, tritan;
  protan << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
  deutan << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
  tritan << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
  for (const Matrix& vision : { Matrix(Matrix::Identity()), protan, deutan, tritan })
    for (std::size_t i = 0; i < KINDS.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_GT((seen(conditionColor(KINDS[i]), vision) - seen(conditionColor(KINDS[k]), vision)).norm(), 15.0)
            << name(KINDS[i]) << " and " << name(KINDS[k]);
}
}  // namespace test
}  // namespace pkm_workspace
