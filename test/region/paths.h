// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/region/path.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/oracle.h"

namespace pkm_workspace
{
namespace test
{
inline Criterion reachable()
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.aspect = Criterion::Aspect::BOTH;
  return criterion;
}

inline Criterion conditioned()
{
  Criterion criterion = reachable();
  criterion.aspect = Criterion::Aspect::OWN;
  criterion.kappa_max = 2.5;
  return criterion;
}

inline Criterion withLimits()
{
  Criterion criterion;
  criterion.joint_limits = true;
  return criterion;
}

/// A segment and its points to 100 digits.
using Eigen::Vector3d;
using Number = Oracle::Number;

struct ExactSegment
{
  PathSegment segment;
  std::function<Oracle::Vector(const Number&)> point;
};

inline Oracle::Vector wide(const Vector3d& v)
{
  return { v.x(), v.y(), v.z() };
}

inline ExactSegment exactLine(const Vector3d& start, const Vector3d& end)
{
  const auto point = [start, end](const Number& t) {
    Oracle::Vector p = wide(start);
    for (std::size_t k = 0; k < 3; ++k)
      p[k] += t * (Number(end[static_cast<int>(k)]) - p[k]);
    return p;
  };
  return { PathSegment::line(start, end), point };
}

/// By Rodrigues' formula.
inline ExactSegment exactArc(const Vector3d& start, const Vector3d& center, const Vector3d& axis, double angle,
                             double lift)
{
  const auto point = [=](const Number& t) {
    Oracle::Vector n = wide(axis), r = wide(start), p = wide(center);
    const Number length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (std::size_t k = 0; k < 3; ++k)
    {
      n[k] /= length;
      r[k] -= p[k];
    }
    const Number along = n[0] * r[0] + n[1] * r[1] + n[2] * r[2];
    const Number c = cos(t * angle), s = sin(t * angle);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      p[k] += c * r[k] + (1 - c) * along * n[k] + s * (n[i] * r[j] - n[j] * r[i]) + t * lift * n[k];
    }
    return p;
  };
  return { PathSegment::arc(start, center, axis, angle, lift), point };
}

struct Question
{
  Machine machine;
  Criterion criterion;
};

inline std::vector<Question> everyQuestion()
{
  std::vector<Question> questions;
  for (const Machine& machine : everyKind())
  {
    questions.push_back({ machine, Criterion() });
    questions.push_back({ limited(machine), withLimits() });
  }
  questions.push_back({ orthoglide(), reachable() });
  questions.push_back({ crooked(1), conditioned() });
  return questions;
}

/// Half of them lines, half arcs or helices; of any length up to that of the machine. Most begin with a good point.
inline ExactSegment randomSegment(const Machine& machine, RandomBoxes& random)
{
  const auto point = [&] {
    const Box space = spaceOf(machine);
    return random.pointIn({ 0.6 * space.lower + 0.4 * machine.zero(), 0.6 * space.upper + 0.4 * machine.zero() });
  };
  const Vector3d start = machine.zero() + random.between(0.0, 0.4) * (point() - machine.zero());
  const double size = std::pow(10.0, random.between(-2.0, 0.3));
  if (random.between(0.0, 1.0) < 0.5)
    return exactLine(start, start + size * (point() - start));
  const double lift = random.between(0.0, 1.0) < 0.5 ? 0.0 : size * machine.scale() * random.between(-1.0, 1.0);
  const Box cube{ Vector3d::Constant(-1.0), Vector3d::Constant(1.0) };
  return exactArc(start, point(), random.pointIn(cube), size * random.between(-6.0, 6.0), lift);
}

/// Hands out random segments of which the start is good, or any.
template <class Check>
inline void forEachSegment(unsigned seed, int count, const Check& check)
{
  for (const Question& question : everyQuestion())
  {
    const PointEvaluator evaluator(question.machine, question.criterion);
    const Oracle oracle(question.machine, question.criterion);
    RandomBoxes random(seed);
    for (int k = 0; k < cases(count) && !testing::Test::HasFailure(); ++k)
    {
      SCOPED_TRACE(question.machine.name() + ", seed " + std::to_string(seed) + ", case " + std::to_string(k));
      check(evaluator, oracle, randomSegment(question.machine, random), random);
    }
  }
}

}  // namespace test
}  // namespace pkm_workspace
