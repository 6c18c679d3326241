// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/linear_programme.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pkm_workspace
{
namespace
{
constexpr int MAX_PIVOTS = 200;  // far above what 5 unknowns need; ends a cycle
constexpr int NONE = std::numeric_limits<int>::min();
constexpr double FEASIBILITY = 1e-13;  // relative violation that counts as none
constexpr double PIVOT = 1e-11;        // relative weight that counts as zero
}  // namespace

template <std::size_t N>
void LinearProgramme<N>::reset(const Vector& objective)
{
  rows_.clear();
  contradiction_ = Term();
  for (std::size_t k = 0; k < N; ++k)
  {
    const bool upper = objective[k] >= 0.0;
    active_[k] = { -1 - 2 * static_cast<int>(k) - (upper ? 1 : 0), std::abs(objective[k]) };
    inverse_[k].fill(0.0);
    inverse_[k][k] = upper ? 1.0 : -1.0;
  }
}

template <std::size_t N>
typename LinearProgramme<N>::Vector LinearProgramme<N>::normal(int constraint) const
{
  Vector n{};
  if (constraint >= 0)
    for (std::size_t k = 0; k < N; ++k)
      n[k] = -rows_[static_cast<std::size_t>(constraint)].slope[k];
  else
    n[static_cast<std::size_t>((-1 - constraint) / 2)] = (-1 - constraint) % 2 == 1 ? 1.0 : -1.0;
  return n;
}

template <std::size_t N>
double LinearProgramme<N>::bound(int constraint) const
{
  return constraint >= 0 ? rows_[static_cast<std::size_t>(constraint)].offset : 1.0;
}

template <std::size_t N>
double LinearProgramme<N>::excess(int constraint) const
{
  const Row& row = rows_[static_cast<std::size_t>(constraint)];
  double value = -row.offset;
  double size = std::abs(row.offset);
  for (std::size_t k = 0; k < N; ++k)
  {
    value -= row.slope[k] * point_[k];
    size += std::abs(row.slope[k]);
  }
  return value - FEASIBILITY * size;
}

template <std::size_t N>
int LinearProgramme<N>::mostViolated() const
{
  int worst = NONE;
  double largest = 0.0;
  for (std::size_t j = 0; j < rows_.size(); ++j)
  {
    const double violation = excess(static_cast<int>(j));
    if (violation > largest)
    {
      largest = violation;
      worst = static_cast<int>(j);
    }
  }
  for (std::size_t k = 0; k < N; ++k)
    if (std::abs(point_[k]) - 1.0 - FEASIBILITY > largest)
    {
      largest = std::abs(point_[k]) - 1.0 - FEASIBILITY;
      worst = -1 - 2 * static_cast<int>(k) - (point_[k] > 0.0 ? 1 : 0);
    }
  return worst;
}

/// @return w with sum_i w_i normal_i = the given normal, over the active constraints
template <std::size_t N>
typename LinearProgramme<N>::Vector LinearProgramme<N>::weightsOf(const Vector& normal) const
{
  Vector weights{};
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t k = 0; k < N; ++k)
      weights[i] += normal[k] * inverse_[k][i];
  return weights;
}

template <std::size_t N>
void LinearProgramme<N>::moveToVertex()
{
  for (std::size_t k = 0; k < N; ++k)
  {
    point_[k] = 0.0;
    for (std::size_t i = 0; i < N; ++i)
      point_[k] += inverse_[k][i] * bound(active_[i].row);
  }
}

template <std::size_t N>
void LinearProgramme<N>::exchange(std::size_t leaving, int entering, const Vector& weights)
{
  const double step = active_[leaving].weight / weights[leaving];
  for (std::size_t i = 0; i < N; ++i)
    active_[i].weight = std::max(0.0, active_[i].weight - step * weights[i]);
  active_[leaving] = { entering, step };
  for (std::size_t k = 0; k < N; ++k)
  {
    inverse_[k][leaving] /= weights[leaving];
    for (std::size_t i = 0; i < N; ++i)
      if (i != leaving)
        inverse_[k][i] -= weights[i] * inverse_[k][leaving];
  }
}

/// The ratio test: the active constraint whose multiplier reaches zero first, or N when none does.
template <std::size_t N>
std::size_t LinearProgramme<N>::leavingFor(const Vector& weights) const
{
  double largest = 0.0;
  for (const double weight : weights)
    largest = std::max(largest, std::abs(weight));
  std::size_t leaving = N;
  for (std::size_t i = 0; i < N; ++i)
    if (weights[i] > PIVOT * largest &&
        (leaving == N || active_[i].weight * weights[leaving] < active_[leaving].weight * weights[i]))
      leaving = i;
  return leaving;
}

template <std::size_t N>
bool LinearProgramme<N>::solve()
{
  for (int pivot = 0; pivot < MAX_PIVOTS; ++pivot)
  {
    moveToVertex();
    const int entering = mostViolated();
    if (entering == NONE)
      return true;
    const Vector weights = weightsOf(normal(entering));
    const std::size_t leaving = leavingFor(weights);
    if (leaving < N)
    {
      exchange(leaving, entering, weights);
      continue;
    }
    for (std::size_t i = 0; i < N; ++i)
      active_[i].weight = std::max(0.0, -weights[i]);
    contradiction_ = { entering, 1.0 };
    return false;
  }
  return true;
}

template <std::size_t N>
std::array<typename LinearProgramme<N>::Term, N + 1> LinearProgramme<N>::certificate() const
{
  std::array<Term, N + 1> terms;
  std::copy(active_.begin(), active_.end(), terms.begin());
  terms[N] = contradiction_;
  return terms;
}

template class LinearProgramme<5>;
template class LinearProgramme<6>;
}  // namespace pkm_workspace
