// SPDX-License-Identifier: BSD-3-Clause
// Searches, and their bounds: the largest region, on one machine and on all within tolerances; paths.
#include <cmath>
#include <sstream>

#include "hunt/hunter.h"
#include "pkm_workspace/machine/tolerances.h"
#include "pkm_workspace/region/path_check.h"
#include "region/paths.h"
#include "support/built_machines.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
std::string inWords(const RegionQuery& query, const LargestRegion& found)
{
  std::ostringstream text;
  text.precision(17);
  text << found.shape->name() << " of size " << found.size << " at " << found.center.transpose() << ", upper bound "
       << found.size_upper_bound << ", accuracy " << query.accuracy << ", " << query.place();
  if (found.angle)
    text << ", turned by " << *found.angle;
  if (query.search_box)
    text << " (--search-box " << query.search_box->lower.transpose() << " to " << query.search_box->upper.transpose()
         << ")";
  text << "; it measures " << found.shape->halfExtents().per_size.transpose() << " times the size and "
       << found.shape->halfExtents().fixed.transpose() << " m, halved";
  return text.str();
}
}  // namespace

RegionQuery Hunter::drawnQuery(Body& body)
{
  RegionQuery query;
  query.criterion = subject_.criterion;
  query.budget.threads = 1;
  query.budget.max_boxes = random_.once(4) ? random_.integer(1, 200) : 4000;
  query.budget.time_limit = 2.0;  // for the proofs of regions, which boxes of centers do not count
  setShape(body.wish, query);
  const AccuracyRange range = accuracyRange(subject_.machine, *query.shape);
  query.accuracy = std::max(range.finest, range.coarsest * 1e-3 * std::pow(10.0, random_.uniform(-5.5, -1.5)));
  PlaceWish place;
  const Vector& zero = subject_.machine.zero();
  place.turned = body.canTurn() && random_.once(5);
  if (random_.once(4))
  {
    const Vector half = scale_ * 0.2 * (anyOffset() + Vector::Ones());
    place.search_box = Box{ zero - half, zero + half };
  }
  const bool can_stand = body.kind == Body::Kind::BOX || body.kind == Body::Kind::ROUND;
  if (can_stand && random_.once(5))
  {
    place.search_box.reset();
    place.base_z = zero.z() + 0.1 * scale_ * random_.uniform(-1.0, 1.0);
    body.stands = true;
  }
  setPlace(place, query);
  return query;
}

/// Whether no bad point of the region is found, by descents and at its corners. Where two struts, or three, become one
/// on a surface, det A is 0 there and may have one sign on both sides: what comes near to that counts as bad.
bool Hunter::isGoodRegion(const Body& body, const Vector& center, double size)
{
  const auto singularity = [&](const Vector& u) {
    const auto there = jacobians(subject_.machine, body.place(u, center, size));
    return there ? singularityMeasures(*there).parallel : 0.0;
  };
  for (int k = 0; k < 20000; ++k)  // where descents end at kinks
  {
    Vector u = anyOffset();
    u[random_.integer(0, 2)] = random_.sign();
    if (margin(body.place(u, center, size)) < -1e-9)
      return false;
  }
  try
  {
    for (int k = 0; k < 30; ++k)
    {
      expectGoodRegion(body, center, size, "");
      if (singularity(descend(singularity, anyOffset())) < 1e-6)
        return false;
    }
  }
  catch (const Contradiction&)
  {
    return false;
  }
  return true;
}

void Hunter::expectNoneLarger(Body body, const RegionQuery& query, const LargestRegion& found)
{
  const double size = found.size_upper_bound * (1.0 + 1e-9);
  std::vector<Vector> samples;
  for (int k = 0; k < 27; ++k)
    samples.push_back({ k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0 });
  const Box space = query.search_box.value_or(spaceOf(subject_.machine));
  const auto centerAt = [&](const Vector& u) {
    Vector center = space.center() + u.cwiseProduct(space.halfWidths());
    for (int axis = 0; query.search_box && axis < 3; ++axis)
      if (query.bounds(axis))
        center[axis] = std::min(space.upper[axis], std::max(space.lower[axis], center[axis]));
    if (query.base_z)
      center.z() = *query.base_z;
    return center;
  };
  const auto badness = [&](const Vector& u) {
    double least = 1e9;
    for (const Vector& sample : samples)
      least = std::min(least, margin(body.place(sample, centerAt(u), size)));
    return -least;
  };
  for (int start = 0; start < 3; ++start)
  {
    if (query.turns() && start > 0)
      body.angle = random_.uniform(0.0, 3.2);
    const Vector from =
        start == 0
            ? Vector(
                  (found.center - space.center()).cwiseQuotient(space.halfWidths().cwiseMax(Vector::Constant(1e-12))))
            : anyOffset();
    const Vector best = descend(badness, from.cwiseMax(-Vector::Ones()).cwiseMin(Vector::Ones()));
    if (badness(best) < 0.0 && isGoodRegion(body, centerAt(best), size))
    {
      std::ostringstream text;
      text.precision(17);
      text << "the upper bound of " << inWords(query, found) << " was proved, but that of size " << size << " at "
           << centerAt(best).transpose() << ", turned by " << body.angle << ", has no bad point that is found";
      throw Contradiction(text.str());
    }
  }
}

