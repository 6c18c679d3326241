// SPDX-License-Identifier: BSD-3-Clause
#include "urdf_text.h"

#include <cmath>
#include <stdexcept>

#include "number_text.h"

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
std::string drawnText(double value)
{
  return roundedText(std::abs(value) < 1e-9 ? 0.0 : value, 6);
}

std::string drawnText(const Eigen::Vector3d& v)
{
  return drawnText(v.x()) + " " + drawnText(v.y()) + " " + drawnText(v.z());
}

/// Roll, pitch and yaw of a rotation [rad]; entries of nearly 0 are 0, or their noise would choose among equal angles.
Eigen::Vector3d anglesOf(const Eigen::Matrix3d& rotation)
{
  const Eigen::Matrix3d r = rotation.unaryExpr([](double x) { return std::abs(x) < 1e-9 ? 0.0 : x; });
  const double cosine = std::hypot(r(0, 0), r(1, 0));
  const double pitch = std::atan2(-r(2, 0), cosine);
  if (cosine < 1e-9)  // yaw and roll turn about one axis
    return { std::atan2(-r(1, 2), r(1, 1)), pitch, 0.0 };
  return { std::atan2(r(2, 1), r(2, 2)), pitch, std::atan2(r(1, 0), r(0, 0)) };
}
}  // namespace

UrdfText::UrdfText(const std::string& robot) : robot_(robot)
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

void UrdfText::visual(const Solid& solid)
{
  open("visual");
  element("origin", { { "xyz", drawnText(solid.center) }, { "rpy", drawnText(anglesOf(solid.rotation)) } });
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
  open("link", { { "name", name } });
  for (const Solid& solid : solids)
    visual(solid);
  printer_.CloseElement();
}

void UrdfText::branch(const JointText& joint, const std::vector<Solid>& solids)
{
  if (joint.name.empty() || !joints_.insert(joint.name).second)
    throw std::invalid_argument("machine '" + robot_ + "' cannot be written as a URDF: joint name '" + joint.name +
                                "' is empty or another joint's, expected a name of its own");
  open("joint", { { "name", joint.name }, { "type", joint.type } });
  element("parent", { { "link", joint.parent } });
  element("child", { { "link", joint.child } });
  element("origin", { { "xyz", vectorText(joint.origin) } });
  if (!joint.axis.isZero(0.0))
    element("axis", { { "xyz", vectorText(joint.axis) } });
  if (!joint.master.empty())
    element("mimic", { { "joint", joint.master }, { "multiplier", numberText(joint.multiplier) } });
  if (joint.type == "prismatic")
    element("limit", { { "lower", numberText(joint.limits.first) },
                       { "upper", numberText(joint.limits.second) },
                       { "effort", "1000" },
                       { "velocity", "1" } });
  printer_.CloseElement();
  link(joint.child, solids);
}

std::string UrdfText::finish()
{
  printer_.CloseElement();
  return std::string("<?xml version=\"1.0\"?>\n") + printer_.CStr();
}
}  // namespace urdf_io
}  // namespace pkm_workspace
