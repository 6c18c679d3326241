// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "pkm_workspace/interval/interval.h"

namespace pkm_workspace
{
/// What a job of G-code does not say by itself. Lengths [m], along the axes of the machine's root frame.
struct GcodeSetup
{
  static constexpr std::size_t SYSTEMS = 9;  ///< G54 to G59.3

  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of the controller's coordinates (G53), in the root frame
  std::array<Eigen::Vector3d, SYSTEMS> work_offsets = allZero();  ///< of G54 to G59.3, until G10 L2 sets others
  std::map<int, double> tool_lengths = {};                        ///< for G43 H, by number
  std::map<int, double> tool_diameters = {};                      ///< for G41 D and G42 D, which only rs274 reads
  std::optional<Eigen::Vector3d> start = {};  ///< where the tool is before the job, in the root frame; or unknown
  bool rapids_have_feed = false;              ///< whether G0 goes at the feed in effect, as printers have it

private:
  static std::array<Eigen::Vector3d, SYSTEMS> allZero()
  {
    std::array<Eigen::Vector3d, SYSTEMS> all;
    all.fill(Eigen::Vector3d::Zero());
    return all;
  }
};

/// One move of the tool. Points and directions [m] in the machine's root frame, each number the double nearest to what
/// the job says.
struct GcodeMove
{
  enum class Kind
  {
    POINT,  ///< where the tool is known to be again, at its end
    LINE,
    ARC  ///< an arc, a full circle where start and end are above each other, or a helix
  };
  /// What the value of the feed is.
  enum class Feed
  {
    NONE,     ///< of a rapid move, and of a point
    SPEED,    ///< the tool's speed [m/s]
    PER_TIME  ///< moves in a second [1/s]
  };

  Kind kind = Kind::LINE;
  bool is_rapid = false;
  Eigen::Vector3d start, end;
  Eigen::Vector3d center;  ///< of an arc, beside its start
  Eigen::Vector3d axis;    ///< of an arc, counter-clockwise seen from its tip
  int turns = 1;           ///< of an arc: 2 is a whole turn more than 1
  Feed feed = Feed::NONE;
  Interval feed_value = Interval(0.0);
};

/// What became of the lines of a job.
struct GcodeSummary
{
  std::size_t moves = 0;          ///< handed out, but for points
  std::size_t unknown_moves = 0;  ///< that begin or end where the job does not say: they are not handed out
  std::size_t first_unknown = 0;  ///< the line of the first of these, from 1 on
  std::map<std::string, std::size_t> ignored = {};  ///< words and codes without effect on the path, with their counts
  bool has_ended = false;                           ///< by M2 or M30
};

/// Reads a job line by line.
class MoveReader
{
public:
  virtual ~MoveReader() = default;

  /// @return the move that the line makes, if any; none after the end of the job
  /// @throws std::invalid_argument with the reason where the line is refused; the job cannot be checked then, but
  /// further lines can be read
  virtual std::optional<GcodeMove> read(const std::string& line) = 0;
  /// The line of the job, from 1 on, that what was read last stands for.
  virtual std::size_t line() const = 0;
  virtual GcodeSummary summary() const = 0;
};

/// Reads the lines of a job of G-code: the subset of RS-274 that docs/gcode.md lists. What may move the tool and is not
/// in the subset is refused.
class GcodeJob : public MoveReader
{
public:
  explicit GcodeJob(const GcodeSetup& setup);
  ~GcodeJob() override;

  std::optional<GcodeMove> read(const std::string& line) override;
  std::size_t line() const override;
  GcodeSummary summary() const override;

private:
  class State;
  std::unique_ptr<State> state_;
};
}  // namespace pkm_workspace
