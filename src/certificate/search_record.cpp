// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "pkm_workspace/certificate/certificate.h"

namespace pkm_workspace
{
namespace
{
SearchRecord::Key keyOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return { a[0], a[1], a[2], b[0], b[1], b[2] };
}

/// Whether somebody who knows the joint limits, but not the search box or the spheres of struts, can follow it.
bool canBeChecked(const ReasonTerm& term)
{
  return term.kind == ReasonTerm::Kind::TRAVEL ? term.limit.has_value() : term.kind != ReasonTerm::Kind::SPHERE;
}
}  // namespace

/// Cranks and struts of variable length search the balls that they reach: what is known more closely of their ends
/// takes more than a few lines to prove.
void SearchRecord::follow(const Machine& machine, RegionQuery& query)
{
  Box bounds{ Eigen::Vector3d::Constant(-INF), Eigen::Vector3d::Constant(INF) };
  bool is_plain = false;
  for (int i = 0; i < 3; ++i)
  {
    const bool slides = std::holds_alternative<SlidingStrut>(machine.leg(i).kind);
    const bool turns = std::holds_alternative<Crank>(machine.leg(i).kind);
    const double most = query.criterion.joint_limits ? machine.leg(i).limits.upper() : INF;
    if (slides || (!turns && !std::isfinite(most)))
      continue;
    const Interval radius = (1.0 + 1e-12) * (lengthOf(machine.enclosed(i)).upper() + (turns ? 0.0 : most));
    const Interval ball(-radius.upper(), radius.upper());
    bounds = intersection(bounds, boundingBox(machine.center(i) + IntervalVector{ ball, ball, ball }));
    is_plain = true;
  }
  if (is_plain)
    query.plain_bounds = bounds;
  query.closed = [this](const Box& centers, const Reason& reason) { close(centers, reason); };
}

SearchRecord::Term SearchRecord::termOf(const ReasonTerm& term)
{
  const bool is_bad = term.kind == ReasonTerm::Kind::BAD_POINT;
  const auto known = is_bad ? bad_numbers_.emplace(keyOf(term.point, Eigen::Vector3d::Zero()), bad_.size())
                            : point_numbers_.emplace(keyOf(term.place.fixed, term.place.per_size), points_.size());
  if (known.second && is_bad)
    bad_.push_back(term.point);
  else if (known.second)
    points_.push_back(term.place);
  return { known.first->second, term.kind, term.limit.value_or(term.origin.subject), term.origin.v, term.weight };
}

void SearchRecord::close(const Box& centers, const Reason& reason)
{
  Leaf leaf{ !reason.terms.empty() && std::all_of(reason.terms.begin(), reason.terms.end(), canBeChecked),
             reason.size,
             {} };
  for (std::size_t k = 0; leaf.is_proved && k < reason.terms.size(); ++k)
    leaf.terms.push_back(termOf(reason.terms[k]));
  leaves_[keyOf(centers.lower, centers.upper)] = std::move(leaf);
}
}  // namespace pkm_workspace
