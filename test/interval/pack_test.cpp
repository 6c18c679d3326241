// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/pack.h"

#include <gtest/gtest.h>

#include <vector>

#include "pkm_workspace/interval/definiteness.h"
#include "support/forms.h"
#include "support/mode_and_spread.h"
#include "support/same_bits.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Pair = Pack<2>;

Pair together(double first, double second)
{
  const double values[] = { first, second };
  return Pair::load(values);
}

AffineForm<Pair> together(const Form& a, const Form& b)
{
  return { together(a.center, b.center),
           { together(a.gradient[0], b.gradient[0]), together(a.gradient[1], b.gradient[1]),
             together(a.gradient[2], b.gradient[2]) },
           together(a.radius, b.radius) };
}

Enclosed<Pair> together(const Enclosed<double>& a, const Enclosed<double>& b)
{
  return { together(a.value, b.value), together(a.radius, b.radius) };
}

template <class Real>
using Named = std::vector<std::pair<std::string, Real>>;

/// Fails unless each number of a pack is bit for bit that of the lane's own computation.
void expectLanes(const Named<Pair>& got, const std::array<Named<double>, 2>& wanted)
{
  for (std::size_t lane = 0; lane < 2; ++lane)
  {
    ASSERT_EQ(got.size(), wanted[lane].size());
    for (std::size_t k = 0; k < got.size(); ++k)
      ASSERT_TRUE(sameBits(got[k].second[static_cast<int>(lane)], wanted[lane][k].second))
          << got[k].first << " in lane " << lane;
  }
}

/// What a pair of numbers can be put to.
template <class Real>
Named<Real> operations(const Real& a, const Real& b)
{
  using std::max;
  using std::min;
  using std::sqrt;
  return { { "-a", -a },
           { "a + b", a + b },
           { "a - b", a - b },
           { "a * b", a * b },
           { "a / b", a / b },
           { "min(a, b)", min(a, b) },
           { "max(a, b)", max(a, b) },
           { "sqrt(a)", sqrt(a) },
           { "a < b", select(a < b, a, b) },
           { "a > b", select(a > b, a, b) },
           { "a >= b", select(a >= b, a, b) },
           { "not a < b", select(!(a < b), a, b) } };
}

class PackLanes : public ModeAndSpread
{
protected:
  /// A number of the spread, or one that no spread has.
  static double anyNumber(Operands& operands, Random& random)
  {
    constexpr double SPECIAL[] = { INF, -INF, std::numeric_limits<double>::quiet_NaN(), 0.0, -0.0 };
    return random.once(6) ? SPECIAL[random.integer(0, 4)] : operands.number();
  }

  /// Hands two pairs of numbers, a and b for each lane, to @p check until one fails.
  template <class Check>
  void forEachPair(const Check& check)
  {
    for (int seed = 0; seed < cases(1000) && !HasFailure(); ++seed)
    {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Operands numbers = operands(seed);
      Random random(static_cast<std::uint64_t>(seed));
      const auto any = [&] { return anyNumber(numbers, random); };
      const std::array<double, 2> a = { any(), any() };
      const auto partner = [&](double x) { return random.once(8) ? x : random.once(2) ? numbers.partner(x) : any(); };
      check(a, { partner(a[0]), partner(a[1]) });
    }
  }
};

TEST_P(PackLanes, operationsAreThoseOfDouble)
{
  forEachPair([this](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    const auto wanted = [&](std::size_t lane) {
      return under<Named<double>>(mode(), [&] { return operations(a[lane], b[lane]); });
    };
    expectLanes(under<Named<Pair>>(mode(), [&] { return operations(together(a[0], a[1]), together(b[0], b[1])); }),
                { wanted(0), wanted(1) });
  });
}

TEST_P(PackLanes, oneNumberFillsAllLanes)
{
  forEachPair([this](const std::array<double, 2>& a, const std::array<double, 2>&) {
    const Pair filled = under<Pair>(mode(), [&] { return Pair(a[0]); });
    for (const int lane : { 0, 1 })
      ASSERT_TRUE(sameBits(filled[lane], a[0]));
  });
}

TEST_P(PackLanes, absoluteValuesAreThoseOfDouble)
{
  forEachPair([this](const std::array<double, 2>& a, const std::array<double, 2>&) {
    const Pair got = under<Pair>(mode(), [&] { return abs(together(a[0], a[1])); });
    for (const int lane : { 0, 1 })
      ASSERT_TRUE(sameBits(got[lane], std::abs(a[static_cast<std::size_t>(lane)])));
  });
}

