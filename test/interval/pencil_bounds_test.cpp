// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/pencil_bounds.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "support/forms.h"
#include "support/mode_and_spread.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Matrix3d;
using Matrix = SymmetricForms<double>;
using Spans = std::array<Span<double>, 3>;

constexpr int ENTRY_ROW[] = { 0, 1, 2, 1, 0, 0 };
constexpr int ENTRY_COLUMN[] = { 0, 1, 2, 2, 2, 1 };

Matrix3d randomPencil(Random& random)
{
  Matrix3d m;
  for (int k = 0; k < 9; ++k)
    m(k % 3, k / 3) = random.uniform(-1.0, 1.0);
  return m;
}

/// A matrix with small gradients and errors, or none.
Matrix formsAround(const Matrix3d& m, double ripple, double error, Random& random)
{
  Matrix result;
  for (std::size_t k = 0; k < 6; ++k)
  {
    result[k] = { m(ENTRY_ROW[k], ENTRY_COLUMN[k]), {}, error };
    for (double& g : result[k].gradient)
      g = ripple * random.uniform(-1.0, 1.0);
  }
  return result;
}

/// A pencil and nearly its eigenvectors and eigenvalues; two or three of these may coincide.
struct Pencil
{
  Matrix k, d;
  std::array<std::array<double, 3>, 3> w;
  std::array<double, 3> mu;

  explicit Pencil(Random& random)
  {
    const Matrix3d root = randomPencil(random) + 4.0 * Matrix3d::Identity();
    const Matrix3d b = root * root.transpose();
    Eigen::Vector3d values(random.uniform(0.1, 4.0), random.uniform(0.1, 4.0), random.uniform(0.1, 4.0));
    if (random.once(3))
      values[1] = values[0];
    if (random.once(6))
      values[2] = values[1] = values[0];
    const Eigen::HouseholderQR<Matrix3d> turn(randomPencil(random));
    const Matrix3d q = turn.householderQ();
    const Matrix3d a = root * q * values.asDiagonal() * q.transpose() * root.transpose();
    const Matrix3d symmetric = 0.5 * (a + a.transpose());
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix3d> solver(symmetric, b);
    const double ripple = random.once(3) ? 0.0 : std::ldexp(1.0, -random.integer(4, 40));
    const double error = random.once(2) ? 0.0 : 0.1 * ripple;
    k = formsAround(symmetric, ripple, error, random);
    d = formsAround(b, ripple, 0.0, random);
    for (int n = 0; n < 3; ++n)
    {
      for (int i = 0; i < 3; ++i)
        w[static_cast<std::size_t>(n)][static_cast<std::size_t>(i)] = solver.eigenvectors()(i, n);
      mu[static_cast<std::size_t>(n)] = solver.eigenvalues()[n];
    }
  }
};

using ExactPencil = std::array<Exact, 6>;

ExactPencil pencilMember(const Matrix& m, Forms& forms)
{
  ExactPencil result;
  for (std::size_t k = 0; k < 6; ++k)
    result[k] = forms.member(m[k]);
  return result;
}

Matrix3d rounded(const ExactPencil& m)
{
  Matrix3d result;
  for (std::size_t k = 0; k < 6; ++k)
    result(ENTRY_ROW[k], ENTRY_COLUMN[k]) = result(ENTRY_COLUMN[k], ENTRY_ROW[k]) = m[k].value();
  return result;
}

/// Whether sign * (K - mu D) is proved not to be positive semidefinite, by its leading minors.
bool isIndefinite(const ExactPencil& k, const ExactPencil& d, double mu, double sign)
{
  ExactPencil m;
  for (std::size_t entry = 0; entry < 6; ++entry)
    m[entry] = Exact(sign) * (k[entry] - Exact(mu) * d[entry]);
  const ExactVector rows[] = { { m[0], m[5], m[4] }, { m[5], m[1], m[3] }, { m[4], m[3], m[2] } };
  return m[0].certainlyNegative() || (m[0] * m[1] - m[5] * m[5]).certainlyNegative() ||
         determinant(rows[0], rows[1], rows[2]).certainlyNegative();
}

class PencilBoundsContainment : public testing::TestWithParam<RoundingMode>
{
};

TEST_P(PencilBoundsContainment, boundsHoldTheEigenvaluesOfEveryMember)
{
  for (int seed = 0; seed < cases(1000) && !HasFailure(); ++seed)
  {
    Forms forms(static_cast<std::uint64_t>(seed));
    const Pencil pencil(forms.random());
    const Spans found =
        under<Spans>(GetParam(), [&] { return pencilEigenvalues(pencil.k, pencil.d, pencil.w, pencil.mu); });
    for (int i = 0; i < 4; ++i, forms.move())
    {
      const ExactPencil k = pencilMember(pencil.k, forms), d = pencilMember(pencil.d, forms);
      ASSERT_FALSE(isIndefinite(k, d, found[0].lower, 1.0)) << "seed " << seed;
      ASSERT_FALSE(isIndefinite(k, d, found[2].upper, -1.0)) << "seed " << seed;
      const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix3d> solver(rounded(k), rounded(d));
      for (std::size_t n = 0; n < 3; ++n)
      {
        const double value = solver.eigenvalues()[static_cast<int>(n)];
        ASSERT_GE(value, found[n].lower - 1e-11) << "seed " << seed << ", number " << n;
        ASSERT_LE(value, found[n].upper + 1e-11) << "seed " << seed << ", number " << n;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, PencilBoundsContainment, testing::ValuesIn(MODES),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(PencilBounds, areTightForNumbers)
{
  for (int seed = 0; seed < cases(300); ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    Pencil pencil(random);
    for (Matrix* m : { &pencil.k, &pencil.d })
      for (auto& entry : *m)
        entry = { entry.center, {}, 0.0 };
    const Spans found = pencilEigenvalues(pencil.k, pencil.d, pencil.w, pencil.mu);
    for (std::size_t n = 0; n < 3; ++n)
      EXPECT_LE(found[n].upper - found[n].lower, 1e-8) << "seed " << seed << ", number " << n;
  }
}

TEST(PencilBounds, saysNothingWhereTheOtherMatrixIsNotDefiniteOrNumbersAreNone)
{
  const AffineForm<double> one{ 1.0, {}, 0.0 };
  const Matrix identity{ one, one, one, {}, {}, {} };
  const Matrix flat{ one, one, {}, {}, {}, {} };
  const std::array<std::array<double, 3>, 3> w{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };
  const double nan = std::nan("");
  for (const Spans& found : { pencilEigenvalues(identity, flat, w, { 1.0, 1.0, 1.0 }),
                              pencilEigenvalues(identity, identity, w, { nan, nan, nan }) })
    for (const Span<double>& span : found)
    {
      EXPECT_EQ(span.lower, -std::numeric_limits<double>::infinity());
      EXPECT_EQ(span.upper, std::numeric_limits<double>::infinity());
    }
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