void Hunter::huntLargest()
{
  Body body = drawnBody(random_, scale_);
  RegionQuery query;
  LargestRegion found;
  try
  {
    query = drawnQuery(body);
    found = findLargestRegion(subject_.machine, query);
  }
  catch (const std::invalid_argument&)
  {
    ++tally_["searches refused"];
    return;
  }
  ++tally_[found.status == LargestRegion::Status::NONE     ? "searches without region"
           : found.status == LargestRegion::Status::PROVEN ? "searches to the accuracy"
                                                           : "searches stopped"];
  body.angle = found.angle.value_or(0.0);
  if (found.size > 0.0)
    expectGoodRegion(body, found.center, found.size, "the largest region, " + inWords(query, found) + ", was proved");
  if (std::isfinite(found.size_upper_bound))
    expectNoneLarger(body, query, found);
}

void Hunter::huntPaths(int count)
{
  RandomBoxes boxes(static_cast<unsigned>(random_.integer(0, 1 << 30)));
  for (int k = 0; k < count; ++k)
  {
    const ExactSegment given = randomSegment(subject_.machine, boxes);
    PathQuery query;
    query.max_looks = 3000;
    const PathResult result = checkPath(subject_.machine, subject_.criterion, { given.segment }, query);
    const SegmentCheck& check = result.segments.front();
    ++tally_[check.verdict == Containment::INSIDE    ? "paths inside"
             : check.verdict == Containment::OUTSIDE ? "paths outside"
                                                     : "paths undecided"];
    const auto guide = [&](const Vector& u) {
      return margin(given.segment.point(0.5 * check.good_until * (u.x() + 1.0)));
    };
    const auto expectAlong = [&](double t, bool is_good) {
      if (oracle_.isGood(given.point(t)) != is_good)
        throw Contradiction("a path was proved good until t = " + std::to_string(check.good_until) +
                            (is_good ? ", but is bad at t = " : " and bad, but is good at t = ") + std::to_string(t));
    };
    for (int start = 0; check.good_until > 0.0 && start < 3; ++start)
    {
      const double u = descend(guide, start == 0 ? Vector(Vector::Zero()) : anyOffset()).x();
      for (const double share : { 0.5 * (u + 1.0), random_.uniform(0.0, 1.0) })
        if (check.verdict == Containment::INSIDE || share < 1.0)
          expectAlong(share * check.good_until, true);
    }
    if (check.bad_at)
      expectAlong(*check.bad_at, false);
  }
}

void Hunter::huntTolerances()
{
  for (const Leg& leg : subject_.machine.legs())
    if (!std::holds_alternative<SlidingStrut>(leg.kind))
      return;
  Tolerances tolerances;
  for (const ToleranceKind& kind : TOLERANCE_KINDS)
    if (random_.once(2))
      setTolerance(kind, { (kind.unit == std::string("m") ? scale_ : 1.0) * 1e-3 * random_.uniform(0.01, 1.0) },
                   tolerances);
  Body body = drawnBody(random_, scale_);
  try
  {
    const Machine machine = withTolerances(subject_.machine, tolerances);
    RegionQuery query = drawnQuery(body);
    query.budget.max_boxes = 500;
    const LargestRegion found = findLargestRegion(machine, query);
    ++tally_["searches within tolerances"];
    body.angle = found.angle.value_or(0.0);
    const auto guide = [&](const Vector& u) { return margin(body.place(u, found.center, found.size)); };
    for (int k = 0; found.size > 0.0 && k < 12; ++k)
    {
      const auto point = body.pointAt(k < 2 ? descend(guide, anyOffset()) : corner(), found.center, found.size);
      Deviation built =
          k < 2 && point ? steepest(machine, Deviation(), subject_.criterion, *point) : randomDeviation(random_);
      for (auto& leg : built.share)
        for (double& share : leg)
          share *= 1.0 - 1e-9;
      if (point && !isGood(machine, built, subject_.criterion, *point))
        throw Contradiction("the largest region on all machines within tolerances (" + inWords(tolerances) + "), " +
                            inWords(query, found) + ", was proved, but a machine is bad at one of its points");
    }
  }
  catch (const std::invalid_argument&)
  {
    ++tally_["tolerances refused"];
  }
}
}  // namespace test
}  // namespace pkm_workspace