INSTANTIATE_TEST_SUITE_P(All, PackLanes, everyRoundingModeAndSpread(), nameOf);

TEST(PackMasks, combineLaneForLane)
{
  for (int bits = 0; bits < 16; ++bits)
  {
    const bool a[] = { (bits & 1) != 0, (bits & 2) != 0 };
    const bool b[] = { (bits & 4) != 0, (bits & 8) != 0 };
    const auto first = together(a[0], a[1]) > Pair(0.5);
    const auto second = together(b[0], b[1]) > Pair(0.5);
    for (const int lane : { 0, 1 })
    {
      EXPECT_EQ(first[lane], a[lane]) << bits;
      EXPECT_EQ((first & second)[lane], a[lane] && b[lane]) << bits;
      EXPECT_EQ((first | second)[lane], a[lane] || b[lane]) << bits;
      EXPECT_EQ((!first)[lane], !a[lane]) << bits;
      EXPECT_EQ(select(first, Pair(1.0), Pair(2.0))[lane], a[lane] ? 1.0 : 2.0) << bits;
    }
    EXPECT_EQ(any(first), a[0] || a[1]) << bits;
  }
}

template <class Real>
void append(const std::string& name, const AffineForm<Real>& f, Named<Real>& numbers)
{
  numbers.insert(numbers.end(), { { "center of " + name, f.center },
                                  { "radius of " + name, f.radius },
                                  { "lower bound of " + name, f.lower() },
                                  { "upper bound of " + name, f.upper() } });
  for (const Real& slope : f.gradient)
    numbers.emplace_back("gradient of " + name, slope);
}

/// What two forms, a constant and a floor can be put to.
template <class Real>
Named<Real> operations(const AffineForm<Real>& f, const AffineForm<Real>& g, const Enclosed<Real>& s, const Real& floor)
{
  Named<Real> numbers;
  append("-f", -f, numbers);
  append("f + g", f + g, numbers);
  append("f - g", f - g, numbers);
  append("f * g", f * g, numbers);
  append("f + s", f + s, numbers);
  append("s * f", s * f, numbers);
  append("sqrt(f)", sqrtAbove(f, floor), numbers);
  return numbers;
}

/// The operands of one lane.
struct FormOperands
{
  explicit FormOperands(std::uint64_t seed) : forms(seed) {}

  Forms forms;
  Form f = forms.form();
  Form g = forms.form(&f);
  Enclosed<double> s{ forms.number(), forms.error() };
  double floor = std::abs(forms.number());
};

TEST(PackForms, operationsAreThoseOfDouble)
{
  for (int seed = 0; seed < cases(1000) && !testing::Test::HasFailure(); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const FormOperands a(static_cast<std::uint64_t>(2 * seed));
    const FormOperands b(static_cast<std::uint64_t>(2 * seed + 1));
    expectLanes(operations(together(a.f, b.f), together(a.g, b.g), together(a.s, b.s), together(a.floor, b.floor)),
                { operations(a.f, a.g, a.s, a.floor), operations(b.f, b.g, b.s, b.floor) });
  }
}

/// Definite or not, about as often.
SymmetricForms<double> randomMatrix(Random& random)
{
  SymmetricForms<double> m;
  for (std::size_t k = 0; k < 6; ++k)
  {
    m[k].center = k < 3 ? random.uniform(0.5, 2.0) : random.uniform(-0.7, 0.7);
    for (auto& slope : m[k].gradient)
      slope = random.uniform(-0.1, 0.1);
    m[k].radius = random.uniform(0.0, 0.05);
  }
  return m;
}

TEST(PackForms, matricesAreDefiniteLaneForLane)
{
  int definite = 0;
  const int tries = cases(1000);
  for (int seed = 0; seed < tries; ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed));
    const SymmetricForms<double> lanes[] = { randomMatrix(random), randomMatrix(random) };
    SymmetricForms<Pair> both;
    for (std::size_t k = 0; k < 6; ++k)
      both[k] = together(lanes[0][k], lanes[1][k]);
    const auto got = isPositiveDefinite(both);
    for (const int lane : { 0, 1 })
      ASSERT_EQ(got[lane], isPositiveDefinite(lanes[lane])) << "seed " << seed << ", lane " << lane;
    definite += got[0];
  }
  EXPECT_GT(definite, tries / 10);
  EXPECT_LT(definite, tries * 9 / 10);
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
