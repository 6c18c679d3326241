// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/paving_message.h"

#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/report/paving_sentence.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "pkm_workspace/ros/solid_message.h"

namespace pkm_workspace
{
namespace
{
void readMemory(const PavingRequest& request, const Parameters& parameters, PavingQuery& query, Problems& problems)
{
  const std::int64_t most = parameters.query.budget.max_memory;
  std::int64_t& asked = query.budget.max_memory;
  asked = request.max_memory == 0 ? most : request.max_memory;
  if (asked >= Budget::LEAST_MEMORY && asked <= most)
    return;
  problems.push_back("max_memory = " + std::to_string(asked) + " bytes must be from " +
                     std::to_string(Budget::LEAST_MEMORY) + " to the node's ~max_memory, " + std::to_string(most) +
                     " bytes, or 0 for that");
  asked = most;
}

void add(const BoxTree& tree, CellState state, BoxList& list)
{
  for (const std::vector<Box>& boxes : tree.boxes(state))
    for (const Box& box : boxes)
    {
      list.min_corners.push_back(toMessage(box.lower));
      list.max_corners.push_back(toMessage(box.upper));
    }
}
/// @pre the box has been read
void readConnection(const PavingRequest& request, PavingQuestion& question, Problems& problems)
{
  question.components = request.components != 0;
  if (!request.connect.empty() && request.connect.size() != 2)
    problems.push_back("connect has " + std::to_string(request.connect.size()) + " points, it must have two, or none");
  for (const geometry_msgs::Point& point : request.connect)
  {
    question.connect.push_back(fromMessage(point));
    requireFinite("connect", question.connect.back(), problems);
    if (question.query.box && !question.query.box->contains(question.connect.back()))
      problems.emplace_back("connect: both points must be in the box of the request");
  }
}

WorkspaceComponent componentMessage(const Component& component)
{
  WorkspaceComponent message;
  message.volume_lower_bound = component.volume.lower();
  message.boxes = component.boxes;
  message.min_corner = toMessage(component.bounds.lower);
  message.max_corner = toMessage(component.bounds.upper);
  message.point = toMessage(component.point);
  message.cluster = static_cast<std::int64_t>(component.cluster);
  return message;
}

void fillComponents(const ComponentsReport& found, Workspace& message)
{
  for (const Component& component : found.list)
    message.components.push_back(componentMessage(component));
  message.clusters = static_cast<std::int64_t>(found.clusters);
  if (found.zero)
    message.zero_component = static_cast<std::int64_t>(*found.zero);
  message.components_message = found.message;
}
}  // namespace

void fill(const ConnectionReport& found, Workspace& message)
{
  message.connection = static_cast<std::uint8_t>(found.verdict) + 1;  // in the order of ConnectionReport::Verdict
  message.connection_message = found.message;
  for (const Eigen::Vector3d& point : found.path)
    message.connection_path.push_back(toMessage(point));
}

PavingQuestion fromMessage(const PavingRequest& request, const FramedMachine& in, const Criterion& criterion,
                           const Parameters& parameters, double longest)
{
  PavingQuestion question;
  question.in = in;
  question.max_listed = request.max_listed;
  question.volume.accuracy = valueOr(request.volume_accuracy, 1.0);
  PavingQuery& query = question.query;
  Problems problems;
  query.criterion = in.seen(fromMessage(request.criterion, *in.machine, criterion, problems));
  query.box = readCorners(request.use_box, request.min_corner, request.max_corner, "use_box", problems);
  readConnection(request, question, problems);
  query.budget = parameters.query.budget;
  query.budget.time_limit = timeLimitOf(request.time_limit, query.budget.time_limit, longest, problems);
  readMemory(request, parameters, query, problems);
  if (request.max_listed < 0)
    problems.push_back("max_listed = " + std::to_string(request.max_listed) + " must be >= 0");
  const double resolution = valueOr(request.resolution, parameters.paving_resolution);
  query.resolution = valueOr(resolution, 1.0);  // until the criterion is known to be good
  query.validate(problems);
  validateShare("volume_accuracy", question.volume.accuracy, "(relative)", problems);
  throwProblems(problems);
  if (resolution == 0.0)
    query.resolution = withRemedy(PAVING_REMEDY, [&] { return defaultResolution(*in.machine, query); });
  return question;
}

Workspace toMessage(const PavingQuestion& question, const PavingReport& report, const ros::Time& stamp)
{
  const Paving& paving = report.paving;
  const BoxTree& tree = paving.tree;
  Workspace message;
  message.header = headerOf(question.in, stamp);
  message.hypotheses = toMessage(question.in.premises(paving.premises.criterion), paving.resolution);
  message.min_corner = toMessage(paving.box.lower);
  message.max_corner = toMessage(paving.box.upper);
  message.dimension = static_cast<std::uint8_t>(Measure(paving.box).dimension);
  message.volume_lower_bound = report.size.volume.lower();
  message.volume_upper_bound = report.size.volume.upper();
  message.volume_inside = paving.volume_inside.lower();
  message.volume_boundary = paving.volume_boundary.upper();
  message.boxes_inside = tree.count(CellState::INSIDE);
  message.boxes_boundary = tree.count(CellState::BOUNDARY);
  message.boxes_pending = tree.count(CellState::PENDING);
  message.boxes = paving.boxes;
  message.boxes_here = paving.boxes_here;
  message.zero_component = -1;
  if (report.components)
    fillComponents(*report.components, message);
  message.complete = report.complete();
  message.seconds = report.seconds();
  message.message = report.message(*question.in.machine);
  if (question.max_listed > 0)
  {
    const BoxTree coarse = tree.coarsened(question.max_listed);
    add(coarse, CellState::INSIDE, message.inside);
    add(coarse, CellState::BOUNDARY, message.boundary);
    add(coarse, CellState::PENDING, message.boundary);
  }
  return message;
}

std::string describe(const PavingQuery& query)
{
  TextStream text;
  text << "paving of all points that are " << describe(query.criterion) << ", resolution " << query.resolution
       << " m, within " << query.budget.time_limit << " s";
  return text.str();
}
}  // namespace pkm_workspace
