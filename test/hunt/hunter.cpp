// SPDX-License-Identifier: BSD-3-Clause
#include "hunt/hunter.h"

#include <cmath>
#include <sstream>

#include "pkm_workspace/region/containment.h"
#include "support/cases.h"
#include "support/machines.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
std::string inWords(const Eigen::Vector3d& v)
{
  std::ostringstream text;
  text.precision(17);
  text << v.x() << " " << v.y() << " " << v.z();
  return text.str();
}

/// The double of the box that is at u.
Eigen::Vector3d pointOf(const Box& box, const Eigen::Vector3d& u)
{
  const Eigen::Vector3d share = 0.5 * (u + Eigen::Vector3d::Ones());
  return (box.lower + share.cwiseProduct(box.upper - box.lower)).cwiseMax(box.lower).cwiseMin(box.upper);
}
}  // namespace

Hunter::Hunter(const Subject& subject, Random& random, Tally& tally)
  : subject_(subject)
  , random_(random)
  , tally_(tally)
  , test_(subject.machine, subject.criterion)
  , oracle_(subject.machine, subject.criterion)
  , scale_(subject.machine.scale())
{}

void Hunter::expectAt(const Vector& point, bool is_good, const std::string& claim) const
{
  if (oracle_.isGood(point) != is_good)
    throw Contradiction(claim + ", but the point " + inWords(point) + (is_good ? " is bad" : " is good") +
                        " by the definition, in 100 digits");
}

double Hunter::margin(const Vector& point) const
{
  const double margin = test_.margin(point);
  return std::isfinite(margin) ? margin : margin > 0.0 ? 1e9 : -1e9;
}

Hunter::Vector Hunter::anyPoint()
{
  const Box space = spaceOf(subject_.machine);
  return pointOf(space, anyOffset());
}

Hunter::Vector Hunter::borderPoint()
{
  Vector good = subject_.machine.zero();
  for (int k = 0; k < 30 && (k == 0 || margin(good) < 0.0); ++k)
    good = k == 0 && random_.once(2) ? good : anyPoint();
  Vector bad = anyPoint();
  for (int k = 0; k < 10 && margin(bad) >= 0.0; ++k)
    bad = anyPoint();
  if (margin(good) < 0.0 || margin(bad) >= 0.0)
    return bad;
  for (int k = 0; k < 50; ++k)
  {
    const Vector middle = 0.5 * (good + bad);
    (margin(middle) >= 0.0 ? good : bad) = middle;
  }
  return good;
}

Hunter::Vector Hunter::corner()
{
  return { random_.sign(), random_.sign(), random_.sign() };
}

Hunter::Vector Hunter::anyOffset()
{
  return { random_.uniform(-1.0, 1.0), random_.uniform(-1.0, 1.0), random_.uniform(-1.0, 1.0) };
}

Hunter::Vector Hunter::descend(const Guide& guide, Vector from) const
{
  double least = guide(from);
  for (double step = 0.5; step > 1e-4;)
  {
    bool is_better = false;
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : { -step, step })
      {
        Vector next = from;
        next[axis] = std::min(1.0, std::max(-1.0, next[axis] + side));
        const double value = guide(next);
        if (value < least)
        {
          least = value;
          from = next;
          is_better = true;
        }
      }
    step = is_better ? step : 0.5 * step;
  }
  return from;
}

void Hunter::huntBoxes(int count)
{
  for (int k = 0; k < count; ++k)
  {
    const double width = scale_ * std::pow(10.0, random_.uniform(-8.0, -0.3));
    Vector half = width * 0.5 * (anyOffset() + Vector::Ones());
    if (random_.once(5))
      half[random_.integer(0, 2)] = 0.0;
    const Vector center = (random_.once(8) ? anyPoint() : borderPoint()) + random_.uniform(0.0, 2.5) * width * corner();
    const Box box{ center - half, center + half };
    const BoxVerdict verdict = test_.classify(box);
    ++tally_[verdict == BoxVerdict::INSIDE    ? "boxes inside"
             : verdict == BoxVerdict::OUTSIDE ? "boxes outside"
                                              : "boxes undecided"];
    if (verdict == BoxVerdict::UNDECIDED)
      continue;
    const bool is_inside = verdict == BoxVerdict::INSIDE;
    const std::string claim = "the box from " + inWords(box.lower) + " to " + inWords(box.upper) +
                              " was proved to be " + (is_inside ? "inside" : "outside");
    const auto guide = [&](const Vector& u) { return (is_inside ? 1.0 : -1.0) * margin(pointOf(box, u)); };
    for (const Vector& start : { Vector(Vector::Zero()), corner() })
      expectAt(pointOf(box, descend(guide, start)), is_inside, claim);
    for (const Vector& u : { corner(), corner(), anyOffset() })
      expectAt(pointOf(box, u), is_inside, claim);
  }
}

void Hunter::expectGoodRegion(const Body& body, const Vector& center, double size, const std::string& claim)
{
  const auto expectAtOffset = [&](const Vector& u) {
    if (const auto point = body.pointAt(u, center, size))
      expectAt(*point, true, claim);
  };
  const auto guide = [&](const Vector& u) { return margin(body.place(u, center, size)); };
  for (int k = 0; k < 4; ++k)
    expectAtOffset(descend(guide, k == 0 ? Vector(Vector::Zero()) : k < 3 ? corner() : anyOffset()));
  for (int k = 0; k < 8; ++k)
    expectAtOffset({ k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0 });
  for (int k = 0; k < 12; ++k)
  {
    Vector u = anyOffset();
    u[random_.integer(0, 2)] = random_.sign();
    expectAtOffset(u);
  }
}

void Hunter::huntContainments(int count)
{
  for (int k = 0; k < count; ++k)
  {
    const Body body = drawnBody(random_, scale_);
    RegionQuery query;
    setShape(body.wish, query);
    const double size = scale_ * std::pow(10.0, random_.uniform(-2.5, 0.0));
    const Vector center =
        subject_.machine.zero() + random_.uniform(0.0, 1.0) * (borderPoint() - subject_.machine.zero());
    Budget budget;
    budget.threads = 1;
    budget.max_boxes = static_cast<std::int64_t>(std::pow(10.0, random_.uniform(0.5, 3.5)));
    const ContainmentResult result = checkContainment(test_, *query.shape, center, size, budget);
    const std::string claim = "the " + query.shape->name() + " of size " + std::to_string(size) + " at " +
                              inWords(center) + " was proved to be ";
    ++tally_[result.verdict == Containment::INSIDE    ? "regions inside"
             : result.verdict == Containment::OUTSIDE ? "regions outside"
                                                      : "regions undecided"];
    if (result.verdict == Containment::INSIDE)
      expectGoodRegion(body, center, size, claim + "inside");
    if (result.verdict != Containment::OUTSIDE || result.bad_within > 0.0)
      continue;
    expectAt(*result.bad_point, false, claim + "outside");
    if (!body.holds(*result.bad_point, center, size))
      throw Contradiction(claim + "outside, but it has not its bad point " + inWords(*result.bad_point));
  }
}
}  // namespace test
}  // namespace pkm_workspace
