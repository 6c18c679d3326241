// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pkm_workspace/CheckGcode.h>

#include "pkm_workspace/tasks/job.h"

namespace pkm_workspace
{
/// What a request has beside the criterion. @param job reads the request's text, which has to outlive it
/// @param problems gets one sentence for each value that is out of range
void read(const CheckGcode::Request& request, JobTask& job, Problems& problems);

/// What a request asks about the joints' rates. @param joint_acceleration_max where it has none [m/s^2]
PathRatesTask ratesOf(const CheckGcode::Request& request, const std::vector<double>& joint_acceleration_max);

/// All but header and hypotheses.
void fill(const PathReport& report, const JobTask& job, const Machine& machine, CheckGcode::Response& response);
}  // namespace pkm_workspace
