// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "pkm_workspace/ros/parameters.h"

namespace pkm_workspace
{
std::string loadDescription(const ros::NodeHandle& private_node, bool as_told)
{
  std::string name;
  std::string xml;
  if (!private_node.searchParam("robot_description", name))
    throw std::invalid_argument("parameter robot_description is not there, searched from " +
                                private_node.getNamespace() + " upwards: load the machine's URDF into it");
  if (!(as_told ? private_node.getParamCached(name, xml) : private_node.getParam(name, xml)))
    throw std::invalid_argument("parameter " + name + " must be a text, the machine's URDF");
  return xml;
}

UrdfMachine readMachine(const std::string& xml, const ros::NodeHandle& private_node, const UrdfOptions& options)
{
  try
  {
    return readUrdf(xml, options);
  }
  catch (const std::invalid_argument& error)
  {
    std::string name;
    private_node.searchParam("robot_description", name);
    throw std::invalid_argument("parameter " + name + ": " + error.what());
  }
}

std::string frameOf(const ros::NodeHandle& private_node, const std::string& link)
{
  std::string name;
  std::string prefix;
  if (private_node.searchParam("tf_prefix", name))
    private_node.getParam(name, prefix);
  const auto first = prefix.find_first_not_of('/');
  const auto last = prefix.find_last_not_of('/');
  return first == std::string::npos ? link : prefix.substr(first, last - first + 1) + "/" + link;
}
}  // namespace pkm_workspace
