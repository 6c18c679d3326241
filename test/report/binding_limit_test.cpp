// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/report/binding_limit.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "pkm_workspace/region/path_check.h"
#include "region/paths.h"
#include "support/definition.h"
#include "support/random.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// A sentence with what stands at its numbers.
class Claim
{
public:
  explicit Claim(const std::string& text) : text_(text) {}

  /// The phrase may have a number at each "#".
  bool says(const std::string& phrase)
  {
    const std::string number = "([-+.0-9e]+)";
    const std::regex pattern(".*" + std::regex_replace(phrase, std::regex("#"), number) + "$");
    return std::regex_match(text_, numbers_, pattern);
  }
  double number(int i) const { return std::stod(numbers_[static_cast<std::size_t>(i)]); }

private:
  std::string text_;
  std::smatch numbers_;
};

/// How the value stands to its bound, in any of the sentences: 1 above, -1 below, 0 open.
struct Reading
{
  int side = 0;
  std::optional<double> value;
  std::optional<double> distance;
  double bound = 0.0;
};

std::optional<Reading> readReach(Claim claim)
{
  if (claim.says("is # m long and would have to reach # m across its rail"))
    return Reading{ 1, claim.number(2), {}, claim.number(1) };
  if (claim.says("is # m long and reaches # m across its rail"))
    return Reading{ -1, claim.number(2), {}, claim.number(1) };
  if (claim.says("is # m long, too short to reach across its rail, by at most # m"))
    return Reading{ 1, {}, claim.number(2), claim.number(1) };
  if (claim.says("is # m long and reaches as far across its rail or less, to within # m"))
    return Reading{ -1, {}, claim.number(2), claim.number(1) };
  if (claim.says("is # m long and reaches as far across its rail, to within # m"))
    return Reading{ 0, {}, claim.number(2), claim.number(1) };
  if (claim.says("is # m long and reaches as far across its rail exactly"))
    return Reading{ 0, {}, 0.0, claim.number(1) };
  return std::nullopt;
}

/// What a crank's reach is measured by is not told.
std::optional<Reading> readReachOfCrank(Claim claim, double bound)
{
  if (claim.says("the strut of '.*' is # m long there"))  // and may be as long as that
    return Reading{ -1, {}, {}, claim.number(1) };
  if (claim.says("crank and forearm of '.*' do not reach it"))
    return Reading{ 1, {}, {}, bound };
  if (claim.says("crank and forearm of '.*' are stretched or folded, and just reach it or just do not"))
    return Reading{ 0, {}, {}, bound };
  if (claim.says("crank and forearm of '.*' reach it"))
    return Reading{ -1, {}, {}, bound };
  return std::nullopt;
}

/// @param of_limit the bound that it is about
std::optional<Reading> read(const std::string& text, double of_limit)
{
  Claim claim(text);
  if (const auto crank = readReachOfCrank(claim, of_limit))
    return crank;
  for (const std::string unit : { "", " m", " rad" })
  {
    const std::string bound = unit.empty() ? "#" : "its (?:lower|upper) limit of #" + unit;
    for (const int side : { 1, -1 })
    {
      const std::string relation = side > 0 ? "above " : "below ";
      if (claim.says(" (?:is|is at|would be at) #" + unit + ", " + relation + bound))
        return Reading{ side, claim.number(1), {}, claim.number(2) };
      if (claim.says(" (?:is|would be) " + relation + bound + ", by at most #" + unit))
        return Reading{ side, {}, claim.number(2), claim.number(1) };
      if (claim.says(" is " + relation + bound))
        return Reading{ side, {}, {}, claim.number(1) };
    }
    if (claim.says(" reaches " + bound + ", to within #" + unit))
      return Reading{ 0, {}, claim.number(2), claim.number(1) };
    if (claim.says(" reaches " + bound + " exactly"))
      return Reading{ 0, {}, 0.0, claim.number(1) };
    if (claim.says("is not known well enough to tell it from " + bound))
      return Reading{ 0, {}, {}, claim.number(1) };
  }
  return readReach(claim);
}

