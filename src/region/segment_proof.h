// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "pkm_workspace/region/path_check.h"

namespace pkm_workspace
{
/// Pieces that are looked at side by side.
constexpr std::size_t PIECES = 8;

/// What many looks have in common.
class PathLooks
{
public:
  PathLooks(const BoxKernel& kernel, const PathQuery& query) : kernel_(kernel), query_(query) {}

  std::int64_t count() const { return count_; }
  /// What has ended the looks, once isOver() has said so.
  PathResult::End end() const { return end_; }

  /// Adds the share of so many pieces that a path has at first.
  void allowFor(std::int64_t pieces) { pieces_ += pieces; }

  bool isOver()
  {
    const bool is_stopped = query_.stop != nullptr && *query_.stop;
    const bool is_over = is_stopped || count_ >= query_.max_looks + pieces_ * query_.looks_per_piece;
    if (is_over)
      end_ = is_stopped ? PathResult::End::STOPPED : PathResult::End::LOOKS;
    return is_over;
  }

  /// @param motions may be nullptr
  void look(const CurvePiece* pieces, std::size_t count, BoxVerdict* verdicts, PieceMotion* motions)
  {
    kernel_.look(pieces, count, verdicts, motions);
    count_ += static_cast<std::int64_t>(count);
  }

private:
  const BoxKernel& kernel_;
  const PathQuery& query_;
  std::int64_t count_ = 0;
  std::int64_t pieces_ = 0;
  PathResult::End end_ = PathResult::End::COMPLETE;
};

/// Encloses both.
void merge(const PieceMotion& motion, PieceMotion& sum);
/// What merge() begins with.
PieceMotion noMotion();

/// Follows one segment from its start until its verdict is proved or doubles end.
class SegmentProof
{
public:
  /// @param to_the_end whether the open parts are wanted as narrow as doubles allow, or only the verdict
  SegmentProof(const Curve& curve, PathLooks& looks, bool to_the_end);

  SegmentCheck run();
  /// What the machine does, after INSIDE.
  const PieceMotion& motion() const { return motion_; }
  /// As PathOffence has them, unless INSIDE.
  const std::vector<PathPart>& open() const { return open_; }

private:
  bool advance(double first, double last);
  bool pass(double first, double last, BoxVerdict verdict, const PieceMotion& motion);
  bool refute(double bad_at);
  bool leaveOpen(double first, double last);
  bool seekBad(double from);
  bool isBesideOpen(double first) const;
  double leastPiece(double first) const;

  const Curve& curve_;
  PathLooks& looks_;
  const bool to_the_end_;
  const std::size_t most_open_;  ///< open parts that are told apart
  SegmentCheck result_;
  std::vector<PathPart> open_;
  std::optional<double> seen_bad_;  ///< a point that is proved bad, with others before it that are not looked at yet
  PieceMotion motion_ = noMotion();
};
}  // namespace pkm_workspace
