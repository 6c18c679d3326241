// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The part of box_kernel_impl.h that is about machines with tolerances (docs/tolerances.md).

#include "pack_gather.h"

namespace pkm_workspace
{
/// The worst that the parameters of a machine's legs make of forms: forms without parameters.
template <class Base>
class WorstParameters
{
  static constexpr std::size_t COUNT = 3 * STRUT_PARAMETERS;

public:
  using Real = Pack<Base::WIDTH, COUNT>;
  using Parameters = std::array<Base, COUNT>;

  explicit WorstParameters(const LegSpreads& spreads)
  {
    for (std::size_t leg = 0; leg < 3; ++leg)
      for (std::size_t k = 0; k < 3; ++k)
      {
        box_[leg][k] = Base(spreads[leg].set.box[k]);
        ball_[leg][k] = Base(spreads[leg].set.ball[k]);
      }
  }

  /// Encloses the least of the form over all parameters.
  AffineForm<Base> of(const AffineForm<Real>& form) const
  {
    Base sum(0);
    for (std::size_t leg = 0; leg < 3; ++leg)
      sum = sum + support(leg, slopesOf(form, leg));
    AffineForm<Base> worst = withoutParameters(form);
    worst.center = worst.center - sum;
    worst.radius = affine::widened(worst.radius, abs(worst.center) + sum, 64);
    return worst;
  }

  /// The parameters for which the form is least.
  Parameters at(const AffineForm<Real>& form) const
  {
    Parameters parameters;
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
      const auto slopes = slopesOf(form, leg);
      const std::array<Base, 3> ball = { ball_[leg][0] * slopes[0], ball_[leg][1] * slopes[1],
                                         ball_[leg][2] * slopes[2] };
      const Base per_ball = inverse(sqrt(dot(ball, ball)));
      const Base per_turn = inverse(sqrt(slopes[4] * slopes[4] + slopes[5] * slopes[5]));
      Base* const result = parameters.data() + leg * STRUT_PARAMETERS;
      for (std::size_t k = 0; k < 3; ++k)
        result[k] = against(signOf(slopes[k]) * box_[leg][k] + ball_[leg][k] * ball[k] * per_ball);
      result[3] = against(signOf(slopes[3]));
      result[4] = against(slopes[4] * per_turn);
      result[5] = against(slopes[5] * per_turn);
      result[6] = against(signOf(slopes[6]));
    }
    return parameters;
  }

  /// The form for these parameters.
  AffineForm<Base> at(const AffineForm<Real>& form, const Parameters& parameters) const
  {
    AffineForm<Base> result = withoutParameters(form);
    Base size(0);
    for (std::size_t j = 0; j < COUNT; ++j)
    {
      const Base step = Base(form.gradient[3 + j]) * parameters[j];
      result.center = result.center + step;
      size = size + abs(step);
    }
    result.radius = affine::widened(result.radius, abs(Base(form.center)) + size, 64);
    return result;
  }
  SymmetricForms<Base> at(const SymmetricForms<Real>& matrix, const Parameters& parameters) const
  {
    SymmetricForms<Base> result;
    for (std::size_t k = 0; k < 6; ++k)
      result[k] = at(matrix[k], parameters);
    return result;
  }

  /// A matrix M' with S >= M' for all parameters, and v^T S v = v^T M' v for the worst of them, nearly
  /// (docs/tolerances.md: the parameters of leg i are in row and column i of S alone, S_j = e_i m_j^T + m_j e_i^T, and
  /// for every tau > 0
  ///   +-(e_i m^T + m e_i^T) <= tau e_i e_i^T + m m^T / tau).
  /// @param t a vector across v @param weight how much the bound along t counts, too
  SymmetricForms<Base> below(const SymmetricForms<Real>& matrix, const PlainVector<Base>& v,
                             const PlainVector<Base>& t = { Base(0), Base(0), Base(0) }, double weight = 0.0) const;

private:
  using LegSlopes = std::array<Base, STRUT_PARAMETERS>;

  /// Of a length whose square may have underflowed.
  static Base inverse(const Base& x) { return Base(1) / max(x, Base(1e-140)); }
  static Base signOf(const Base& x) { return select(x < Base(0), Base(-1), Base(1)); }
  /// Where a form falls most: so much less that what is rounded stays in the set.
  static Base against(const Base& slope) { return slope * Base(-1 + 0x1p-40); }

  static LegSlopes slopesOf(const AffineForm<Real>& form, std::size_t leg)
  {
    LegSlopes slopes;
    for (std::size_t j = 0; j < STRUT_PARAMETERS; ++j)
      slopes[j] = Base(form.gradient[3 + leg * STRUT_PARAMETERS + j]);
    return slopes;
  }

