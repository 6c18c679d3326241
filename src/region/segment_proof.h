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
  bool isOver() const { return count_ >= query_.max_looks || (query_.stop != nullptr && *query_.stop); }

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
};

/// Encloses both.
void merge(const PieceMotion& motion, PieceMotion& sum);
/// What merge() begins with.
PieceMotion noMotion();

/// Follows one segment from its start until its verdict is proved or doubles end.
class SegmentProof
{
public:
  SegmentProof(const Curve& curve, PathLooks& looks) : curve_(curve), looks_(looks) {}

  /// @param to_the_end whether good_until and bad_at are wanted as near to each other as doubles allow
  SegmentCheck run(bool to_the_end);
  /// What the machine does, after INSIDE.
  const PieceMotion& motion() const { return motion_; }

private:
  bool advance(double first, double last);
  bool pass(double first, double last, BoxVerdict verdict, const PieceMotion& motion);
  bool seekBad(double from);
  bool canDivide(double first, double last) const;

  const Curve& curve_;
  PathLooks& looks_;
  bool to_the_end_ = true;
  bool is_stuck_ = false;
  SegmentCheck result_;
  PieceMotion motion_ = noMotion();
};
}  // namespace pkm_workspace
