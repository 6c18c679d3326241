// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/criterion_service.h"

#include "pkm_workspace/common/text.h"
#include "pkm_workspace/region/center_space.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/reply.h"

namespace pkm_workspace
{
CriterionService::CriterionService(NodeContext& context, const std::function<void()>& changed)
  : context_(context)
  , changed_(changed)
  , service_(offer<SetCriterion>(
        context.private_node, context.health, "set_criterion",
        [this](const SetCriterion::Request& request, SetCriterion::Response& response) { set(request, response); }))
{}

void CriterionService::set(const SetCriterion::Request& request, SetCriterion::Response& response)
{
  requireNoBallAxes(request.criterion, "those of the node are its parameter ~ball_axes; set that and call ~reload");
  requireNoTolerances(request.criterion,
                      "those of the node are its parameters ~tolerance_length and so on; set these and call ~reload");
  RegionQuery query = context_.query();
  Problems problems;
  query.criterion = fromMessage(request.criterion, context_.machine(), query.criterion, problems);
  for (Zone& zone : query.criterion.zones)
    zone.in_root = true;  // as all zones of the node
  query.accuracy = valueOr(request.accuracy, query.accuracy);
  query.validate(problems);
  validateAccuracy(context_.machine(), query, problems);
  throwProblems(problems);
  withRemedy(NODE_REMEDY,
             [&] { return centerSpace(context_.machine(), query); });  // refuses what has no bounded answer
  context_.setCriterion(query.criterion, query.accuracy);
  changed_();
  response.hypotheses = toMessage(context_.frames.root().premises(query.criterion), query.accuracy);
  response.message = sentence("computing: " + describe(query));
}
}  // namespace pkm_workspace
