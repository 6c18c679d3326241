// SPDX-License-Identifier: BSD-3-Clause
#include "urdf_text.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "number_text.h"
#include "tolerance_elements.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

std::string drawnText(double value)
{
  return roundedText(std::abs(value) < 1e-9 ? 0.0 : value, 6);
}

std::string drawnText(const Vector3d& v)
{
  return drawnText(v.x()) + " " + drawnText(v.y()) + " " + drawnText(v.z());
}

/// Roll, pitch and yaw of a rotation [rad]; entries of nearly 0 are 0, or their noise would choose among equal angles.
Vector3d anglesOf(const Matrix3d& rotation)
{
  const Matrix3d r = rotation.unaryExpr([](double x) { return std::abs(x) < 1e-9 ? 0.0 : x; });
  const double cosine = std::hypot(r(0, 0), r(1, 0));
  const double pitch = std::atan2(-r(2, 0), cosine);
  if (cosine < 1e-9)  // yaw and roll turn about one axis
    return { std::atan2(-r(1, 2), r(1, 1)), pitch, 0.0 };
  return { std::atan2(r(2, 1), r(2, 2)), pitch, std::atan2(r(1, 0), r(0, 0)) };
}

/// Rz(yaw) Ry(pitch) Rx(roll); of no turns exactly the identity.
Matrix3d turn(const Vector3d& rpy)
{
  return (Eigen::AngleAxisd(rpy.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vector3d::UnitY()) *
          Eigen::AngleAxisd(rpy.x(), Vector3d::UnitX()))
      .toRotationMatrix();
}
}  // namespace

UrdfText::UrdfText(const std::string& robot) : robot_(robot), axes_{ { "base_link", Matrix3d::Identity() } }
{
  open("robot", { { "name", robot } });
  for (const Material& one : materials())
    material(one);
}

void UrdfText::open(const char* element, const Attributes& attributes)
{
  printer_.OpenElement(element);
  for (const auto& attribute : attributes)
    printer_.PushAttribute(attribute.first, attribute.second.c_str());
}

void UrdfText::element(const char* name, const Attributes& attributes)
{
  open(name, attributes);
  printer_.CloseElement();
}

void UrdfText::material(const Material& material)
{
  open("material", { { "name", material.name } });
  element("color", { { "rgba", material.rgba } });
  printer_.CloseElement();
}

void UrdfText::tolerances(const Tolerances& tolerances, const std::array<std::string, 3>& rails)
{
  for (const Attributes& attributes : toleranceAttributes(tolerances, rails))
    element(TOLERANCES, attributes);
}

void UrdfText::comment(const std::string& text)
{
  printer_.PushComment((" " + text + " ").c_str());
}

Vector3d UrdfText::inLink(const std::string& link, const Vector3d& v) const
{
  return axes_.at(link).transpose() * v;
}

void UrdfText::visual(const Solid& solid, const Matrix3d& axes)
{
  const Vector3d center = axes.transpose() * solid.center;
  open("visual");
  element("origin",
          { { "xyz", drawnText(center) }, { "rpy", drawnText(anglesOf(axes.transpose() * solid.rotation)) } });
  open("geometry");
  const std::string radius = drawnText(solid.size[0]);
  if (solid.shape == Solid::Shape::BOX)
    element("box", { { "size", drawnText(solid.size) } });
  else if (solid.shape == Solid::Shape::CYLINDER)
    element("cylinder", { { "radius", radius }, { "length", drawnText(solid.size[2]) } });
  else
    element("sphere", { { "radius", radius } });
  printer_.CloseElement();
  element("material", { { "name", solid.material } });
  printer_.CloseElement();
}

void UrdfText::link(const std::string& name, const std::vector<Solid>& solids)
{
  const Matrix3d& axes = axes_.emplace(name, Matrix3d::Identity()).first->second;
  open("link", { { "name", name } });
  for (const Solid& solid : solids)
    visual(solid, axes);
  printer_.CloseElement();
}

/// Of a joint that turns all around, speed and effort, where they are known.
void UrdfText::limit(const JointText& joint)
{
  Attributes attributes;
  if (joint.limits)
    attributes = { { "lower", numberText(joint.limits->first) }, { "upper", numberText(joint.limits->second) } };
  else if (joint.effort == 0.0 && joint.speed == 0.0)
    return;
  attributes.emplace_back("effort", numberText(joint.effort));
  attributes.emplace_back("velocity", numberText(joint.speed));
  element("limit", attributes);
}

void UrdfText::branch(const JointText& joint, const std::vector<Solid>& solids)
{
  if (joint.name.empty() || !joints_.insert(joint.name).second)
    throw std::invalid_argument("machine '" + robot_ + "' cannot be written as a URDF: joint name '" + joint.name +
                                "' is empty or another joint's, expected a name of its own");
  open("joint", { { "name", joint.name }, { "type", joint.type } });
  element("parent", { { "link", joint.parent } });
  element("child", { { "link", joint.child } });
  const Vector3d rpy(joint.origin.rpy.data());
  if (rpy.isZero(0.0))
    element("origin", { { "xyz", vectorText(joint.origin.xyz) } });
  else
    element("origin", { { "xyz", vectorText(joint.origin.xyz) }, { "rpy", vectorText(rpy) } });
  if (!joint.axis.isZero(0.0))
    element("axis", { { "xyz", vectorText(joint.axis) } });
  if (!joint.master.empty())
    element("mimic", { { "joint", joint.master }, { "multiplier", numberText(joint.multiplier) } });
  limit(joint);
  printer_.CloseElement();
  const Matrix3d parent = axes_.emplace(joint.parent, Matrix3d::Identity()).first->second;
  axes_.emplace(joint.child, parent * turn(rpy));
  link(joint.child, solids);
}

std::string UrdfText::finish()
{
  printer_.CloseElement();
  return std::string("<?xml version=\"1.0\"?>\n") + printer_.CStr();
}
}  // namespace urdf_io
}  // namespace pkm_workspace
