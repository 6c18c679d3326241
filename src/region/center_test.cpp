// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/region/center_test.h"

#include <algorithm>
#include <limits>

#include "pkm_workspace/dexterity/eigen_witness.h"

namespace pkm_workspace
{
namespace
{
/// Forms are scaled to the order of 1; no optimum of the programme lies above this.
constexpr double ROOM = 64.0;
/// Rounds of cutting planes a box, and the least relative violation that is worth a cut.
constexpr int ROUNDS = 2;
constexpr double WORTH_A_CUT = 1e-3;

Enclosed<double> exactly(double value)
{
  return Enclosed<double>(Interval(value));
}
}  // namespace

CenterTest::CenterTest(const BoxTest& test, const Shape& shape, const WitnessPoints& witnesses)
  : test_(test), shape_(shape), witnesses_(witnesses)
{}

/// @return true when the form is negative on the whole box: that alone excludes it
bool CenterTest::add(const AffineForm<double>& form)
{
  if (form.upper() < 0.0)
    return true;
  if (form.lower() > 0.0)
    return false;  // it cannot help
  forms_.push_back(form);
  programme_.add({ form.center + form.radius, { form.gradient[0], form.gradient[1], form.gradient[2], -ROOM } });
  return false;
}

bool CenterTest::addWitnessForms(const CenteredBox<double>& points)
{
  const MachineModel<double>& model = test_.model();
  const MachineForms<double> forms = model.evaluate(points);
  const double scale = model.squaredScale();
  for (std::size_t i = 0; i < 3; ++i)
    if (forms.radicand[i].upper() < model.floor(i))
      return true;
  const bool dextrous = model.criterion().set == Criterion::Set::DEXTROUS;
  if (dextrous)
    for (const bool upper : { true, false })
    {
      matrices_.push_back(exactly(1.0 / scale) * (upper ? model.upperMatrix(forms) : model.lowerMatrix(forms)));
      if (add(quadraticForm(matrices_.back(), leastEigenvector(matrices_.back()).vector)))
        return true;
    }
  else
    for (std::size_t i = 0; i < 3; ++i)
      if (add(exactly(1.0 / scale) * forms.radicand[i]))
        return true;
  if (model.oriented() && add(exactly(1.0 / (scale * std::sqrt(scale))) * model.orientation(forms)))
    return true;
  for (std::size_t leg = 0; leg < 3; ++leg)
    for (int side = 0; side < 2; ++side)
      if (model.limited(leg, side) &&
          add(exactly(1.0 / std::sqrt(scale)) * model.limitMargin(leg, side, forms, points)))
        return true;
  return false;
}

/// Checks the programme's certificate: a non-negative combination of the forms that is negative on the whole box.
bool CenterTest::combinationExcludes()
{
  AffineForm<double> sum;
  for (const auto& term : programme_.certificate())
    if (term.row >= 0)
      sum = sum + exactly(term.weight) * forms_[static_cast<std::size_t>(term.row)];
  return sum.upper() < 0.0;
}

/// @return whether the programme got a row that its optimum violates
bool CenterTest::addCuts()
{
  const auto& point = programme_.point();
  const std::array<double, 3> delta = { point[0], point[1], point[2] };
  bool added = false;
  for (const auto& matrix : matrices_)
  {
    const Eigenpair pair = leastEigenvector(matrix, delta);
    if (pair.value > room_ - WORTH_A_CUT)
      continue;
    const AffineForm<double> form = quadraticForm(matrix, pair.vector);
    const double value = form.center + form.radius + form.gradient[0] * delta[0] + form.gradient[1] * delta[1] +
                         form.gradient[2] * delta[2];
    if (value > room_ - WORTH_A_CUT * std::abs(room_))
      continue;
    add(form);
    added = true;
  }
  return added;
}

bool CenterTest::excludes(const Box& centers, double size)
{
  matrices_.clear();
  forms_.clear();
  programme_.reset({ 0.0, 0.0, 0.0, 1.0 });
  room_ = ROOM;
  const CenteredBox<double> box(centers);
  const Enclosed<double> per_length = exactly(1.0 / std::sqrt(test_.model().squaredScale()));
  for (const Eigen::Vector3d& point : witnesses_.bad())
  {
    const auto avoidance = shape_.avoidance(point, centers, size);
    if (avoidance && add(per_length * *avoidance))
      return true;
  }
  for (const Eigen::Vector3d& k : witnesses_.ofShape())
    if (addWitnessForms(box.moved(size, k)))
      return true;
  for (int round = 0; round < ROUNDS && !forms_.empty(); ++round)
  {
    const bool feasible = programme_.solve();
    room_ = programme_.point()[3] * ROOM;
    if (!feasible || room_ < 0.0)
      return combinationExcludes();
    if (!addCuts())
      return false;
  }
  return false;
}

double CenterTest::margin(const Eigen::Vector3d& center, double size, double enough) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& point : witnesses_.bad())
    if (shape_.contains(point, Box{ center, center }, size))
      return -least;
  for (const Eigen::Vector3d& k : witnesses_.ofShape())
  {
    least = std::min(least, test_.margin(center + size * k));
    if (least < enough)
      break;
  }
  return least;
}
}  // namespace pkm_workspace
