// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/verdict_message.h"

#include <pkm_workspace/CheckPath.h>
#include <pkm_workspace/CheckRegion.h>
#include <pkm_workspace/EvaluatePoint.h>

namespace pkm_workspace
{
namespace
{
using Constants = CheckRegion::Response;

template <class Response>
constexpr bool numbersAlike()
{
  return int(Response::INSIDE) == int(Constants::INSIDE) && int(Response::OUTSIDE) == int(Constants::OUTSIDE) &&
         int(Response::UNDECIDED) == int(Constants::UNDECIDED);
}
static_assert(numbersAlike<CheckPath::Response>() && numbersAlike<EvaluatePoint::Response>(), "messages differ");

template <class Verdict>
std::uint8_t numberOf(Verdict verdict)
{
  return verdict == Verdict::INSIDE    ? Constants::INSIDE
         : verdict == Verdict::OUTSIDE ? Constants::OUTSIDE
                                       : Constants::UNDECIDED;
}
}  // namespace

std::uint8_t constantOf(Containment verdict)
{
  return numberOf(verdict);
}

std::uint8_t constantOf(BoxVerdict verdict)
{
  return numberOf(verdict);
}
}  // namespace pkm_workspace
