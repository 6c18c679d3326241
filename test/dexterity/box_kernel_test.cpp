// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/dexterity/box_kernel.h"

#include <gtest/gtest.h>

#include "support/cases.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"
#include "support/same_bits.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
constexpr std::size_t MOST = 9;  // boxes at a time: more than two packs of 4

/// A machine and what is asked of it.
struct Question
{
  Machine machine;
  Criterion criterion;

  std::string text() const { return machine.name() + ", " + describe(criterion) + ", seed " + std::to_string(SEED); }
};

/// Every kind of bounds on the factors.
std::vector<Criterion> everyBound()
{
  std::vector<Criterion> criteria(4);
  for (std::size_t k = 1; k < 4; ++k)
    criteria[k].set = Criterion::Set::REACHABLE;
  criteria[2].kappa_max = 6.0;
  criteria[3].force_max = 2.5;
  return criteria;
}

/// Every machine with and without joint limits, all bounds, and all aspects.
std::vector<Question> everyQuestion()
{
  std::vector<Question> questions;
  for (const Machine& machine : everyKind())
    for (const bool joint_limits : { false, true })
      for (Criterion criterion : everyBound())
        for (const auto aspect : { Criterion::Aspect::OWN, Criterion::Aspect::OTHER, Criterion::Aspect::BOTH })
        {
          criterion.aspect = aspect;
          criterion.joint_limits = joint_limits;
          questions.push_back({ joint_limits ? limited(machine) : machine, criterion });
        }
  return questions;
}

/// Hands each question, its model and its kernels to @p check.
template <class Check>
void forEachQuestion(const Check& check)
{
  for (const Question& question : everyQuestion())
  {
    SCOPED_TRACE(question.text());
    const MachineModel<double> model(question.machine, question.criterion);
    check(question, model, boxKernels(model));
    if (testing::Test::HasFailure())
      return;
  }
}

/// Some wide boxes, some small ones and some points.
std::vector<Box> randomBoxes(const Machine& machine, RandomBoxes& random)
{
  std::vector<Box> boxes;
  while (boxes.size() < MOST)
    boxes.push_back(random.boxIn(spaceOf(machine), boxes.size() % 3 == 2 ? 0.0 : machine.scale()));
  return boxes;
}

/// Every other one has a part that does not grow with the size.
std::vector<GrowingVector> randomOffsets(RandomBoxes& random)
{
  const Box cube{ Eigen::Vector3d::Constant(-1.0), Eigen::Vector3d::Constant(1.0) };
  std::vector<GrowingVector> offsets(1, scaling(Eigen::Vector3d::Zero()));
  while (offsets.size() < MOST)
    offsets.push_back({ (offsets.size() % 2) * 0.2 * random.pointIn(cube), random.pointIn(cube) });
  return offsets;
}

/// Calls @p compute(kernel, first, count, results) for the last @p count of MOST items and compares: the item at place
/// i has to get what the narrow kernel says of it alone, and nothing is written behind the last.
template <class Result, class Compute, class Compare>
void expectSameInEveryBatch(const std::vector<std::unique_ptr<const BoxKernel>>& kernels, const Result& untouched,
                            const Compute& compute, const Compare& compare)
{
  std::vector<Result> alone(MOST, untouched);
  for (std::size_t i = 0; i < MOST; ++i)
    compute(*kernels.back(), i, 1, &alone[i]);
  for (const auto& kernel : kernels)
    for (std::size_t count = 1; count <= MOST; ++count)
    {
      SCOPED_TRACE("width " + std::to_string(kernel->width()) + ", count " + std::to_string(count));
      std::vector<Result> results(count + 1, untouched);
      compute(*kernel, MOST - count, count, results.data());
      for (std::size_t i = 0; i < count; ++i)
        compare(results[i], alone[MOST - count + i]);
      compare(results[count], untouched);
    }
}

void expectSameForm(const AffineForm<double>& a, const AffineForm<double>& b)
{
  EXPECT_TRUE(sameBits(a.center, b.center));
  EXPECT_TRUE(sameBits(a.radius, b.radius));
  for (std::size_t j = 0; j < 3; ++j)
    EXPECT_TRUE(sameBits(a.gradient[j], b.gradient[j]));
}