  static AffineForm<Base> withoutParameters(const AffineForm<Real>& form)
  {
    return { Base(form.center),
             { Base(form.gradient[0]), Base(form.gradient[1]), Base(form.gradient[2]) },
             Base(form.radius) };
  }

  /// The most that slopes . p is, for the parameters p of a leg.
  Base support(std::size_t leg, const LegSlopes& slopes) const
  {
    Base box = abs(slopes[3]) + abs(slopes[6]);
    Base ball(0);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Base along = ball_[leg][k] * slopes[k];
      box = box + box_[leg][k] * abs(slopes[k]);
      ball = ball + along * along;
    }
    return box + sqrt(ball) + sqrt(slopes[4] * slopes[4] + slopes[5] * slopes[5]);
  }

  std::array<std::array<Base, 3>, 3> box_;
  std::array<std::array<Base, 3>, 3> ball_;
};

namespace worst_case
{
/// Where the entry of a row and a column of a symmetric matrix is: 00, 11, 22, 12, 02, 01.
constexpr std::size_t entryOf(std::size_t row, std::size_t column)
{
  return row == column ? row : 6 - row - column;
}
}  // namespace worst_case

template <class Base>
SymmetricForms<Base> WorstParameters<Base>::below(const SymmetricForms<Real>& matrix, const PlainVector<Base>& v,
                                                  const PlainVector<Base>& t, double weight) const
{
  using worst_case::entryOf;
  SymmetricForms<Base> result;
  std::array<Base, 6> loss, rest;
  loss.fill(Base(0));
  rest.fill(Base(0));
  for (std::size_t k = 0; k < 6; ++k)
    result[k] = withoutParameters(matrix[k]);
  const Base trace = abs(result[0].center) + abs(result[1].center) + abs(result[2].center) + Base(1e-300);
  for (std::size_t i = 0; i < 3; ++i)
  {
    std::array<PlainVector<Base>, STRUT_PARAMETERS> m;
    for (std::size_t j = 0; j < STRUT_PARAMETERS; ++j)
    {
      const std::size_t at = 3 + i * STRUT_PARAMETERS + j;
      for (std::size_t k = 0; k < 3; ++k)
        m[j][k] = Base(matrix[entryOf(i, k)].gradient[at]) * Base(k == i ? 0.5 : 1.0);
      for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = row; column < 3; ++column)
          if (row != i && column != i)
            rest[entryOf(row, column)] =
                rest[entryOf(row, column)] + abs(Base(matrix[entryOf(row, column)].gradient[at]));
    }
    // a share of the vectors that vary together, in a ball of parameters
    const auto take = [&](const std::array<std::pair<std::size_t, Base>, 3>& of, std::size_t count) {
      Base along(0), size(0);
      for (std::size_t n = 0; n < count; ++n)
      {
        const Base product = of[n].second * dot(m[of[n].first], v);
        const Base aside = of[n].second * dot(m[of[n].first], t);
        along = along + (product * product + Base(weight) * aside * aside);
        size = size + of[n].second * of[n].second * dot(m[of[n].first], m[of[n].first]);
      }
      const Base length = sqrt(size);
      // where v_i = 0: what it costs along v against what it costs across
      const Base room = sqrt(length / (trace + length));
      const Base share = sqrt(v[i] * v[i] + Base(weight) * t[i] * t[i]);
      const Base tau = max((sqrt(along) + room * length) / (share + room), Base(1e-300));
      loss[i] = loss[i] + select(length > Base(0), tau, Base(0));
      for (std::size_t n = 0; n < count; ++n)
        for (std::size_t row = 0; row < 3; ++row)
          for (std::size_t column = row; column < 3; ++column)
            loss[entryOf(row, column)] = loss[entryOf(row, column)] + of[n].second * of[n].second *
                                                                          m[of[n].first][row] *
                                                                          (m[of[n].first][column] / tau);
    };
    for (std::size_t k = 0; k < 3; ++k)
      take({ { { k, box_[i][k] } } }, 1);
    take({ { { 0, ball_[i][0] }, { 1, ball_[i][1] }, { 2, ball_[i][2] } } }, 3);
    take({ { { 3, Base(1) } } }, 1);
    take({ { { 4, Base(1) }, { 5, Base(1) } } }, 2);
    take({ { { 6, Base(1) } } }, 1);
  }
  const Base magnitude = loss[0] + loss[1] + loss[2];
  for (std::size_t k = 0; k < 6; ++k)
  {
    result[k].center = result[k].center - loss[k];
    result[k].radius = affine::widened(result[k].radius + rest[k], abs(result[k].center) + magnitude, 256);
  }
  return result;
}
}  // namespace pkm_workspace
