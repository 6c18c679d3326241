// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "pkm_workspace/dexterity/global_conditioning.h"

namespace pkm_workspace
{
namespace
{
using Form = AffineForm<double>;
using Matrix = SymmetricForms<double>;

const ConditioningBounds NOTHING{ Interval(0.0, 1.0), Interval(0.0, 1.0) };
const ConditioningBounds OUT_OF_REACH{ Interval(0.0), Interval(0.0) };

/// How often a bound of an eigenvalue is loosened before it is given up.
constexpr int TRIALS = 40;

/// (A A^T - t B^2), or its opposite.
Matrix pencil(const Matrix& a_a, const std::array<Form, 3>& b_b, const Form& t, bool opposite)
{
  Matrix matrix = a_a;
  for (std::size_t i = 0; i < 3; ++i)
    matrix[i] = matrix[i] - t * b_b[i];
  if (opposite)
    for (Form& entry : matrix)
      entry = -entry;
  return matrix;
}

/// Encloses an extreme eigenvalue of the pencil A A^T - sigma B^2 over the box. The quotient of Rayleigh for its vector
/// at the center bounds it from the one side, a level that is proved to be beyond all eigenvalues from the other.
/// @return false when there is no such level
bool encloseExtreme(const Matrix& a_a, const std::array<Form, 3>& b_b, const std::array<double, 3>& u, bool is_largest,
                    Form& result)
{
  const Form denominator = quadraticForm(diagonal(b_b), u);
  if (!(denominator.lower() > 0.0))
    return false;
  const Form quotient = quadraticForm(a_a, u) * inverseOf(denominator);
  Form level = quotient;
  level.radius = 0.0;
  double distance = quotient.radius + 1e-14 * std::abs(quotient.center);
  const double outward = is_largest ? 1.0 : -1.0;
  for (int trial = 0; trial < TRIALS; ++trial, distance *= 2.0)
  {
    level.center = quotient.center + outward * distance;
    if (!isPositiveDefinite(pencil(a_a, b_b, level, is_largest)))
      continue;
    result = quotient;
    result.radius = affine::widened(distance, quotient.magnitude() + distance, 8);
    return true;
  }
  return false;
}

/// The linear part of a form has no mean over the box but for the rounding of its center.
Interval meanOver(const Form& form, const Box& box, const CenteredBox<double>& centered)
{
  const std::array<Interval, 3> deviation = deviations(box, centered);
  Interval error(form.radius);
  for (std::size_t j = 0; j < 3; ++j)
    error += Interval(std::abs(form.gradient[j])) * deviation[j];
  return Interval(form.center) + Interval(-error.upper(), error.upper());
}

Interval withinShares(const Interval& x)
{
  return { std::min(1.0, std::max(0.0, x.lower())), std::min(1.0, std::max(0.0, x.upper())) };
}
}  // namespace

ConditioningBounds conditioningOver(const MachineModel<double>& model, const Box& box)
{
  const CenteredBox<double> centered(box);
  const MachineForms<double> forms = model.legs().evaluate(centered);
  const std::array<Form, 3> b_b = forms.squaredDrives();
  for (const Form& square : b_b)
    if (square.upper() < 0.0)
      return OUT_OF_REACH;
  for (const Form& square : b_b)
    if (!(square.lower() > 0.0))
      return NOTHING;
  const Matrix a_a = gramMatrix(model.legs(), forms);
  const ExtremeFactors<double> factors = extremeFactors(model.legs(), forms);
  Form least, largest;
  if (!encloseExtreme(a_a, b_b, factors.largest.vector, true, largest) || !(largest.lower() > 0.0) ||
      !encloseExtreme(a_a, b_b, factors.least.vector, false, least))
    return NOTHING;
  const Form index = sqrtAbove(least * inverseOf(largest), 0.0);
  if (!std::isfinite(index.magnitude()))
    return NOTHING;
  return { withinShares(meanOver(index, box, centered)), withinShares(Interval(index.lower(), index.upper())) };
}
}  // namespace pkm_workspace