void expectSameForms(const NecessaryForms& a, const NecessaryForms& b)
{
  EXPECT_EQ(a.violated, b.violated);
  ASSERT_EQ(a.matrices, b.matrices);
  ASSERT_EQ(a.forms, b.forms);
  for (std::size_t m = 0; m < a.matrix.size(); ++m)
    for (std::size_t entry = 0; entry < 6; ++entry)
      expectSameForm(a.matrix[m][entry], b.matrix[m][entry]);
  for (std::size_t i = 0; i < a.form.size(); ++i)
    expectSameForm(a.form[i], b.form[i]);
}

/// Finds what the forms of small moved boxes say at points that the oracle knows, often next to the border of the set.
class NecessityCheck
{
public:
  NecessityCheck(const Question& question, const BoxKernel& kernel)
    : machine_(question.machine), oracle_(question.machine, question.criterion), kernel_(kernel), random_(SEED)
  {}

  void tryOneBox()
  {
    const double scale = machine_.scale();
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(random_.between(0.0, 1.0) * scale);
    centers_ = CenteredBox<double>(random_.boxIn({ machine_.zero() - reach, machine_.zero() + reach }, scale));
    size_ = random_.between(0.0, 0.4 * scale);
    const auto offsets = randomOffsets(random_);
    std::vector<NecessaryForms> results(MOST);
    kernel_.necessaryForms(centers_, size_, offsets.data(), MOST, results.data());
    for (std::size_t i = 0; i < MOST; ++i)
      tryOneMove(offsets[i], results[i]);
  }

  int good() const { return good_; }
  int refused() const { return refused_; }

private:
  using Number = Oracle::Number;
  using Delta = std::array<double, 3>;

  Delta anyDelta() { return { random_.between(-1.0, 1.0), random_.between(-1.0, 1.0), random_.between(-1.0, 1.0) }; }

  bool isGood(const GrowingVector& offset, const Delta& delta) const
  {
    Oracle::Vector point;
    for (std::size_t k = 0; k < 3; ++k)
      point[k] = centers_.center[k] + Number(centers_.half_widths[k]) * delta[k] + offset.fixed.data()[k] +
                 Number(size_) * offset.per_size.data()[k];
    return oracle_.isGood(point);
  }

