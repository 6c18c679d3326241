// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/ros/markers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "labels.h"
#include "pkm_workspace/interval/decimal.h"
#include "pkm_workspace/interval/turning.h"
#include "pkm_workspace/region/convex_hull.h"
#include "pkm_workspace/ros/conversions.h"
#include "pkm_workspace/ros/criterion_message.h"
#include "scene.h"
#include "zone_scene.h"

namespace pkm_workspace
{
namespace
{
using visualization_msgs::Marker;

constexpr Color REGION_FACES = { 0.15F, 0.50F, 0.95F, 0.35F };
constexpr Color REGION_EDGES = { 0.05F, 0.25F, 0.60F, 1.0F };
constexpr Color JOINT_RANGE = { 0.95F, 0.45F, 0.05F, 1.0F };

Eigen::Vector3d sidesOf(const Region& region)
{
  return Eigen::Map<const Eigen::Vector3d>(region.solid.dimensions.data());
}

/// Where a point of the solid, or a vertex, is that is so far from the center.
Eigen::Vector3d placeOf(const Region& region, const Eigen::Vector3d& offset)
{
  return fromMessage(region.center) + turnedAboutZ(offset, region.angle);
}

/// The corner of a box whose bit for an axis says: upper face.
Eigen::Vector3d corner(const Region& region, const Eigen::Vector3d& sides, unsigned bits)
{
  const Eigen::Vector3d signs((bits & 1U) ? 0.5 : -0.5, (bits & 2U) ? 0.5 : -0.5, (bits & 4U) ? 0.5 : -0.5);
  return placeOf(region, signs.cwiseProduct(sides));
}

/// All faces as triangles, each seen from both sides: a cube of zero thickness would put rviz's display into warning.
void addFaces(const Region& region, const Eigen::Vector3d& sides, Scene& scene)
{
  Marker& faces = scene.add("region", Marker::TRIANGLE_LIST, REGION_FACES);
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const unsigned u = 1U << (axis + 1) % 3;
    const unsigned v = 1U << (axis + 2) % 3;
    const bool flat = sides[static_cast<int>(axis)] == 0.0;
    for (const unsigned face : { 0U, 1U << axis })
      if (face == 0U || !flat)
        for (const unsigned bits : { face, face | u, face | u | v, face, face | u | v, face | v })
          faces.points.push_back(toMessage(corner(region, sides, bits)));
  }
}

void addEdges(const Region& region, const Eigen::Vector3d& sides, Scene& scene)
{
  Marker& edges = scene.add("region", Marker::LINE_LIST, REGION_EDGES);
  edges.scale.x = 6.0 * scene.unit();
  for (unsigned bits = 0; bits < 8; ++bits)
    for (const unsigned axis : { 1U, 2U, 4U })
      if ((bits & axis) == 0U)
        for (const unsigned end : { bits, bits | axis })
          edges.points.push_back(toMessage(corner(region, sides, end)));
}

/// A point at an angle on a circle of that radius across one axis.
Eigen::Vector3d onCircle(const Eigen::Vector3d& center, double radius, int axis, int step)
{
  constexpr int STEPS = 72;
  const double angle = 2.0 * M_PI * step / STEPS;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  offset[(axis + 1) % 3] = radius * std::cos(angle);
  offset[(axis + 2) % 3] = radius * std::sin(angle);
  return center + offset;
}

void addCircle(const Eigen::Vector3d& center, double radius, int axis, Scene& scene)
{
  Marker& circle = scene.add("region", Marker::LINE_STRIP, REGION_EDGES);
  circle.scale.x = 6.0 * scene.unit();
  for (int step = 0; step <= 72; ++step)
    circle.points.push_back(toMessage(onCircle(center, radius, axis, step)));
}

/// A ball with its great circles along the axes.
void addSphere(const Eigen::Vector3d& center, double radius, Scene& scene)
{
  Marker& ball = scene.add("region", Marker::SPHERE, REGION_FACES);
  ball.pose.position = toMessage(center);
  ball.scale.x = ball.scale.y = ball.scale.z = 2.0 * radius;
  for (int axis = 0; axis < 3; ++axis)
    addCircle(center, radius, axis, scene);
}

/// Triangles seen from both sides, as for a square.
void addDisc(const Eigen::Vector3d& center, double radius, Scene& scene)
{
  Marker& faces = scene.add("region", Marker::TRIANGLE_LIST, REGION_FACES);
  for (int step = 0; step < 72; ++step)
    for (const Eigen::Vector3d& point :
         { center, onCircle(center, radius, 2, step), onCircle(center, radius, 2, step + 1) })
      faces.points.push_back(toMessage(point));
  addCircle(center, radius, 2, scene);
}

void addBox(const Region& region, Scene& scene)
{
  const Eigen::Vector3d sides = sidesOf(region);
  addFaces(region, sides, scene);
  addEdges(region, sides, scene);
}

/// Its triangles from both sides, and the edges at which these are not in one plane.
void addPolytope(const Region& region, Scene& scene)
{
  std::vector<Eigen::Vector3d> corners;
  for (const geometry_msgs::Point& vertex : region.vertices)
    corners.push_back(fromMessage(vertex));
  const std::vector<HullTriangle> triangles = convexHull(corners);
  for (Eigen::Vector3d& corner : corners)
    corner = placeOf(region, region.size * corner);
  Marker& faces = scene.add("region", Marker::TRIANGLE_LIST, REGION_FACES);
  std::map<std::pair<std::size_t, std::size_t>, Eigen::Vector3d> normals;
  for (const auto& [a, b, c] : triangles)
  {
    const Eigen::Vector3d normal = (corners[b] - corners[a]).cross(corners[c] - corners[a]).normalized();
    for (const auto& [from, to] : { std::pair(a, b), std::pair(b, c), std::pair(c, a) })
      normals[{ from, to }] = normal;
    for (const std::size_t corner : { a, b, c })
      faces.points.push_back(toMessage(corners[corner]));
  }
  Marker& edges = scene.add("region", Marker::LINE_LIST, REGION_EDGES);
  edges.scale.x = 6.0 * scene.unit();
  for (const auto& [edge, normal] : normals)
    if (edge.first < edge.second && normal.dot(normals[{ edge.second, edge.first }]) < 1.0 - 1e-9)
      for (const std::size_t end : { edge.first, edge.second })
        edges.points.push_back(toMessage(corners[end]));
}

/// With circles around both ends.
void addCylinder(const Eigen::Vector3d& center, double height, double radius, Scene& scene)
{
  Marker& body = scene.add("region", Marker::CYLINDER, REGION_FACES);
  body.pose.position = toMessage(center);
  body.scale.x = body.scale.y = 2.0 * radius;
  body.scale.z = height;
  for (const double end : { -0.5, 0.5 })
    addCircle(center + end * height * Eigen::Vector3d::UnitZ(), radius, 2, scene);
}

void addRound(const Region& region, Scene& scene)
{
  const Eigen::Vector3d center = fromMessage(region.center);
  const std::vector<double>& dimensions = region.solid.dimensions;
  const double radius = dimensions.back();
  const bool is_sphere = dimensions.size() == 1;
  const double height = is_sphere ? 2.0 * radius : dimensions.front();
  if (is_sphere)
    addSphere(center, radius, scene);
  else if (height > 0.0)
    addCylinder(center, height, radius, scene);
  else
    addDisc(center, radius, scene);
}

/// "cube 0.6439 m", "box 0.2 x 0.2 x 0.1 m", "cylinder 0.1 m high, radius 0.2 m"
std::string nameOf(const Region& region)
{
  const std::vector<double>& dimensions = region.solid.dimensions;
  const auto text = [](double value) { return digits(value, roundedDown); };
  if (dimensions.empty())
    return region.shape + " times " + text(region.size);
  const bool is_box = region.solid.type == shape_msgs::SolidPrimitive::BOX;
  if (!is_box && dimensions.size() > 1 && dimensions[0] > 0.0)
    return region.shape + ' ' + text(dimensions[0]) + " m high, radius " + text(dimensions[1]) + " m";
  if (!is_box)
    return region.shape + " of radius " + text(dimensions.back()) + " m";
  if (region.shape != Region::BOX)
    return region.shape + ' ' + text(dimensions[0]) + " m";
  return region.shape + ' ' + text(dimensions[0]) + " x " + text(dimensions[1]) +
         (dimensions[2] > 0.0 ? " x " + text(dimensions[2]) : "") + " m";
}

void addRegion(const Region& region, const LabelPlaces& places, Scene& scene)
{
  if (!region.vertices.empty())
    addPolytope(region, scene);
  else
    region.solid.type == shape_msgs::SolidPrimitive::BOX ? addBox(region, scene) : addRound(region, scene);
  const std::string turn = region.turned ? "\nturned by " + nearly(region.angle * 180.0 / M_PI, 4) + " degrees" : "";
  scene.addText("region", places.ofRegion(), nameOf(region) + turn);
}

void addJointRange(const RailRange& range, const Leg& leg, const Eigen::Vector3d& tool, const Eigen::Vector3d& label,
                   Scene& scene)
{
  Marker& bar = scene.add("joint_ranges", Marker::LINE_LIST, JOINT_RANGE);
  bar.scale.x = 20.0 * scene.unit();
  addWay(leg, range.lower, range.upper, tool, bar.points);
  scene.addText("joint_ranges", label,
                range.joint + '\n' + digits(range.stroke_upper_bound, roundedUp) + " " + unitOf(leg));
}

double unitOf(const Machine& machine)
{
  return machine.scale() / 1000.0;
}

/// rviz draws what is opaque first, so that a set around a region would be seen over its lines; and of the rest first
/// what is far from whoever looks, mostly from above, by the places of markers. So these become nearly opaque, with a
/// place a little above the others'.
void drawLinesOver(double step, visualization_msgs::MarkerArray& array)
{
  for (Marker& marker : array.markers)
  {
    if (marker.ns != "region" || (marker.type != Marker::LINE_LIST && marker.type != Marker::LINE_STRIP))
      continue;
    marker.color.a = 0.99F;
    marker.pose.position.z = step;
    for (geometry_msgs::Point& point : marker.points)
      point.z -= step;
  }
}
}  // namespace