void expectTrue(const Limit& limit, const Machine& machine, const Oracle& oracle, const Oracle::Vector& point)
{
  const std::string text = describe(limit, machine);
  SCOPED_TRACE(text);
  if (text == "det A has the wrong sign for this aspect, beyond a parallel singularity")
  {
    EXPECT_LT(oracle.valueOf(limit, point), 0);
    return;
  }
  const auto reading = read(text, limit.bound);
  ASSERT_TRUE(reading) << "a sentence of a form that this test does not know";
  const Number exact = oracle.valueOf(limit, point);
  const Number beyond = exact - limit.bound;
  EXPECT_NEAR(reading->bound, limit.bound, 1e-8 * std::abs(limit.bound));
  EXPECT_FALSE(reading->side > 0 && beyond <= 0);
  EXPECT_FALSE(reading->side < 0 && beyond >= 0);
  if (reading->value)
  {
    EXPECT_GT(reading->side * (*reading->value - reading->bound), 0.0) << "X above X";
    EXPECT_LE(abs(exact - *reading->value), abs(exact) * 5.01e-6);
  }
  EXPECT_LE(abs(beyond), reading->distance.value_or(INFINITY));
}

void expectAllTrue(const PointEvaluator& evaluator, const Oracle& oracle, const Eigen::Vector3d& point)
{
  const PointEvaluation there = evaluator(point);
  for (const Limit& limit : there.limits)
    expectTrue(limit, evaluator.machine(), oracle, wide(point));
  EXPECT_TRUE(there.verdict != BoxVerdict::INSIDE || violations(there, evaluator.machine()).empty());
}
}  // namespace

TEST(BindingLimit, sentencesOnTheWayAcrossTheBorderAreTrue)
{
  int near = 0;
  for (const Question& question : everyQuestion())
  {
    const PointEvaluator evaluator(question.machine, question.criterion);
    const Oracle oracle(question.machine, question.criterion);
    RandomBoxes random(SEED);
    for (int k = 0; k < cases(5) && !HasFailure(); ++k)
    {
      SCOPED_TRACE(question.machine.name() + ", seed " + std::to_string(SEED) + ", case " + std::to_string(k));
      const PathSegment segment = randomSegment(question.machine, random).segment;
      expectAllTrue(evaluator, oracle, segment.point(random.between(0.0, 1.0)));
      const PathResult result = checkPath(evaluator, { segment });
      if (!result.first)
        continue;
      expectAllTrue(evaluator, oracle, result.first->point);
      expectTrue(result.first->limit, question.machine, oracle, wide(result.first->point));
      near += describe(result.first->limit, question.machine).find("is ") == std::string::npos ? 1 : 0;
      for (const double step : { -1e-3, -1e-7, 1e-13, 1e-7, 1e-3 })
        expectAllTrue(evaluator, oracle,
                      segment.point(std::clamp(result.first->bad_at.value_or(0.5) + step, 0.0, 1.0)));
    }
  }
  EXPECT_GT(near, cases(5)) << "first offences lie on the border";
}

TEST(BindingLimit, tellsValuesFromBoundsAsShortlyAsItCan)
{
  const Machine machine = limited(orthoglide());
  const auto says = [&](const Limit& limit) { return describe(limit, machine); };
  const auto at = [](Limit::Kind kind, int leg, const Interval& value, double bound, bool is_least) {
    return Limit{ kind, leg, value, bound, is_least ? value - Interval(bound) : Interval(bound) - value };
  };
  using Kind = Limit::Kind;
  const double more = std::nextafter(2.0, 3.0);
  EXPECT_EQ(says(at(Kind::PSI_MAX, -1, 2.31, 2.0, false)), "the largest velocity transmission factor is 2.31, above 2");
  EXPECT_EQ(says(at(Kind::PSI_MAX, -1, 1.5, 2.0, false)), "the largest velocity transmission factor is 1.5, below 2");
  EXPECT_EQ(says(at(Kind::PSI_MAX, -1, more, 2.0, false)),
            "the largest velocity transmission factor is above 2, by at most 4.5e-16");
  EXPECT_EQ(says(at(Kind::PSI_MAX, -1, Interval(2.0, more), 2.0, false)),
            "the largest velocity transmission factor reaches 2, to within 4.5e-16");
  EXPECT_EQ(says(at(Kind::PSI_MAX, -1, 2.0, 2.0, false)), "the largest velocity transmission factor reaches 2 exactly");
  EXPECT_EQ(says(at(Kind::REACH, 2, 0.274, 0.274, false)),
            "the strut of 'rail_z' is 0.274 m long and reaches as far across its rail exactly");
  EXPECT_EQ(says(at(Kind::PSI_MAX, -1, Interval(3.0, INFINITY), 2.0, false)),
            "the largest velocity transmission factor is above 2");
  EXPECT_EQ(says(at(Kind::JOINT_LOWER, 0, -8.67362e-17, 0.0, true)),
            "joint 'rail_x' would be below its lower limit of 0 m, by at most 8.7e-17 m");
  EXPECT_EQ(says(at(Kind::JOINT_UPPER, 1, 0.3, 0.25, false)),
            "joint 'rail_y' would be at 0.3 m, above its upper limit of 0.25 m");
  EXPECT_EQ(says(at(Kind::REACH, 2, 0.2740000000000001, 0.274, false)),
            "the strut of 'rail_z' is 0.274 m long, too short to reach across its rail, by at most 5.6e-17 m");
  EXPECT_EQ(says(at(Kind::REACH, 2, 0.5, 0.274, false)),
            "the strut of 'rail_z' is 0.274 m long and would have to reach 0.5 m across its rail");
}