  /// Tries two points; if only one of them is good, it is first moved next to the border.
  void tryOneMove(const GrowingVector& offset, const NecessaryForms& forms)
  {
    Delta a = anyDelta(), b = anyDelta();
    const bool is_a_good = isGood(offset, a), is_b_good = isGood(offset, b);
    for (int step = 0; step < 20 && is_a_good != is_b_good; ++step)
    {
      const Delta middle = { (a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0, (a[2] + b[2]) / 2.0 };
      (isGood(offset, middle) == is_a_good ? a : b) = middle;
    }
    tryOnePoint(forms, a, is_a_good);
    tryOnePoint(forms, b, is_b_good);
  }

  void tryOnePoint(const NecessaryForms& forms, const Delta& delta, bool is_good)
  {
    bool refuses = forms.violated;
    for (std::size_t i = 0; i < forms.forms; ++i)
      refuses = refuses || highest(forms.form[i], delta) < 0;
    for (std::size_t m = 0; m < forms.matrices; ++m)
      refuses = refuses ||
                highest(quadraticForm(forms.matrix[m], leastEigenvector(forms.matrix[m], delta).vector), delta) < 0;
    good_ += is_good;
    refused_ += refuses;
    EXPECT_FALSE(is_good && refuses) << centers_.center[0] << " " << centers_.center[1] << " " << centers_.center[2];
  }

  /// The largest value of a member at delta.
  static Number highest(const AffineForm<double>& f, const Delta& delta)
  {
    return f.center + Number(f.gradient[0]) * delta[0] + Number(f.gradient[1]) * delta[1] +
           Number(f.gradient[2]) * delta[2] + f.radius;
  }

  Machine machine_;
  Oracle oracle_;
  const BoxKernel& kernel_;
  RandomBoxes random_;
  CenteredBox<double> centers_;
  double size_ = 0.0;
  int good_ = 0;
  int refused_ = 0;
};

TEST(BoxKernels, narrowOneIsAlwaysThereAndTheLast)
{
  const auto kernels = boxKernels(MachineModel<double>(orthoglide(), Criterion()));
  ASSERT_FALSE(kernels.empty());
  EXPECT_EQ(kernels.back()->width(), 2u);
  for (std::size_t k = 1; k < kernels.size(); ++k)
    EXPECT_GT(kernels[k - 1]->width(), kernels[k]->width());
}

TEST(BoxKernels, verdictsAreTheSameInEveryBatch)
{
  forEachQuestion([](const Question& question, const MachineModel<double>&, const auto& kernels) {
    RandomBoxes random(SEED);
    for (int k = 0; k < cases(20); ++k)
    {
      const auto boxes = randomBoxes(question.machine, random);
      const auto classify = [&](const BoxKernel& kernel, std::size_t first, std::size_t count, BoxVerdict* verdicts) {
        kernel.classify(&boxes[first], count, verdicts);
      };
      expectSameInEveryBatch(kernels, static_cast<BoxVerdict>(77), classify,
                             [](BoxVerdict a, BoxVerdict b) { ASSERT_EQ(static_cast<int>(a), static_cast<int>(b)); });
    }
  });
}

TEST(BoxKernels, necessaryFormsAreTheSameInEveryBatch)
{
  forEachQuestion([](const Question& question, const MachineModel<double>&, const auto& kernels) {
    RandomBoxes random(SEED);
    NecessaryForms untouched;
    untouched.forms = 77;
    untouched.form[0].center = 77.0;
    for (int k = 0; k < cases(5); ++k)
    {
      const CenteredBox<double> centers(random.boxIn(spaceOf(question.machine), 0.5 * question.machine.scale()));
      const double size = random.between(0.0, question.machine.scale());
      const auto offsets = randomOffsets(random);
      const auto collect = [&](const BoxKernel& kernel, std::size_t first, std::size_t count, NecessaryForms* results) {
        kernel.necessaryForms(centers, size, &offsets[first], count, results);
      };
      expectSameInEveryBatch(kernels, untouched, collect, expectSameForms);
    }
  });
}

TEST(BoxKernels, marginsAreThoseOfTheModel)
{
  forEachQuestion([](const Question& question, const MachineModel<double>& model, const auto& kernels) {
    RandomBoxes random(SEED);
    for (int k = 0; k < cases(10); ++k)
    {
      const Eigen::Vector3d center = k == 0 ? question.machine.zero() : random.pointIn(spaceOf(question.machine));
      const double size = k == 0 ? 0.0 : random.between(0.0, question.machine.scale());
      const std::vector<Eigen::Vector3d> points = pointsOf(randomOffsets(random), center, size);
      const auto compute = [&](const BoxKernel& kernel, std::size_t first, std::size_t count, double* results) {
        kernel.margins(&points[first], count, results);
      };
      expectSameInEveryBatch(kernels, 77.0, compute, [](double a, double b) { ASSERT_TRUE(sameBits(a, b)); });
      double margins[MOST];
      kernels.back()->margins(points.data(), MOST, margins);
      for (std::size_t i = 0; i < MOST; ++i)
      {
        const Eigen::Vector3d& p = points[i];
        ASSERT_TRUE(sameBits(margins[i], model.margin({ p.x(), p.y(), p.z() }))) << p.transpose();
        ASSERT_TRUE(std::isfinite(margins[i])) << p.transpose();
      }
    }
  });
}

TEST(BoxKernels, necessaryFormsAreNotNegativeAtGoodPoints)
{
  forEachQuestion([](const Question& question, const MachineModel<double>&, const auto& kernels) {
    NecessityCheck check(question, *kernels.front());
    for (int k = 0; k < cases(50); ++k)
      check.tryOneBox();
    const bool is_all = question.machine.name() == "tripod" && !question.criterion.boundsFactors();
    EXPECT_TRUE(is_all || check.refused() > 10) << "the forms say nothing: " << check.refused();
    if (question.criterion.aspect != Criterion::Aspect::OTHER)
    {
      EXPECT_GT(check.good(), 5) << "the law was hardly tried";
    }
  });
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
