// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mpfi.h>

#include <array>
#include <cmath>
#include <iterator>

#include "pkm_workspace/interval/interval.h"
#include "support/mode_and_spread.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// A set of MPFI's with the digits of doubles, so that what it rounds outward is as tight as doubles allow.
class MpfiSet
{
public:
  MpfiSet() { mpfi_init2(x_, 53); }
  MpfiSet(const MpfiSet&) = delete;
  MpfiSet& operator=(const MpfiSet&) = delete;
  ~MpfiSet() { mpfi_clear(x_); }

  void set(const Interval& x) { mpfi_interv_d(x_, x.lower(), x.upper()); }
  mpfi_ptr get() { return x_; }
  double lower() const { return mpfr_get_d(&x_->left, MPFR_RNDD); }
  double upper() const { return mpfr_get_d(&x_->right, MPFR_RNDU); }

private:
  mpfi_t x_;
};

bool anything(const Interval&, const Interval&)
{
  return true;
}

bool firstIsOneNumber(const Interval& x, const Interval&)
{
  return x.isSingle();
}

/// One of the library's operations on one or two sets, MPFI's, and where it is defined.
struct ScalarOperation
{
  const char* name;
  Interval (*evaluate)(const Interval&, const Interval&);
  void (*exact)(mpfi_ptr result, mpfi_ptr x, mpfi_ptr y);
  bool (*isDefined)(const Interval& x, const Interval& y) = anything;
};

const ScalarOperation ALGEBRAIC[] = {
  { "+", [](const Interval& x, const Interval& y) { return x + y; },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr y) { mpfi_add(r, x, y); } },
  { "-", [](const Interval& x, const Interval& y) { return x - y; },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr y) { mpfi_sub(r, x, y); } },
  { "*", [](const Interval& x, const Interval& y) { return x * y; },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr y) { mpfi_mul(r, x, y); } },
  { "/", [](const Interval& x, const Interval& y) { return x / y; },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr y) { mpfi_div(r, x, y); },
    [](const Interval&, const Interval& y) { return !y.contains(0.0); } },
  { "neg", [](const Interval& x, const Interval&) { return -x; },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr) { mpfi_neg(r, x); } },
  { "abs", [](const Interval& x, const Interval&) { return abs(x); },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr) { mpfi_abs(r, x); } },
  { "sqr", [](const Interval& x, const Interval&) { return sqr(x); },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr) { mpfi_sqr(r, x); } },
  { "sqrt", [](const Interval& x, const Interval&) { return sqrt(x); },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr) { mpfi_sqrt(r, x); },
    [](const Interval& x, const Interval&) { return x.lower() >= 0.0; } },
  { "sqrtAboveZero", [](const Interval& x, const Interval&) { return sqrtAboveZero(x); },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr) {
      mpfr_set_d(&r->left, 0.0, MPFR_RNDN);
      mpfr_set_d(&r->right, INFINITY, MPFR_RNDN);
      mpfi_intersect(r, r, x);
      mpfi_sqrt(r, r);
    },
    [](const Interval& x, const Interval&) { return x.upper() >= 0.0; } },
  { "hull", [](const Interval& x, const Interval& y) { return hull(x, y); },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr y) { mpfi_union(r, x, y); } },
  { "intersection", [](const Interval& x, const Interval& y) { return intersection(x, y); },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr y) { mpfi_intersect(r, x, y); },
    [](const Interval& x, const Interval& y) { return x.intersects(y); } },
};

const ScalarOperation OF_ANGLES[] = {
  { "sin", [](const Interval& x, const Interval&) { return sin(x.lower()); },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr) { mpfi_sin(r, x); }, firstIsOneNumber },
  { "cos", [](const Interval& x, const Interval&) { return cos(x.lower()); },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr) { mpfi_cos(r, x); }, firstIsOneNumber },
  { "acos", [](const Interval& x, const Interval&) { return acos(x); },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr) {
      mpfi_interv_d(r, -1.0, 1.0);
      mpfi_intersect(r, r, x);
      mpfi_acos(r, r);
    },
    [](const Interval& x, const Interval&) { return x.intersects(Interval(-1.0, 1.0)); } },
  { "angleOf", [](const Interval& x, const Interval& y) { return angleOf(x, y); },
    [](mpfi_ptr r, mpfi_ptr x, mpfi_ptr y) { mpfi_atan2(r, y, x); },
    [](const Interval& x, const Interval& y) { return !(x.lower() <= 0.0 && y.contains(0.0)); } },
};

/// An end in sixteen is left out.
Interval withoutSomeEnds(const Interval& set, Random& random)
{
  return Interval(random.once(16) ? -INF : set.lower(), random.once(16) ? INF : set.upper());
}

/// The library's result has to be MPFI's, rounded to doubles: it contains it, and is no wider.
testing::AssertionResult isMpfiResult(const Interval& got, const ScalarOperation& operation, const MpfiSet& exact)
{
  const bool contains = got.lower() <= exact.lower() && exact.upper() <= got.upper();
  const bool is_tight = got.lower() == exact.lower() && got.upper() == exact.upper();
  if (contains && (is_tight || !rounding::SOUND))
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << operation.name << " = " << got
                                     << (contains ? " is wider than [" : " lacks of [") << exact.lower() << ", "
                                     << exact.upper() << "]";
}

/// All operations on the same operands, under one mode.
template <std::size_t N>
void expectMpfiResults(const ScalarOperation (&operations)[N], const RoundingMode& mode, const Interval& x,
                       const Interval& y, MpfiSet (&sets)[3])
{
  bool is_defined[N];
  for (std::size_t i = 0; i < N; ++i)
    is_defined[i] = operations[i].isDefined(x, y);
  const auto got = under<std::array<Interval, N>>(mode, [&] {
    std::array<Interval, N> results;
    for (std::size_t i = 0; i < N; ++i)
      if (is_defined[i])
        results[i] = operations[i].evaluate(x, y);
    return results;
  });
  sets[0].set(x);
  sets[1].set(y);
  for (std::size_t i = 0; i < N; ++i)
    if (is_defined[i])
    {
      operations[i].exact(sets[2].get(), sets[0].get(), sets[1].get());
      ASSERT_TRUE(isMpfiResult(got[i], operations[i], sets[2])) << "of " << x << " and " << y << ", " << mode;
    }
}

/// On @p count operands, as many of each spread under each mode.
template <std::size_t N>
void expectMpfiResults(const ScalarOperation (&operations)[N], int count)
{
  constexpr int KINDS = std::size(MODES) * std::size(SPREADS);
  MpfiSet sets[3];
  for (const auto& mode : MODES)
    for (const auto& spread : SPREADS)
    {
      Operands operands(spread, SEED);
      Random random(SEED);
      for (int i = 0; i < count / KINDS + 1; ++i)
      {
        const Interval x = operands.interval();
        const Interval y = operands.partner(x);
        expectMpfiResults(operations, mode, withoutSomeEnds(x, random), withoutSomeEnds(y, random), sets);
        ASSERT_FALSE(testing::Test::HasFailure()) << spread << " from seed " << SEED << ", case " << i;
      }
    }
}

TEST(IntervalAgainstMpfi, algebraicOperationsOnAMillionOperands)
{
  expectMpfiResults(ALGEBRAIC, cases(1000000));
}

TEST(IntervalAgainstMpfi, functionsOfAnglesOnAHundredThousandOperandsOrAMillionInTheLongForm)
{
  expectMpfiResults(OF_ANGLES, cases(100000));
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
