// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Eigenvalues>
#include <array>

#include "pkm_workspace/interval/definiteness.h"

namespace pkm_workspace
{
/// An eigenpair in floating point: a vector v for which v^T M v is likely to be small. A proof never rests on it,
/// only on the enclosure of v^T M v, which holds for any v.
struct Eigenpair
{
  double value;
  std::array<double, 3> vector;
};

/// The eigenpairs of M at one delta, ascending.
template <class Real>
std::array<Eigenpair, 3> eigenpairs(const SymmetricForms<Real>& m,
                                    const std::array<double, 3>& delta = { 0.0, 0.0, 0.0 })
{
  const auto at = [&](std::size_t k) {
    double value = static_cast<double>(m[k].center);
    for (std::size_t j = 0; j < 3; ++j)
      value += static_cast<double>(m[k].gradient[j]) * delta[j];
    return value;
  };
  Eigen::Matrix3d matrix;
  matrix << at(0), at(5), at(4), at(5), at(1), at(3), at(4), at(3), at(2);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(matrix);
  std::array<Eigenpair, 3> pairs;
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::Vector3d v = solver.eigenvectors().col(k);
    pairs[static_cast<std::size_t>(k)] = { solver.eigenvalues()[k], { v.x(), v.y(), v.z() } };
  }
  return pairs;
}

/// The pair of the least eigenvalue.
template <class Real>
Eigenpair leastEigenvector(const SymmetricForms<Real>& m, const std::array<double, 3>& delta = { 0.0, 0.0, 0.0 })
{
  return eigenpairs(m, delta)[0];
}
}  // namespace pkm_workspace
