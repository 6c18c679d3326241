// SPDX-License-Identifier: BSD-3-Clause
#include "closure.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "number_text.h"
#include "refusal.h"
#include "tool_point.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
/// A link that may stand for the tool point, with where it is at zero in the root frame.
struct Candidate
{
  const Station* station;
  Eigen::Vector3d point;
};
using Candidates = std::array<std::vector<Candidate>, 3>;

/// One candidate of each leg.
struct Triple
{
  std::array<const Candidate*, 3> of;

  /// The largest distance between any two [m].
  double distance() const
  {
    return std::max({ (of[1]->point - of[0]->point).norm(), (of[2]->point - of[0]->point).norm(),
                      (of[2]->point - of[1]->point).norm() });
  }

  int depth() const
  {
    return std::min({ of[0]->station->fixed_joints, of[1]->station->fixed_joints, of[2]->station->fixed_joints });
  }
  int fixedJoints() const
  {
    return of[0]->station->fixed_joints + of[1]->station->fixed_joints + of[2]->station->fixed_joints;
  }
  bool isDeeperThan(const Triple& other) const
  {
    return depth() != other.depth() ? depth() > other.depth() : fixedJoints() < other.fixedJoints();
  }
  std::string names() const
  {
    return "'" + of[0]->station->link + "', '" + of[1]->station->link + "', '" + of[2]->station->link + "'";
  }
};

Candidate candidateAt(const Station& station, const Rail& rail)
{
  return { &station, mid(rail.slider.toOuter(station.frame.position)) };
}

/// Every link that is fixed below a wrist.
Candidates allCandidates(const std::array<Rail, 3>& rails, const Stations& stations)
{
  Problems problems;
  Candidates candidates;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (const Station& station : stations[i])
      if (station.isOnPlatform() && station.fixed_joints > 0)
        candidates[i].push_back(candidateAt(station, rails[i]));
    if (candidates[i].empty())
      complain(problems, "leg of rail '", rails[i].joint->name, "': ", whyNoPlatform(stations[i]));
  }
  throwRefusal(problems);
  return candidates;
}

Candidates namedCandidates(const Model& model, const std::array<Rail, 3>& rails, const Stations& stations,
                           const std::vector<std::string>& names)
{
  Problems problems;
  Candidates candidates;
  if (names.size() != 3)
    complain(problems, "tcp_links names ", names.size(), " links, expected three, one for each leg");
  for (const std::string& name : names)
  {
    const auto found = findLink(name, stations);
    if (model.tree->links_.count(name) == 0)
      complain(problems, "tcp_links names '", name, "', which is not a link; the links are: ", linksOf(model));
    else if (!found)
      complain(problems, "tcp_links names link '", name, "', which no rail carries");
    else if (!candidates[found->first].empty())
      complain(problems, "tcp_links names links '", candidates[found->first].front().station->link, "' and '", name,
               "' on the leg of rail '", rails[found->first].joint->name, "', expected one for each leg");
    else if (!found->second->isOnPlatform())
      complain(problems, "tcp link '", name, "': ", whyNotOnPlatform(*found->second));
    else
      candidates[found->first].push_back(candidateAt(*found->second, rails[found->first]));
  }
  throwRefusal(problems);
  return candidates;
}

/// Of @p others the best partner of @p first: within the tolerance, not less deep if possible, then the least deep.
const Candidate* partnerOf(const Candidate& first, const std::vector<Candidate>& others, double tolerance)
{
  const Candidate* best = nullptr;
  for (const Candidate& other : others)
  {
    if (!((other.point - first.point).norm() <= tolerance))
      continue;
    const int depth = other.station->fixed_joints;
    const int wanted = first.station->fixed_joints;
    const int found = best == nullptr ? -1 : best->station->fixed_joints;
    if (std::min(depth, found) >= wanted ? depth < found : depth > found)
      best = &other;
  }
  return best;
}

/// The triples that coincide, one at most for each candidate of the first leg.
std::vector<Triple> coincidingTriples(const Candidates& candidates, double tolerance)
{
  std::vector<Triple> triples;
  for (const Candidate& first : candidates[0])
  {
    const Candidate* const second = partnerOf(first, candidates[1], tolerance);
    const Candidate* const third = partnerOf(first, candidates[2], tolerance);
    if (second != nullptr && third != nullptr)
      triples.push_back({ { &first, second, third } });
  }
  return triples;
}

/// The triple that comes nearest to closing.
Triple nearestTriple(const Candidates& candidates)
{
  std::optional<Triple> best;
  for (const Candidate& first : candidates[0])
  {
    Triple triple{ { &first, nullptr, nullptr } };
    for (const std::size_t i : { 1, 2 })
    {
      const auto distance = [&first](const Candidate& c) { return (c.point - first.point).norm(); };
      const auto nearer = [&](const Candidate& a, const Candidate& b) { return distance(a) < distance(b); };
      triple.of[i] = &*std::min_element(candidates[i].begin(), candidates[i].end(), nearer);
    }
    if (!best || triple.distance() < best->distance())
      best = triple;
  }
  return *best;
}

/// Refuses links that are drawn too far apart to be one point.
void checkDistance(const Triple& triple, double allowed, Problems& problems)
{
  if (triple.distance() <= allowed)
    return;
  complain(problems, "the tcp frames of links ", triple.names(), " are ", roundedText(triple.distance(), 6),
           " m apart at zero, expected at most ", roundedText(urdf_tolerance::GAP, 3), " L = ", roundedText(allowed, 6),
           " m: at zero the machine must be drawn assembled, or nearly");
  throwRefusal(problems);
}

