// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/machine/crank.h"

#include <algorithm>
#include <cmath>

#include "numbers.h"
#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/machine/crank_forms.h"

namespace pkm_workspace
{
namespace
{
/// u or v turned by the reference: cosine * first + sine * second.
IntervalVector turned(const IntervalVector& first, const IntervalVector& second, const Interval& cosine,
                      const Interval& sine)
{
  return cosine * first + sine * second;
}
}  // namespace

EnclosedCrank enclosed(const Crank& crank)
{
  EnclosedCrank constants;
  const Interval cosine = cos(crank.reference);
  const Interval sine = sin(crank.reference);
  const bool is_turned = crank.reference != 0.0;
  constants.identity = UNIT_MATRIX;
  constants.u = constants.row_u = is_turned ? turned(crank.along, crank.across, cosine, sine) : crank.along;
  constants.v = constants.row_v = is_turned ? turned(crank.across, crank.along, cosine, -sine) : crank.across;
  constants.center = crank.pivot - crank.platform;
  constants.radius = crank.radius;
  constants.length = crank.length;
  constants.half_per_radius = Interval(0.5) / crank.radius;
  constants.squares = (crank.radius - crank.length) * (crank.radius + crank.length);
  constants.squared_length = sqr(crank.length);
  constants.sign = Interval(crank.working_mode);
  constants.gear = crank.drive_scale > 0.0 ? crank.radius / Interval(crank.drive_scale) : Interval(1.0);
  constants.per_gear = Interval(1.0) / constants.gear;
  constants.per_scale = Interval(1.0) / driveScale(crank);
  constants.reference = crank.reference;
  return constants;
}

namespace
{
void validateDirections(const Crank& crank, const std::string& place, Problems& problems)
{
  if (!squaredNorm(crank.along).contains(1.0) || !squaredNorm(crank.across).contains(1.0))
    complain(problems, place, ": the directions of its crank must have unit length, their squared lengths are ",
             squaredNorm(crank.along), " and ", squaredNorm(crank.across));
  else if (!dot(crank.along, crank.across).contains(0.0))
    complain(problems, place, ": the directions of its crank must be across each other, their product is ",
             dot(crank.along, crank.across));
}
}  // namespace

void validate(const Crank& crank, const std::string& place, Problems& problems)
{
  if (!isBounded(crank.pivot) || !isBounded(crank.platform) || !isBounded(crank.along) || !isBounded(crank.across))
    complain(problems, place, ": pivot, directions and platform point must be finite numbers");
  else if (!isOrdinary(crank.pivot) || !isOrdinary(crank.platform))
    complain(problems, place, ": pivot and platform point must be within 1e9 m");
  else
    validateDirections(crank, place, problems);
  if (!isOrdinaryLength(crank.radius) || !crank.radius.certainlyPositive())
    complain(problems, place, ": crank radius ", crank.radius, " m must be from 1e-9 m to 1e9 m");
  if (!isOrdinaryLength(crank.length))
    complain(problems, place, ": forearm length ", crank.length, " m must be from 1e-9 m to 1e9 m");
  if (crank.working_mode != 1 && crank.working_mode != -1)
    complain(problems, place, ": working mode ", crank.working_mode, " must be +1 or -1");
  if (!(std::abs(crank.reference) <= LARGEST_TURN))
    complain(problems, place, ": reference angle ", crank.reference, " rad must be from -100 to 100 rad");
  if (crank.drive_scale != 0.0 && !isOrdinaryLength(Interval(crank.drive_scale)))
    complain(problems, place, ": drive scale ", crank.drive_scale, " m must be from 1e-9 m to 1e9 m");
}

void validateLimits(const Crank& crank, const Interval& limits, const std::string& place, Problems& problems)
{
  if (limits == Interval::entire())
    return;
  if (!limits.isBounded())
    complain(problems, place, ": the joint limits of a crank [", limits.lower(), ", ", limits.upper(),
             "] rad must have both ends, or none");
  else if (!limits.isSubsetOf(Interval(crank.reference) + Interval(-pi().lower(), pi().lower())))
    complain(problems, place, ": the joint limits of a crank [", limits.lower(), ", ", limits.upper(),
             "] rad must be within pi of its reference ", crank.reference,
             " rad; a crank that may turn all around has none");
  else if ((Interval(limits.upper()) - Interval(limits.lower())).contains(pi().lower()) &&
           (Interval(limits.upper()) - Interval(limits.lower())).contains(pi().upper()))
    complain(problems, place, ": the joint limits of a crank [", limits.lower(), ", ", limits.upper(),
             "] rad are a half turn apart to the last digit: make that a little more or less");
}

std::string exactText(const Crank& crank)
{
  return " crank mode " + std::to_string(crank.working_mode) + exactText(crank.pivot) + exactText(crank.along) +
         exactText(crank.across) + exactText(crank.radius) + exactText(crank.platform) + exactText(crank.length) +
         exactText(Interval(crank.reference)) + exactText(Interval(crank.drive_scale)) +
         exactText(static_cast<const PassiveJoints&>(crank));
}

Crank moved(const Crank& crank, const IntervalMatrix& rotation, const IntervalVector& translation)
{
  Crank result = crank;
  result.pivot = rotation * crank.pivot + translation;
  result.along = rotation * crank.along;
  result.across = rotation * crank.across;
  result.platform = rotation * crank.platform;
  turn(rotation, result);
  return result;
}

Crank between(const Crank& first, const Crank& last, const Interval& t)
{
  Crank crank = first;
  static_cast<PassiveJoints&>(crank) = between(static_cast<const PassiveJoints&>(first), last);
  for (std::size_t k = 0; k < 3; ++k)
  {
    crank.along[k] = hull(first.along[k], last.along[k]);
    crank.across[k] = hull(first.across[k], last.across[k]);
  }
  crank.pivot = between(first.pivot, last.pivot, t);
  crank.radius = between(first.radius, last.radius, t);
  crank.platform = between(first.platform, last.platform, t);
  crank.length = between(first.length, last.length, t);
  return crank;
}

std::string differenceOfModes(const Crank& first, const Crank& last)
{
  if (first.working_mode != last.working_mode)
    return "have opposite working modes";
  if (!intersects(first.along, last.along) || !intersects(first.across, last.across))
    return "have cranks that turn about different axes, or from different zeros";
  if (first.reference != last.reference || first.drive_scale != last.drive_scale)
    return "have different references or drive scales";
  return differenceOf(first, last);
}

std::string describe(const Crank& crank)
{
  TextStream text;
  text << "crank " << crank.radius.mid() << " m, forearm " << crank.length.mid() << " m";
  return text.str();
}

namespace
{
/// A lower bound of beta / L, the cosine of the angle between the forearm and the way of the tip.
double leastCosine(const EnclosedCrank& crank, const std::optional<Interval>& steepest)
{
  return steepest ? std::clamp((Interval(1.0) / (crank.gear * *steepest)).lower(), 0.0, 1.0) : 0.0;
}
/// Of that angle.
Interval largestSine(double least_cosine)
{
  return sqrtAboveZero(Interval(1.0) - sqr(Interval(least_cosine)));
}
}  // namespace

/// x is the tip r e and the forearm n: x^2 = r^2 + L^2 + 2 r e . n, where e . n is at most L times the largest sine.
OuterBound outerBound(const EnclosedCrank& crank, const std::optional<Interval>& steepest)
{
  const Interval across = crank.length * largestSine(leastCosine(crank, steepest));
  const Interval square = sqr(crank.radius) + sqr(crank.length) + Interval(2.0) * crank.radius * across;
  return { crank.identity, crank.center, sqrtAboveZero(square) };
}

/// |beta| is from L over the gear and steepest to L.
Interval driveRange(const EnclosedCrank& crank, const std::optional<Interval>& steepest)
{
  const double longest = (crank.gear * crank.length).upper();
  const double least = steepest ? (crank.length / *steepest).lower() : 0.0;
  return crank.sign * Interval(std::min(least, longest), longest);
}

Interval jointRange(const EnclosedCrank& crank, const std::optional<Interval>& /*steepest*/,
                    const std::function<Interval(const IntervalVector&)>& /*along*/)
{
  return crank.reference + Interval(-pi().upper(), pi().upper());
}

namespace
{
/// The crank's angle in so many parts.
constexpr int PARTS = 128;

/// How far forearms go that are within the largest angle of a direction, along another direction: cos of the angle
/// between the two less the largest one, or 1. @param cosine of the angle between the two
double supportOfCap(const Interval& cosine, double least_cosine)
{
  if (cosine.upper() >= least_cosine)
    return 1.0;
  const Interval z(std::max(cosine.upper(), -1.0));
  return (z * Interval(least_cosine) + sqrtAboveZero(Interval(1.0) - sqr(z)) * largestSine(least_cosine)).upper();
}
}  // namespace

/// For each part of the angle the tip, and the cap of a sphere on which forearms end that are no farther from its way
/// than the criterion leaves them. Directions turn by no more than the angle does.
IntervalVector pointsWithin(const EnclosedCrank& crank, const Interval& joints, const std::optional<Interval>& steepest)
{
  const double least_cosine = leastCosine(crank, steepest);
  const Interval turns = joints.isBounded() ? joints - crank.reference : Interval(-pi().upper(), pi().upper());
  const double part = turns.width() / PARTS;
  const Interval off = Interval(-1.0, 1.0) * Interval(0.75 * part + 1e-14);  // half of it, and its middle's rounding
  std::array<double, 3> most = { -INF, -INF, -INF };
  std::array<double, 3> back = most;  // against the axes
  for (int k = 0; k < PARTS; ++k)
  {
    const double angle = turns.lower() + (k + 0.5) * part;
    const Interval cosine = cos(angle) + off, sine = sin(angle) + off;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const Interval ahead = crank.radius * (cosine * crank.u[axis] + sine * crank.v[axis]);
      const Interval way = crank.sign * (cosine * crank.v[axis] - sine * crank.u[axis]);
      most[axis] = std::max(most[axis], (ahead + crank.length * Interval(supportOfCap(way, least_cosine))).upper());
      back[axis] = std::max(back[axis], (crank.length * Interval(supportOfCap(-way, least_cosine)) - ahead).upper());
    }
  }
  IntervalVector points;
  for (std::size_t axis = 0; axis < 3; ++axis)
    points[axis] = crank.center[axis] + Interval(-back[axis], most[axis]);
  return points;
}

