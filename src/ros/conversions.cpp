// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/conversions.h"

#include <stdexcept>

#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/interval/text_stream.h"
#include "pkm_workspace/region/turned_region.h"
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

geometry_msgs::Vector3 asVector(const Eigen::Vector3d& v)
{
  geometry_msgs::Vector3 message;
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
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
/// What K measures along the axes.
Eigen::Vector3d proportionsOf(const Shape& shape)
{
  return 2.0 * shape.halfExtents().per_size;
}

std::optional<double> givenOf(double value)
{
  return value == 0.0 ? std::nullopt : std::optional(value);
}

/// The shape that a request asks for, with its own measures.
ShapeWish shapeOf(const RegionRequest& request)
{
  const auto require_both = [](const char* names, double first, double second) {
    if ((first == 0.0) != (second == 0.0))
      throw std::invalid_argument(std::string(names) + " must both be given, or both be 0: one of them is 0");
    return first != 0.0;
  };
  ShapeWish wish;
  wish.name = request.shape;
  const Eigen::Vector3d sides(request.proportions.x, request.proportions.y, request.proportions.z);
  if (sides != Eigen::Vector3d::Zero())
    wish.proportions = sides;
  if (require_both("ratio_min and ratio_max", request.ratio_min, request.ratio_max))
    wish.ratio = RatioRange{ request.ratio_min, request.ratio_max };
  if (require_both("footprint_x and footprint_y", request.footprint_x, request.footprint_y))
    wish.footprint = std::array<double, 2>{ request.footprint_x, request.footprint_y };
  for (const geometry_msgs::Point& vertex : request.vertices)
    wish.vertices.push_back(fromMessage(vertex));
  wish.radius = givenOf(request.radius);
  wish.height = givenOf(request.height);
  return wish;
}

/// The same with what the node has where the request leaves it.
ShapeWish shapeOf(const RegionRequest& request, const ShapeWish& own)
{
  ShapeWish wish = shapeOf(request);
  if (wish.name.empty())
    wish.name = own.name;
  return wish.hasMeasures() ? wish : own.as(wish.name);
}

/// Where the region may be: as the request says, or else as the node has it and the shape can.
PlaceWish placeOf(const RegionRequest& request, const PlaceWish& own, const Shape& shape, Problems& problems)
{
  PlaceWish wish;
  wish.search_box =
      readCorners(request.use_search_box, request.min_corner, request.max_corner, "use_search_box", problems);
  const Eigen::Vector3d center = fromMessage(request.center);
  if (request.use_center)
    wish.center = center;
  else if (center != Eigen::Vector3d::Zero())
    problems.push_back("center must be 0 [m] unless use_center");
  if (request.use_base)
    wish.base_z = request.base_z;
  else if (request.base_z != 0.0)
    problems.push_back("base_z must be 0 [m] unless use_base");
  if (request.turned > RegionRequest::OFF)
    problems.push_back("turned = " + std::to_string(int{ request.turned }) + " must be OWN = 0, ON = 1 or OFF = 2");
  const bool turned =
      request.turned == RegionRequest::OWN ? own.turned && canTurn(shape.kind()) : request.turned == RegionRequest::ON;
  wish.turned = turned;
  if (request.use_search_box || request.use_center || request.use_base)
    return wish;
  wish = own;
  wish.turned = turned;
  if (!shape.standing() && shape.kind() != "polytope")  // of which setPlace() says what is wrong
    wish.base_z.reset();
  return wish;
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
  message.shape = shape.kind();
  message.proportions.x = proportions.x();
  message.proportions.y = proportions.y();
  message.proportions.z = proportions.z();
  const CenteredSolid solid = centeredSolid(shape, region.center, region.size);
  if (!shape.isPolytope())
    message.solid.type = solidType(shape);
  for (const GrowingVector& vertex : shape.isPolytope() ? shape.extremePoints() : std::vector<GrowingVector>())
    message.vertices.push_back(toMessage(vertex.per_size));
  message.solid.dimensions = solid.dimensions;
  message.center = toMessage(solid.center);
  message.turned = region.angle.has_value();
  message.angle = region.angle.value_or(0.0);
  message.orientation = toMessage(Eigen::Quaterniond(Eigen::AngleAxisd(message.angle, Eigen::Vector3d::UnitZ())));
  message.size = region.size;
  message.size_upper_bound = region.size_upper_bound;
  message.volume = region.volume;
  message.volume_upper_bound = region.volume_upper_bound;
  message.ratio_min = region.ratio ? region.ratio->lower : 0.0;
  message.ratio_max = region.ratio ? region.ratio->upper : 0.0;
}
}  // namespace

RegionQuery fromMessage(const RegionRequest& request, const Machine& machine, const RegionQuery& defaults,
                        const Parameters& own, double longest)
{
  RegionQuery query = defaults;
  Problems problems;
  try
  {
    setShape(shapeOf(request, own.shape), query);
    setPlace(placeOf(request, own.place, *query.shape, problems), query);
  }
  catch (const std::invalid_argument& error)
  {
    problems.push_back(error.what());
  }
  query.criterion = fromMessage(request.criterion, machine, defaults.criterion, problems);
  query.precision = request.multi_precision ? Precision::MULTIPLE : Precision::DOUBLE;
  const bool is_own = query.shape->isPolytope() && own.accuracy == 0.0;  // of a size that nobody had in mind
  query.accuracy = valueOr(request.accuracy, is_own ? defaultAccuracy(machine, *query.shape) : defaults.accuracy);
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
  message.use_base = query.base_z.has_value();
  message.base_z = query.base_z.value_or(0.0);
  if (query.hasSearchBox())
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
  message.orientation = region.orientation;
  message.vertices = region.vertices;
  message.size = region.size;
  message.rails = region.joint_ranges;
  return message;
}
}  // namespace pkm_workspace
