// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "pkm_workspace/dexterity/point_evaluation.h"
#include "pkm_workspace/region/containment.h"
#include "pkm_workspace/region/joint_rates.h"
#include "pkm_workspace/region/path.h"

namespace pkm_workspace
{
/// Speeds of the tool that may be asked for [m/s].
constexpr double SLOWEST_TOOL = 1e-9;
constexpr double FASTEST_TOOL = 1e9;

/// What is asked about a path besides its criterion. Values with defaults; validate() tells what is wrong.
struct PathQuery
{
  double tool_speed = 1.0;                  ///< constant along the path [m/s], from SLOWEST_TOOL to FASTEST_TOOL
  bool steps_have_speeds = false;           ///< which count in place of that one
  JointRateLimits limits = {};              ///< what the joints' speeds and accelerations are held against, ...
  bool holds_limits = false;                ///< ... by the verdict: a point where one is above its limit is bad
  bool wants_rates = false;                 ///< whether the answer has PathRates
  std::size_t most_offences = 0;            ///< segments whose checks say what binds there
  std::int64_t max_looks = 10000000;        ///< pieces looked at before what is left stays undecided, > 0, and ...
  std::int64_t looks_per_piece = 16;        ///< ... as many more for each piece that the path has at first, >= 0
  const std::atomic<bool>* stop = nullptr;  ///< when set, what is left stays undecided

  void validate(Problems& problems) const;
};

/// A segment, and what may be told of it that the query tells of the whole path.
struct PathStep
{
  PathStep(const PathSegment& given) : segment(given) {}  // NOLINT: a segment is a step

  const PathSegment& segment;
  /// Encloses the speed of the tool there [m/s], in place of the query's; 0 where the joints' rates count for nothing.
  std::optional<Interval> tool_speed = {};
  std::optional<std::size_t> id = {};  ///< what it is called in the answer, in place of its index
};

/// What the machine does along a path or a segment: every interval holds the values at all of its points.
struct PathMotion
{
  std::array<Interval, 3> psi;        ///< velocity transmission factors, ascending
  std::array<Interval, 3> joint;      ///< joint values [m]: the travel is their width
  std::array<double, 3> joint_speed;  ///< upper bounds of |rhodot_i| at the tool speed asked for [m/s]
};

/// A part of a segment: first <= t <= last.
struct PathPart
{
  double first = 0.0;
  double last = 0.0;
};

/// Where a path is not, or not surely, good for the first time.
struct PathOffence
{
  std::size_t segment = 0;       ///< index, or the id given
  double good_until = 0.0;       ///< the first offence is at this t of the segment or later, ...
  std::optional<double> bad_at;  ///< ... and at this t or before; nothing where no bad point is proved on the segment
  /// Where exactly it can be: ascending and apart, one at least. Every other point of the segment is proved good, up to
  /// bad_at or its end. The first part begins at good_until; the last one ends at bad_at, where there is that: there
  /// the path leaves the set, if it has not in one of the others, in which it comes within rounding of the border.
  std::vector<PathPart> open = {};
  Eigen::Vector3d point;                ///< nearly the point at bad_at, or at good_until [m]
  Interval tool_speed = Interval(1.0);  ///< of the tool on the segment [m/s]
  Limit limit;                          ///< which condition binds there, and which leg's
};

/// The answer about one segment. Its parameter t runs from 0 to 1.
struct SegmentCheck
{
  Containment verdict = Containment::UNDECIDED;
  double good_until = 0.0;                  ///< all points before this t are proved good; 1 for INSIDE
  std::optional<double> bad_at;             ///< with OUTSIDE: the point at this t is proved bad
  std::optional<PathMotion> motion;         ///< with INSIDE
  std::optional<PathRates> rates;           ///< where they are asked for, whatever the verdict
  std::optional<PathOffence> offence = {};  ///< unless INSIDE, for as many segments as the query says
};

/// The answer about a path.
struct PathResult
{
  /// Why nothing more was looked at.
  enum class End
  {
    COMPLETE,  ///< whatever stays undecided is within rounding of the border
    LOOKS,     ///< some of what stays undecided would need more looks than its share of them
    STOPPED    ///< it was told to stop
  };

  Containment verdict = Containment::INSIDE;  ///< INSIDE iff all segments are, OUTSIDE where one is
  std::vector<SegmentCheck> segments = {};    ///< one for each segment
  std::optional<PathOffence> first = {};      ///< of the first segment that is not INSIDE
  std::optional<PathOffence> proved = {};     ///< of the first segment that is OUTSIDE, which may be a later one
  std::optional<PathMotion> motion = {};      ///< over the whole path, with INSIDE
  std::optional<PathRates> rates = {};        ///< over the whole path, where they are asked for
  std::size_t slowest = 0;  ///< of rates: the segment whose feed has the least lower end, as in PathOffence
  std::int64_t looks = 0;   ///< pieces looked at
  End end = End::COMPLETE;
};

/// Whether every point of a path satisfies the criterion. There is no tolerance: a path that touches the border of
/// the set is OUTSIDE or UNDECIDED, never INSIDE. Segments need not join. An empty path is INSIDE.
///
/// Pieces of the segments are enclosed by boxes with edges along them and looked at as a whole, side by side. On the
/// first segment that is not INSIDE they are divided until doubles end, so that the ends of an open part are neighbours
/// up to rounding where the path crosses the border, and near to each other where it touches it; later segments are
/// divided no further than their verdicts need.
///
/// The path is handed in segment by segment, and takes memory for some of them only.
class PathChecker
{
public:
  /// Called once for each segment, in their order.
  using Tell = std::function<void(const SegmentCheck&)>;

  /// @param evaluator, @param query have to outlive this object
  /// @throws std::invalid_argument when the query is not valid
  PathChecker(const PointEvaluator& evaluator, const PathQuery& query, const Tell& tell);
  ~PathChecker();

  void add(const PathStep& step);
  /// The answer about all segments together, but for the list of them, which is left empty. For one call.
  PathResult finish();

private:
  class Proof;
  std::unique_ptr<Proof> proof_;
};

/// The same for a path at once.
/// @throws std::invalid_argument when the criterion or the query is not valid
PathResult checkPath(const PointEvaluator& evaluator, const std::vector<PathSegment>& segments,
                     const PathQuery& query = {});
PathResult checkPath(const Machine& machine, const Criterion& criterion, const std::vector<PathSegment>& segments,
                     const PathQuery& query = {});
}  // namespace pkm_workspace
