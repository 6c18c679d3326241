// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <sstream>

#include "pkm_workspace/ros/node.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "pkm_workspace_node");
  const ros::NodeHandle node;  // out here: what is said after the last handle has gone is lost
  try
  {
    return pkm_workspace::Node(node, ros::NodeHandle("~")).run() ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::istringstream problems(error.what());
    for (std::string problem; std::getline(problems, problem);)
      ROS_FATAL_STREAM(problem);
  }
  return 1;
}
