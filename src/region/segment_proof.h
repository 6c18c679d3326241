// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "path_looks.h"

namespace pkm_workspace
{
/// Pieces that are looked at side by side.
constexpr std::size_t PIECES = 8;

/// Encloses both.
void merge(const PieceMotion& motion, PieceMotion& sum);
/// What merge() begins with.
PieceMotion noMotion();

/// Follows one segment from its start until its verdict is proved or doubles end.
class SegmentProof
{
public:
  /// @param to_the_end whether the open parts are wanted as narrow as doubles allow, or only the verdict
  SegmentProof(const Way& way, PathLooks& looks, bool to_the_end);

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

  const Way& way_;
  PathLooks& looks_;
  const bool to_the_end_;
  const std::size_t most_open_;  ///< open parts that are told apart
  SegmentCheck result_;
  std::vector<PathPart> open_;
  std::optional<double> seen_bad_;  ///< a point that is proved bad, with others before it that are not looked at yet
  PieceMotion motion_ = noMotion();
};
}  // namespace pkm_workspace
