// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/conversions.h"

#include <stdexcept>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/report/largest_sentence.h"
#include "pkm_workspace/ros/criterion_message.h"

namespace pkm_workspace
{
geometry_msgs::Point toMessage(const Eigen::Vector3d& point)
{
  geometry_msgs::Point message;
  message.x = point.x();
  message.y = point.y();
  message.z = point.z();
  return message;
}

geometry_msgs::Quaternion toMessage(const Eigen::Quaterniond& turn)
{
  geometry_msgs::Quaternion message;
  message.x = turn.x();
  message.y = turn.y();
  message.z = turn.z();
  message.w = turn.w();
  return message;
}

Eigen::Vector3d fromMessage(const geometry_msgs::Point& point)
{
  return { point.x, point.y, point.z };
}

geometry_msgs::Pose toMessage(const Pose& pose)
{
  const auto& [x, y, z, w] = pose.orientation;
  geometry_msgs::Pose message;
  message.position = toMessage(pose.translation);
  message.orientation = toMessage(Eigen::Quaterniond(w, x, y, z));
  return message;
}

Pose fromMessage(const geometry_msgs::Pose& pose)
{
  const geometry_msgs::Quaternion& turn = pose.orientation;
  return { { turn.x, turn.y, turn.z, turn.w }, fromMessage(pose.position) };
}

namespace
{
const Eigen::IOFormat POINT_TEXT(Eigen::StreamPrecision, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")");

/// What K measures along the axes.
Eigen::Vector3d proportionsOf(const Shape& shape)
{
  return 2.0 * shape.halfExtents().per_size;
}

/// Sets the shape unless the request leaves it as it is.
void readShape(const RegionRequest& request, const ShapeDefaults& defaults, RegionQuery& query)
{
  const std::string own = query.shape->name();
  const Eigen::Vector3d sides(request.proportions.x, request.proportions.y, request.proportions.z);
  std::optional<Eigen::Vector3d> proportions;
  std::optional<RatioRange> ratio;
  if (sides != Eigen::Vector3d::Zero())
    proportions = sides;
  if ((request.ratio_min == 0.0) != (request.ratio_max == 0.0))
    throw std::invalid_argument("ratio_min and ratio_max must both be given, or both be 0: one of them is 0");
  if (request.ratio_min != 0.0)
    ratio = RatioRange{ request.ratio_min, request.ratio_max };
  if (!proportions && !ratio && (request.shape.empty() || request.shape == own))
    return;
  const std::string shape = request.shape.empty() ? own : request.shape;
  setShape(shape, proportions ? proportions : defaults.proportionsFor(shape), ratio ? ratio : defaults.ratioFor(shape),
           query);
}

RailRange railRange(const JointRange& range, const std::string& joint)
{
  RailRange message;
  message.joint = joint;
  message.lower = range.lower.lower();
  message.upper = range.upper.upper();
  message.inner_lower = range.lower.upper();
  message.inner_upper = range.upper.lower();
  message.stroke_lower_bound = range.stroke.lower();
  message.stroke_upper_bound = range.stroke.upper();
  message.across_lower_bound = range.across.lower();
  message.across_upper_bound = range.across.upper();
  return message;
}

std::uint8_t constantOf(LargestRegion::Status status)
{
  switch (status)
  {
    case LargestRegion::Status::PROVEN:
      return Region::PROVEN;
    case LargestRegion::Status::STOPPED:
      return Region::STOPPED;
    case LargestRegion::Status::NONE:
      return Region::NONE;
  }
  throw std::logic_error("a status without a constant in Region.msg");
}

std::uint8_t solidType(const Shape& shape)
{
  if (shape.isBox())
    return shape_msgs::SolidPrimitive::BOX;
  if (shape.ballRadius(1.0))
    return shape_msgs::SolidPrimitive::SPHERE;
  if (shape.isPrism())
    return shape_msgs::SolidPrimitive::CYLINDER;
  throw std::logic_error("a shape without a type in SolidPrimitive.msg: " + shape.name());
}

void describeRegion(const LargestRegion& region, const Shape& shape, Region& message)
{
  const Eigen::Vector3d proportions = proportionsOf(shape);
  message.shape = shape.name();
  message.proportions.x = proportions.x();
  message.proportions.y = proportions.y();
  message.proportions.z = proportions.z();
  message.solid.type = solidType(shape);
  message.solid.dimensions = shape.dimensions(region.size);
  message.center = toMessage(region.center);
  message.size = region.size;
  message.size_upper_bound = region.size_upper_bound;
  message.volume = region.volume;
  message.volume_upper_bound = region.volume_upper_bound;
  message.ratio_min = region.ratio ? region.ratio->lower : 0.0;
  message.ratio_max = region.ratio ? region.ratio->upper : 0.0;
}
}  // namespace

RegionQuery fromMessage(const RegionRequest& request, const Machine& machine, const RegionQuery& defaults,
                        const ShapeDefaults& shape, double longest)
{
  RegionQuery query = defaults;
  Problems problems;
  try
  {
    readShape(request, shape, query);
  }
  catch (const std::invalid_argument& error)
  {
    problems.push_back(error.what());
  }
  if (const auto corners =
          readCorners(request.use_search_box, request.min_corner, request.max_corner, "use_search_box", problems))
    query.search_box = corners;
  query.criterion = fromMessage(request.criterion, machine, defaults.criterion, problems);
  query.precision = request.multi_precision ? Precision::MULTIPLE : Precision::DOUBLE;
  query.accuracy = valueOr(request.accuracy, defaults.accuracy);
  query.budget.time_limit = timeLimitOf(request.time_limit, defaults.budget.time_limit, longest, problems);
  query.validate(problems);
  throwProblems(problems);
  return query;
}

std_msgs::Header headerOf(const FramedMachine& in, const ros::Time& stamp)
{
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = in.frame;
  return header;
}

Region toMessage(const Answer& answer, const ros::Time& stamp)
{
  const LargestRegion& region = answer.region;
  const RegionQuery& query = answer.question.query;
  const Machine& machine = *answer.question.in.machine;
  Region message;
  message.header = headerOf(answer.question.in, stamp);
  message.hypotheses = toMessage(answer.question.in.premises(query.criterion), query.accuracy);
  message.status = constantOf(region.status);
  describeRegion(region, *region.shape, message);
  if (query.search_box)
  {
    message.use_search_box = true;
    message.min_corner = toMessage(query.search_box->lower);
    message.max_corner = toMessage(query.search_box->upper);
  }
  for (int i = 0; region.size > 0.0 && i < 3; ++i)
    message.joint_ranges.push_back(railRange(region.joint_ranges[static_cast<std::size_t>(i)], machine.leg(i).joint));
  message.boxes = region.boxes;
  message.verification_boxes = region.verification_boxes;
  message.seconds = region.seconds;
  message.message = endingOf(region, machine, query.criterion);
  return message;
}

JointRanges jointRangesOf(const Region& region)
{
  JointRanges message;
  message.header = region.header;
  message.hypotheses = region.hypotheses;
  message.solid = region.solid;
  message.center = region.center;
  message.rails = region.joint_ranges;
  return message;
}

std::string describe(const RegionQuery& query)
{
  TextStream text;
  text << "largest " << query.shape->name();
  if (query.ratio)
    text << ", radius " << query.ratio->lower << " to " << query.ratio->upper << " times its height";
  if (query.search_box)
    text << ", its center from " << query.search_box->lower.format(POINT_TEXT) << " to "
         << query.search_box->upper.format(POINT_TEXT) << " m";
  text << ", " << describe(query.criterion) << ", accuracy " << query.accuracy << " m, within "
       << query.budget.time_limit << " s";
  return text.str();
}

std::string summary(const Answer& answer)
{
  const LargestRegion& region = answer.region;
  TextStream text;
  if (region.size > 0.0)
  {
    text << region.shape->name() << " at " << region.center.format(POINT_TEXT) << " m of frame '"
         << answer.question.in.frame << "', " << region.shape->sizeMeaning() << ' ' << region.size << ", dimensions";
    for (const double length : region.shape->dimensions(region.size))
      text << ' ' << length;
    text << " m";
    if (region.ratio)
      text << ", volume " << region.volume << " m^3";
    text << ". ";
  }
  text << describe(region, *answer.question.in.machine, answer.question.query) << ' '
       << region.boxes + region.verification_boxes << " boxes, " << nearly(region.seconds, 3) << " s";
  return text.str();
}
}  // namespace pkm_workspace