LegReach reachAt(const EnclosedCrank& crank, const IntervalVector& p)
{
  LegState<Interval, IntervalVector> state;
  const CrankOffsets<Interval> x = evaluateAcross(crank, p, state);
  return { abs(x.k), sqrtAboveZero(x.m) };
}

/// The half of a sphere that is ahead of its center's way sweeps pi L^2 times that way.
Interval volumeOfJoints(const EnclosedCrank& crank, const Interval& joints)
{
  return pi() * sqr(crank.length) * crank.radius * (Interval(joints.upper()) - Interval(joints.lower()));
}

namespace
{
/// r (u cos th + v sin th), and the direction in which it moves.
std::pair<Eigen::Vector3d, Eigen::Vector3d> tipAt(const Eigen::Vector3d& u, const Eigen::Vector3d& v, double angle)
{
  return { std::cos(angle) * u + std::sin(angle) * v, std::cos(angle) * v - std::sin(angle) * u };
}
}  // namespace

LegSphere sphereAt(const EnclosedCrank& crank, double joint)
{
  const auto tip = tipAt(mid(crank.u), mid(crank.v), joint - crank.reference.mid()).first;
  return { mid(crank.center) + crank.radius.mid() * tip, crank.length.mid() };
}

Eigen::Vector3d drivenPoint(const Crank& crank, double joint)
{
  return mid(crank.pivot) + crank.radius.mid() * tipAt(mid(crank.along), mid(crank.across), joint).first;
}

bool isInMode(const EnclosedCrank& crank, double joint, const Eigen::Vector3d& row)
{
  const auto way = tipAt(mid(crank.u), mid(crank.v), joint - crank.reference.mid()).second;
  return crank.sign.mid() * row.dot(way) > 0.0;
}

bool evaluateNear(const EnclosedCrank& crank, const Eigen::Vector3d& p, LegAtPoint& leg)
{
  const PlainCrank<double> constants = plain(ofForms<double>(crank));
  const PlainVector<double> point = { p.x(), p.y(), p.z() };
  evaluate(
      constants, point, [](double x) { return std::sqrt(std::max(0.0, x)); }, leg.state);
  const auto [along, across] = tipOf(constants, point, leg.state);
  leg.joint = std::atan2(across, along) + constants.reference;
  return leg.state.squared_drive >= 0.0;
}
}  // namespace pkm_workspace
