// SPDX-License-Identifier: BSD-3-Clause
#include "path_body_proof.h"

#include <algorithm>
#include <array>

#include "cut_off.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// By how much more some points are proved to be good when they are moved: those that are moved by next to nothing
/// farther than one of them need no proof of their own.
constexpr double GENEROUS = 1.0 + 0x1p-20;
}  // namespace

PathBody::Proof::Proof(const PathBody& body, const BoxTest& test, const Vector3d& center, double size,
                       const Budget& budget)
  : body_(body)
  , test_(test)
  , limits_(budget)
  , budget_(budget)
  , moves_(body.workpiece_->moves)
  , center_(center)
  , size_(size)
  , reach_(body.grows_ == Grows::MARGIN ? size : 0.0)
  , generous_(GENEROUS * reach_)
  , most_(body.grows_ == Grows::MARGIN ? 1.0 : (Interval(body.least_scale_) + Interval(size)).upper())
{}

ContainmentResult PathBody::Proof::run()
{
  if (refuteAtOutline())
    return result_;
  bool is_proved = cover();
  if (is_proved && body_.limits_.any() && !body_.workpiece_->solid)
  {
    asks_for_rates_ = true;
    is_proved = cover();
  }
  if (is_proved)
    result_.verdict = Containment::INSIDE;
  result_.seconds = budget_.seconds();
  return result_;
}

/// Covers all of the body, and what is left undecided by smaller boxes. @return whether all of it is good
bool PathBody::Proof::cover()
{
  if (body_.workpiece_->solid)
    openSolid(thickened(body_.workpiece_->solid->boundingBox(center_ + body_.workpiece_->reference, most_), reach_));
  else
    open({ Vector3d::Constant(-INF), Vector3d::Constant(INF) },
         { { moves_.all(), body_.grows_ == Grows::MARGIN ? 1.0 : body_.least_scale_, most_ } });
  return branchAndBound(open_, *this, budget_) == Ending::EXHAUSTED;
}

std::size_t PathBody::Proof::waveSize() const
{
  return limits_.max_boxes > 0 ? std::min(BATCH, static_cast<std::size_t>(limits_.max_boxes - result_.boxes)) : BATCH;
}

bool PathBody::Proof::expand(const std::vector<Node>& nodes)
{
  std::array<Box, BATCH> boxes;
  std::array<BoxVerdict, BATCH> verdicts;
  std::array<AffineForm<double>, BATCH> worst;
  result_.boxes += static_cast<std::int64_t>(nodes.size());
  if (asks_for_rates_)
    return std::all_of(nodes.begin(), nodes.end(), [this](const Node& node) { return settleRates(node); });
  std::transform(nodes.begin(), nodes.end(), boxes.begin(), [](const Node& node) { return node.box; });
  test_.kernel().classify(boxes.data(), nodes.size(), verdicts.data(), worst.data());
  for (std::size_t k = 0; k < nodes.size(); ++k)
    if (!settle(nodes[k], verdicts[k], worst[k]))
      return false;
  return true;
}

bool PathBody::Proof::settle(const Node& node, BoxVerdict verdict, const AffineForm<double>& worst)
{
  if (verdict == BoxVerdict::INSIDE)
    return true;
  Vector3d target = node.box.center();
  if (verdict == BoxVerdict::UNDECIDED)
    for (int k = 0; k < 3; ++k)
      target[k] = worst.gradient[static_cast<std::size_t>(k)] > 0.0 ? node.box.lower[k] : node.box.upper[k];
  return !findBad(node, target) &&
         divide(node.box, node.parts ? *node.parts : Parts{}, verdict == BoxVerdict::UNDECIDED ? &worst : nullptr);
}

/// @return whether the proof can go on
bool PathBody::Proof::settleRates(const Node& node)
{
  Parts too_fast;
  for (const Part& part : *node.parts)
    addTooFast(part, node.box, too_fast);
  return too_fast.empty() || (result_.verdict != Containment::OUTSIDE && divide(node.box, too_fast));
}

/// @return whether the proof can go on
bool PathBody::Proof::divide(const Box& box, const Parts& parts, const AffineForm<double>* worst)
{
  result_.is_within_rounding = test_.isBeyondPrecision(box);
  if (result_.is_within_rounding)
    return false;
  const Cut cut = worst == nullptr ? Cut{ box.widestAxis(), box.center()[box.widestAxis()] } : cutOff(box, *worst);
  const auto halves = box.splitAt(cut.axis, cut.plane);
  for (const Box& part : { halves.second, halves.first })
    if (body_.workpiece_->solid)
      openSolid(part);
    else
      open(part, parts);
  return true;
}

ContainmentResult PathBody::prove(const BoxTest& test, const Vector3d& center, double size, const Budget& budget) const
{
  return Proof(*this, test, center, size, budget).run();
}
}  // namespace pkm_workspace
