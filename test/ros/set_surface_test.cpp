// SPDX-License-Identifier: BSD-3-Clause
// Colours of the set by condition, held against the definitions beyond each part of its surface.
#include "pkm_workspace/ros/set_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pkm_workspace/report/binding_limit.h"
#include "set_faces.h"

namespace pkm_workspace
{
namespace test
{
using Eigen::Vector3d;

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
    for (const Face& face : facesOf(inNamespace(shown(set, each, 1e9), "inside")[0], each.kinds))
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
      for (const Face& face : facesOf(inNamespace(shown(set, each, 1e9), ns)[0], each.kinds))
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
  for (const Face& face : facesOf(cut, psi.kinds))
  {
    EXPECT_LE(face.middle.z(), 0.0);
    if (!face.kind)
      plain += face.area;
  }
  EXPECT_GT(plain, 1.0) << "the section through the middle";
  for (const Face& face : facesOf(all, psi.kinds))
    EXPECT_TRUE(face.kind) << face.middle.transpose();
}

TEST(SetSurface, hasOneColorByVerdict)
{
  const Case psi = pictures()[0];
  const SetSurface set(pavingOf(psi), psi.machine, SetColors::VERDICT, false);
  EXPECT_TRUE(set.legend().empty());
  for (const Face& face : facesOf(inNamespace(shown(set, psi, 1e9), "inside")[0], KINDS))
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
