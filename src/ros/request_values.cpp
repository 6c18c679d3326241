// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/solid_message.h"

namespace pkm_workspace
{
std::optional<Box> readCorners(bool given, const geometry_msgs::Point& min_corner,
                               const geometry_msgs::Point& max_corner, const std::string& flag, Problems& problems)
{
  const Box corners{ { min_corner.x, min_corner.y, min_corner.z }, { max_corner.x, max_corner.y, max_corner.z } };
  if (given)
  {
    const std::size_t before = problems.size();
    requireFinite("min_corner", corners.lower, problems);
    requireFinite("max_corner", corners.upper, problems);
    return problems.size() == before ? std::optional<Box>(corners) : std::nullopt;
  }
  if (corners.lower != Eigen::Vector3d::Zero() || corners.upper != Eigen::Vector3d::Zero())
    problems.push_back("min_corner and max_corner must be 0 [m] unless " + flag + " is true");
  return std::nullopt;
}

double timeLimitOf(double requested, double node, double longest, Problems& problems)
{
  const double time_limit = valueOr(requested, node);
  if (time_limit > 0.0 && time_limit <= longest)
    return time_limit;
  TextStream text;
  text << "time_limit = " << time_limit << " s must be positive and at most ";
  if (longest > node)
    text << longest << " s, or 0 for the node's ~time_limit, " << node << " s";
  else
    text << "the node's ~time_limit, " << node << " s, or 0 for it";
  problems.push_back(text.str());
  return node;
}
}  // namespace pkm_workspace
