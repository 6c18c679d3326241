// SPDX-License-Identifier: BSD-3-Clause
#include "comparison.h"

#include <algorithm>
#include <stdexcept>

#include "pkm_workspace/interval/decimal.h"

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// "(x, y, z) m" to a few digits: a place, not a proof.
std::string nearlyAt(const Eigen::Vector3d& p)
{
  return "(" + nearly(p.x(), 4) + ", " + nearly(p.y(), 4) + ", " + nearly(p.z(), 4) + ") m";
}

}  // namespace

std::string verdictOn(const SingularityAnswer& answer)
{
  switch (answer.status)
  {
    case SingularityAnswer::Status::NONE:
      return "none";
    case SingularityAnswer::Status::PROVED:
      return "at " + nearlyAt(answer.box->center());
    case SingularityAnswer::Status::UNDECIDED:
      return "undecided";
  }
  throw std::logic_error("a status without a name");
}

Json toJson(const SingularityAnswer& answer)
{
  const bool proved = answer.status == SingularityAnswer::Status::PROVED;
  return { { "exists", answer.status == SingularityAnswer::Status::UNDECIDED ? Json() : Json(proved) },
           { "least", toJson(answer.least) },
           { "box", proved ? toJson(*answer.box) : Json() } };
}

std::string describe(const Interval& value)
{
  if (value.isEmpty())
    return "-";
  if (value.isSingle())
    return exact(value.lower());
  const double upper = value.isBounded() ? value.upper() : value.lower();
  const int decimals = std::min(decimalsFor(value.lower(), upper), decimalsFor(upper, upper));
  const std::string lower = roundedDown(value.lower(), decimals);
  return value.isBounded() ? lower + " to " + roundedUp(upper, decimals) : "at least " + lower;
}
}  // namespace cli
}  // namespace pkm_workspace
