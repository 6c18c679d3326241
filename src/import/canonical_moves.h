// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "canonical_call.h"
#include "gcode_state.h"
#include "pkm_workspace/import/rs274.h"

namespace pkm_workspace
{
namespace gcode
{
/// Where rs274 is told that the tool is as long as that is not known, on every axis [fm]: a place beyond MOST counts as
/// unknown.
constexpr std::int64_t UNKNOWN = 2 * MOST;
/// The line that words N give to what stands before the job.
constexpr std::size_t SETUP_LINE = 0;

/// What canonical calls do to the coordinates of those that follow, and where the tool is.
class CanonicalMoves : public MoveReader
{
public:
  explicit CanonicalMoves(const GcodeSetup& setup);

  std::optional<GcodeMove> read(const std::string& printed) override;
  std::size_t line() const override { return line_; }
  GcodeSummary summary() const override { return summary_; }

private:
  using Does = std::optional<GcodeMove> (CanonicalMoves::*)(const CanonicalCall& call);
  static Does actionOf(const CanonicalCall& call);

  void setLine(const CanonicalCall& call);
  std::optional<GcodeMove> setUnits(const CanonicalCall& call);
  std::optional<GcodeMove> setPlane(const CanonicalCall& call);
  std::optional<GcodeMove> setWorkOffset(const CanonicalCall& call);
  std::optional<GcodeMove> setShift(const CanonicalCall& call);
  std::optional<GcodeMove> setTool(const CanonicalCall& call);
  std::optional<GcodeMove> changeTool(const CanonicalCall& call);
  std::optional<GcodeMove> setRotation(const CanonicalCall& call);
  std::optional<GcodeMove> setFeed(const CanonicalCall& call);
  std::optional<GcodeMove> setFeedMode(const CanonicalCall& call);
  std::optional<GcodeMove> goStraight(const CanonicalCall& call);
  std::optional<GcodeMove> goRound(const CanonicalCall& call);
  std::optional<GcodeMove> end(const CanonicalCall& call);
  std::optional<GcodeMove> leave(const CanonicalCall& call);
  [[noreturn]] std::optional<GcodeMove> refuse(const CanonicalCall& call);

  std::int64_t lengthOf(std::string_view digits) const;
  /// Three lengths; what follows of turning axes has to be 0.
  Place placeOf(const CanonicalCall& call, std::size_t first) const;
  void offset(Place& offset, const Place& to);
  /// In the controller's coordinates, of the program's.
  Place shifted(const Place& program) const;
  Place unshifted(const Place& place) const;
  bool isNear(std::int64_t a, std::int64_t b) const;
  void moveTo(const Place& program);
  std::optional<GcodeMove> go(const Place& program, const GcodeMove& move);
  std::optional<GcodeMove> made(GcodeMove move, const Place& from, bool was_known);
  void setFeedOf(GcodeMove& move) const;
  void requireOneArc(const Place& from, const Place& to) const;
  Eigen::Vector3d inRoot(const Place& place) const;
  bool isKnown() const { return is_known_[0] && is_known_[1] && is_known_[2]; }

  const Place origin_;
  const bool rapids_have_feed_;
  std::int64_t digit_;  ///< the last one that is printed [fm]
  std::size_t normal_ = 2;
  Place work_{}, shift_{}, tool_{};
  std::int64_t rotation_ = 0;  ///< about Z, in units of the last digit of degrees
  std::int64_t feed_ = 0;      ///< in units of the last digit
  bool is_per_turn_ = false;
  Place printed_{};   ///< the numbers of the last move, as offsets have changed them since
  Place believed_{};  ///< where rs274 takes the tool to be, in the controller's coordinates
  Place place_{};     ///< of the tool, in the controller's coordinates
  std::array<bool, 3> is_known_{};
  std::array<bool, 3> is_unsure_{};  ///< whether rs274 may be wrong about it
  std::size_t line_ = SETUP_LINE;
  GcodeSummary summary_;
};
}  // namespace gcode
}  // namespace pkm_workspace