/// Refuses a link that has two partners on one other leg within the distance allowed, in different places.
void checkPartner(const Candidate& link, const std::vector<Candidate>& others, double allowed, double same,
                  Problems& problems)
{
  const Candidate* partner = nullptr;
  for (const Candidate& other : others)
  {
    if (!((other.point - link.point).norm() <= allowed))
      continue;
    if (partner != nullptr && !((other.point - partner->point).norm() <= same))
    {
      complain(problems, "at zero link '", link.station->link, "' is drawn within ", roundedText(allowed, 3),
               " m of both '", partner->station->link, "' and '", other.station->link,
               "', which differ; name the three links of the tool point with tcp_links");
      throwRefusal(problems);
    }
    partner = &other;
  }
}

/// Where links are drawn apart that are one point, each must have one partner alone on each other leg.
void checkPartners(const Candidates& candidates, double allowed, double same, Problems& problems)
{
  for (std::size_t i = 0; i < 3; ++i)
    for (const std::size_t other : { (i + 1) % 3, (i + 2) % 3 })
      for (const Candidate& link : candidates[i])
        checkPartner(link, candidates[other], allowed, same, problems);
}

/// How far links may be apart that count as one point: more than rounding where no triple comes that near.
/// @param problems of the legs, told with what is wrong with the distances
double toleranceFor(const Candidates& candidates, double length, Problems& problems)
{
  const double allowed = urdf_tolerance::GAP * length;
  const Triple nearest = nearestTriple(candidates);
  checkDistance(nearest, allowed, problems);
  if (nearest.distance() <= urdf_tolerance::COINCIDE * length)
    return urdf_tolerance::COINCIDE * length;
  checkPartners(candidates, allowed, 1e-9 * length, problems);
  return allowed;
}

/// @pre one triple at least coincides
Triple deepestTriple(const Candidates& candidates, double tolerance, Problems& problems)
{
  const auto triples = coincidingTriples(candidates, tolerance);
  const auto less = [](const Triple& a, const Triple& b) { return b.isDeeperThan(a); };
  const Triple deepest = *std::max_element(triples.begin(), triples.end(), less);
  for (const Triple& other : triples)
    if (!deepest.isDeeperThan(other) && (other.of[0]->point - deepest.of[0]->point).norm() > 2.0 * tolerance)
    {
      complain(problems, "the links ", deepest.names(), " coincide at zero, and so do ", other.names(),
               ", elsewhere and as deep; name the tool point's with tcp_links");
      throwRefusal(problems);
    }
  return deepest;
}
/// Each leg needs its own freedom: none of its passive joints follows another's, or what drives a leg.
void checkIndependence(const std::array<Rail, 3>& rails, const std::array<ClosedLeg, 3>& legs, Problems& problems)
{
  std::map<std::string, std::string> joint_of;
  const auto drives = [&rails](const std::string& joint) {
    return std::any_of(rails.begin(), rails.end(), [&](const Rail& rail) { return rail.joint->name == joint; });
  };
  for (const ClosedLeg& leg : legs)
    for (const Hinge& hinge : leg.tcp.at_slider)
    {
      const auto other = joint_of.emplace(hinge.master, hinge.joint);
      if (drives(hinge.master))
        complain(problems, "joint '", hinge.joint, "' follows '", hinge.master,
                 "', which drives a leg; expected passive joints that turn each strut by itself");
      else if (!other.second)
        complain(problems, "joints '", other.first->second, "' and '", hinge.joint, "' both follow '", hinge.master,
                 "', which couples their struts; expected passive joints that turn each strut by itself");
    }
}
}  // namespace

Closure closeLegs(const Model& model, const std::array<Rail, 3>& rails, const UrdfOptions& options)
{
  Stations stations;
  for (std::size_t i = 0; i < 3; ++i)
    stations[i] = stationsBelow(rails[i], model);
  const Candidates candidates = options.tcp_links.empty() ? allCandidates(rails, stations)
                                                          : namedCandidates(model, rails, stations, options.tcp_links);

  Problems of_first;
  double length = 0.0;
  for (const auto& leg : candidates)
    length = std::max(length, measureLeg(*leg.front().station, of_first).length.upper());
  const Triple triple = deepestTriple(candidates, toleranceFor(candidates, length, of_first), of_first);
  checkDistance(triple, urdf_tolerance::GAP * length, of_first);

  Problems problems;
  Closure closure;
  for (std::size_t i = 0; i < 3; ++i)
  {
    closure.legs[i].tcp = *triple.of[i]->station;
    closure.legs[i].geometry = measureLeg(closure.legs[i].tcp, problems);
    closure.legs[i].tool_point = rails[i].slider.toOuter(closure.legs[i].tcp.frame.position);
  }
  checkIndependence(rails, closure.legs, problems);
  throwRefusal(problems);
  closure.gap = triple.distance();
  closure.allowed = urdf_tolerance::GAP * length;
  if (options.tool_link.empty() && !options.tool)
    closure.beyond = linksBeyond(model, stations, closure);
  closure.named = options.tool_link;
  if (!closure.named.empty())
    closure.tool = toolAt(closure.named, model, rails, stations, closure);
  else
    closure.tool = enclose(options.tool.value_or(Eigen::Vector3d::Zero()));
  return closure;
}

std::string tcpNames(const Closure& closure)
{
  return "'" + closure.legs[0].tcp.link + "', '" + closure.legs[1].tcp.link + "', '" + closure.legs[2].tcp.link + "'";
}
}  // namespace urdf_io
}  // namespace pkm_workspace