visualization_msgs::MarkerArray markersOf(const Region& region, const Premises& premises, const Machine& machine,
                                          const DrawnRails& rails, const SetPicture* set)
{
  Scene scene(region.header, unitOf(machine), captionOf(premises, "accuracy", region.hypotheses.accuracy));
  const LabelPlaces places(region, machine, rails, scene.unit());
  if (region.size > 0.0)
    addRegion(region, places, scene);
  addZones(premises.criterion.zones, machine.scale(), scene);
  if (set)
    set->addTo(scene, "paving_inside", "paving_boundary");
  for (std::size_t i = 0; i < region.joint_ranges.size(); ++i)
    addJointRange(region.joint_ranges[i], machine.leg(static_cast<int>(i)), fromMessage(region.center),
                  places.ofRail(i), scene);
  visualization_msgs::MarkerArray array = scene.array();
  if (set && set->isSolid())
    drawLinesOver(64.0 * scene.unit(), array);
  return array;
}

visualization_msgs::MarkerArray markersOf(const SetPicture& set, const Premises& premises, const Machine& machine,
                                          const Workspace& workspace, double ceiling)
{
  Scene scene(workspace.header, unitOf(machine), captionOf(premises, "resolution", workspace.hypotheses.accuracy));
  set.addTo(scene, "inside", "boundary", ceiling);
  return scene.array();
}

Eigen::Vector3d placeOfHypotheses(const Region& region, const Machine& machine, const DrawnRails& rails)
{
  return LabelPlaces(region, machine, rails, unitOf(machine)).ofHypotheses();
}

visualization_msgs::MarkerArray inRoot(visualization_msgs::MarkerArray array, const FramedMachine& in,
                                       const std::string& root)
{
  if (in.frame == root)
    return array;
  const Eigen::Isometry3d move = in.toRoot();
  for (visualization_msgs::Marker& marker : array.markers)
  {
    const geometry_msgs::Quaternion& q = marker.pose.orientation;
    const Eigen::Quaterniond turned(move.rotation() * Eigen::Quaterniond(q.w, q.x, q.y, q.z));
    marker.header.frame_id = root;
    marker.pose.position = toMessage(move * fromMessage(marker.pose.position));
    marker.pose.orientation = toMessage(turned);
  }
  return array;
}
}  // namespace pkm_workspace
