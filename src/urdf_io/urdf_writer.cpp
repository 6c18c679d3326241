// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/urdf_io/urdf_writer.h"

#include "urdf_text.h"

namespace pkm_workspace
{
using namespace urdf_io;

namespace
{
using Eigen::Vector3d;

/// The passive joints and links of one leg; their names end on its number.
class LegText
{
public:
  LegText(UrdfText& text, const LegNumbers& leg, const LegLooks& looks, const std::string& number)
    : text_(text), leg_(leg), looks_(looks), number_(number)
  {}

  /// From the rail to the tool point: what readUrdf() reads.
  void writeChain() const
  {
    JointText rail{ leg_.joint, "prismatic", "base_link", numbered("slider"), leg_.origin, leg_.axis };
    rail.limits = { leg_.lower, leg_.upper };
    text_.branch(rail, looks_.slider);
    text_.branch(hinge("revolute", "slider", "knuckle", Vector3d::Zero(), leg_.revolute), { looks_.short_bar });
    text_.branch(hinge("parallelogram", "knuckle", "strut", Vector3d::Zero(), leg_.parallelogram));
    text_.branch(
        follower("parallelogram", -1.0, "parallelogram_back", "strut", "wrist", leg_.strut, leg_.parallelogram),
        { looks_.short_bar });
    text_.branch(follower("revolute", -1.0, "revolute_back", "wrist", "tip", Vector3d::Zero(), leg_.revolute),
                 looks_.tip);
    text_.branch({ numbered("tcp_joint"), "fixed", numbered("tip"), numbered("tcp"), -leg_.platform });
  }

  /// The two bars of the parallelogram, beside the strut: what rviz shows.
  void writeBars() const
  {
    const Vector3d half_width = looks_.half_width;
    text_.branch(follower("parallelogram", 1.0, "bar_joint_a", "knuckle", "bar_a", half_width, leg_.parallelogram),
                 { looks_.bar });
    text_.branch(follower("parallelogram", 1.0, "bar_joint_b", "knuckle", "bar_b", -half_width, leg_.parallelogram),
                 { looks_.bar });
  }

private:
  std::string numbered(const std::string& name) const { return name + "_" + number_; }
  JointText hinge(const char* name, const char* parent, const char* child, const Vector3d& origin,
                  const Vector3d& axis) const
  {
    return { numbered(name), "continuous", numbered(parent), numbered(child), origin, axis };
  }
  JointText follower(const char* master, double multiplier, const char* name, const char* parent, const char* child,
                     const Vector3d& origin, const Vector3d& axis) const
  {
    JointText joint = hinge(name, parent, child, origin, axis);
    joint.master = numbered(master);
    joint.multiplier = multiplier;
    return joint;
  }

  UrdfText& text_;
  const LegNumbers& leg_;
  const LegLooks& looks_;
  std::string number_;
};

}  // namespace

std::string writeUrdf(const Machine& machine)
{
  const auto numbers = numbersOf(machine);
  const Looks looks = looksOf(numbers);
  UrdfText text(machine.name());
  text.link("base_link", { looks.legs[0].rail, looks.legs[1].rail, looks.legs[2].rail });
  for (std::size_t i = 0; i < 3; ++i)
  {
    const LegText leg(text, numbers[i], looks.legs[i], std::to_string(i + 1));
    leg.writeChain();
    leg.writeBars();
  }
  text.branch({ "platform_joint", "fixed", "tcp_1", "platform", Vector3d::Zero() }, looks.platform);
  return text.finish();
}
}  // namespace pkm_workspace
