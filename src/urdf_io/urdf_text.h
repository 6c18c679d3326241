// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "looks.h"
#include "pkm_workspace/machine/tolerances.h"
#include "placement.h"

namespace pkm_workspace
{
namespace urdf_io
{
/// A joint as it is written; what is left at its default is not.
struct JointText
{
  std::string name;
  std::string type;
  std::string parent;
  std::string child;
  Origin origin;
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  std::string master = "";                               ///< whom it follows
  double multiplier = 1.0;                               ///< in doing so
  std::optional<std::pair<double, double>> limits = {};  ///< [m, rad]
  double speed = 0.0;                                    ///< of a driven joint [m/s, rad/s]; 0 where none is known
  double effort = 0.0;                                   ///< on a driven joint [N, N m]; 0 where none is known
};

/// Writes the elements of a URDF, below a link "base_link" with the machine's axes. Numbers of joints read back as the
/// same doubles; what is only drawn is rounded, so that the text is the same on every machine.
class UrdfText
{
public:
  explicit UrdfText(const std::string& robot);

  void comment(const std::string& text);
  /// The root, or another link whose axes are the machine's.
  void link(const std::string& name, const std::vector<Solid>& solids = {});
  /// The joint and its child link. @throws std::invalid_argument when its name is empty or another joint's
  void branch(const JointText& joint, const std::vector<Solid>& solids = {});
  /// A vector of the machine's axes, in those of a link that was written.
  Eigen::Vector3d inLink(const std::string& link, const Eigen::Vector3d& v) const;
  /// What @p tolerances are given for these joints.
  void tolerances(const Tolerances& tolerances, const std::array<std::string, 3>& rails);
  /// Ends the robot. @return the whole text
  std::string finish();

private:
  using Attributes = std::vector<std::pair<const char*, std::string>>;
  void open(const char* element, const Attributes& attributes = {});
  void element(const char* name, const Attributes& attributes);
  void material(const Material& material);
  void limit(const JointText& joint);
  void visual(const Solid& solid, const Eigen::Matrix3d& axes);

  tinyxml2::XMLPrinter printer_;
  std::string robot_;
  std::set<std::string> joints_;
  std::map<std::string, Eigen::Matrix3d> axes_;  ///< of each link, at zero, in the machine's
};
}  // namespace urdf_io
}  // namespace pkm_workspace
