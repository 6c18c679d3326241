// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>

#include "exact_length.h"
#include "gcode_block.h"
#include "pkm_workspace/import/gcode_job.h"

namespace pkm_workspace
{
namespace gcode
{
/// Femtometres along X, Y, Z.
using Place = std::array<std::int64_t, 3>;
constexpr char AXES[] = "XYZ";
constexpr char CENTERS[] = "IJK";

/// Where the zero of the program's coordinates is, seen from the controller's.
class Offsets
{
public:
  explicit Offsets(const GcodeSetup& setup);

  std::int64_t at(std::size_t axis) const { return systems_[system_][axis] + shift_[axis] + (axis == 2 ? tool_ : 0); }
  /// G54 to G59.3, G43, G49.
  void select(Block& block);
  /// G10 L2.
  void set(Block& block, const Unit& unit);
  /// G92: the tool's place has these coordinates. @param place of the controller's coordinates
  void shift(std::size_t axis, std::int64_t place, std::int64_t coordinate);
  /// G92.1, G92.2, G92.3.
  void changeShift(int code);

private:
  std::array<Place, GcodeSetup::SYSTEMS> systems_;
  std::map<int, std::int64_t> lengths_;
  std::size_t system_ = 0;
  std::int64_t tool_ = 0;
  Place shift_{}, kept_shift_{};
};

/// A length in metres as it is written, of an option.
std::int64_t fromMetres(double metres);
Place fromMetres(const Eigen::Vector3d& metres);
Place difference(const Place& a, const Place& b);
/// A whole number from @p least to @p most.
int readWhole(char letter, std::string_view number, int least, int most);
}  // namespace gcode

/// The modes of a job, and where the tool is.
class GcodeJob::State
{
public:
  explicit State(const GcodeSetup& setup);

  std::optional<GcodeMove> read(const std::string& line);
  std::size_t line() const { return lines_; }
  GcodeSummary summary() const;

private:
  void execute(gcode::Block& block);
  void setFeed(gcode::Block& block);
  void setModes(gcode::Block& block);
  /// What holds in its own line, but for G53. @return whether it has taken the axes of the line
  bool doOnce(gcode::Block& block);
  void shift(gcode::Block& block);
  void loseTool();
  std::optional<GcodeMove> move(gcode::Block& block);
  gcode::Place target(gcode::Block& block, std::array<bool, 3>& is_known) const;
  void setFeedOf(gcode::Block& block, GcodeMove& move) const;
  void setArc(gcode::Block& block, const gcode::Place& end, GcodeMove& move) const;
  void setCenter(gcode::Block& block, std::size_t normal, GcodeMove& move) const;
  void setCenterByRadius(gcode::Block& block, std::size_t normal, GcodeMove& move) const;
  Eigen::Vector3d inRoot(const gcode::Place& place) const;
  bool isKnown() const { return is_known_[0] && is_known_[1] && is_known_[2]; }
  void count(gcode::Block& block);

  const gcode::Place origin_;
  const bool rapids_have_feed_;
  gcode::Offsets offsets_;
  gcode::Place place_{};  ///< of the tool, in the controller's coordinates
  std::array<bool, 3> is_known_{};
  int motion_ = gcode::NO_CODE;
  int plane_ = 170;
  gcode::Unit unit_ = gcode::MILLIMETRES;
  bool is_relative_ = false;
  bool has_absolute_centers_ = false;
  bool has_inverse_time_ = false;
  std::optional<std::int64_t> feed_;  ///< femtometres in a minute
  std::size_t lines_ = 0;
  GcodeSummary summary_;
  std::array<std::size_t, 26> ignored_letters_{};
  std::map<int, std::size_t> ignored_g_, ignored_m_;
};
}  // namespace pkm_workspace
