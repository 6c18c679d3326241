// SPDX-License-Identifier: BSD-3-Clause
#include "tool_point.h"

#include "refusal.h"

namespace pkm_workspace
{
namespace urdf_io
{
IntervalVector toolAt(const std::string& link, const Model& model, const std::array<Rail, 3>& rails,
                      const Stations& stations, const Closure& closure)
{
  Problems problems;
  const auto found = findLink(link, stations);
  if (model.tree->links_.count(link) == 0)
    complain(problems, "tool_link names '", link, "', which is not a link; the links are: ", linksOf(model));
  else if (!found)
    complain(problems, "tool_link names link '", link, "', which no rail carries; expected one fixed to the platform");
  else if (!found->second->isOnPlatform())
    complain(problems, "tool_link '", link, "': ", whyNotOnPlatform(*found->second));
  throwRefusal(problems);
  const Station& tool = *found->second;
  const Station& tcp = closure.legs[found->first].tcp;
  if (tool.wrist.back().joint != tcp.wrist.back().joint)
    complain(problems, "tool_link '", link, "' hangs at joint '", tool.wrist.back().joint,
             "' and the point where the legs meet, link '", tcp.link, "', at '", tcp.wrist.back().joint,
             "'; expected a link fixed to the platform");
  throwRefusal(problems);
  const IntervalVector offset = rails[found->first].slider.rotation * (tool.offset - tcp.offset);
  const double turn = (Interval(tool.turn) * norm(offset)).upper();
  return offset + IntervalVector{ Interval(-turn, turn), Interval(-turn, turn), Interval(-turn, turn) };
}

std::vector<Beyond> linksBeyond(const Model& model, const Stations& stations, const Closure& closure)
{
  std::vector<Beyond> beyond;
  for (std::size_t i = 0; i < 3; ++i)
    for (const Station& station : stations[i])
    {
      const Station& tcp = closure.legs[i].tcp;
      const double distance = mid(station.offset - tcp.offset).norm();
      const bool is_end = model.link(station.link).child_joints.empty();
      if (is_end && station.isOnPlatform() && station.wrist.back().joint == tcp.wrist.back().joint &&
          distance > 1e-9 * closure.scale())
        beyond.push_back({ station.link, distance });
    }
  return beyond;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