/// At points where a tool has to be fast, struts have to keep their angles and factors their bounds.
TEST(BindingLimit, isToldInShortByThreeDigitsOfTheDefinition)
{
  Criterion criterion;
  criterion.joint_speed_max = { 1.0, 1.1, 1.2 };
  criterion.tool_speed_min = 0.85;
  criterion.strut_angle_max = 0.55;
  const Machine machine = orthoglide();
  const PointEvaluator evaluate(machine, criterion);
  Random random(SEED);
  const std::regex pattern(
      "(psi|tool speed|strut angle) (\\S+)( m/s| rad|), at (least|most) (\\S+) asked( \\(rail_[xyz]\\))?");
  std::set<std::string> met;
  for (int k = 0; k < 300; ++k)
  {
    const double x = random.uniform(-0.4, 0.4);
    const double y = random.uniform(-0.4, 0.4);
    const Eigen::Vector3d p(x, y, random.uniform(-0.4, 0.4));
    const PointEvaluation at = evaluate(p);
    const Limit& limit = at.binding();
    const std::string text = brief(limit, machine);
    std::smatch parts;
    ASSERT_TRUE(std::regex_match(text, parts, pattern)) << text;
    met.insert(parts[1]);
    EXPECT_EQ(parts[1] == "psi" ? "" : parts[1] == "tool speed" ? " m/s" : " rad", parts[3]) << text;
    EXPECT_EQ(parts[1] != "psi", parts[6].matched) << text;
    EXPECT_EQ(limit.bound, std::stod(parts[5])) << text;
    if (parts[1] == "psi")
      continue;
    const auto there = standing(machine, p);
    const double value = DrivenToolOf<double>(criterion, there->strut, there->eta).valueOf(limit.kind);
    EXPECT_NEAR(value, std::stod(parts[2]), 0.0051 * value) << text;
    EXPECT_EQ(value > std::stod(parts[5]), std::stod(parts[2]) > std::stod(parts[5])) << text;
  }
  EXPECT_EQ(3U, met.size());
}

TEST(BindingLimit, hasAShortNameForLegends)
{
  Criterion criterion;
  criterion.tool_speed_min = 0.4;
  criterion.position_error_max = 3e-5;
  EXPECT_EQ("tool speed at least 0.4 m/s", briefly(Limit::Kind::TOOL_SPEED_MIN, criterion));
  EXPECT_EQ("position error at most 3e-05 m", briefly(Limit::Kind::POSITION_ERROR_MAX, criterion));
  EXPECT_EQ("psi at most 2", briefly(Limit::Kind::PSI_MAX, criterion));
  EXPECT_EQ("joint lower limit", briefly(Limit::Kind::JOINT_LOWER, criterion));
  EXPECT_EQ("hinge upper limit", briefly(Limit::Kind::HINGE_UPPER, criterion));
  EXPECT_EQ("reach", briefly(Limit::Kind::REACH, criterion));
}
}  // namespace test
}  // namespace pkm_workspace
