// SPDX-License-Identifier: BSD-3-Clause
// Sends a goal that goes on for a day, says so when it runs, and says how it has ended: for clients_test.py.
#include <ros/ros.h>

#include <iostream>

#include "pkm_workspace/ros/client.h"

int main(int argc, char** argv)
{
  using namespace pkm_workspace;
  ros::init(argc, argv, "client_goal");
  Client machine;
  const auto tell = [](const ApproximateWorkspaceFeedback&) { std::cout << "running" << std::endl; };
  auto goal = machine.approximateWorkspace(tell, with::set(CriterionRequest::REACHABLE), with::resolution(1e-4),
                                           with::time_limit(86400.0));
  const bool ended = goal.waitForResult(60.0);
  std::cout << (ended && goal.state() == Goal<ApproximateWorkspaceAction>::State::LOST ? "lost" : "not lost")
            << std::endl;
}
