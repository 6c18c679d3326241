// SPDX-License-Identifier: BSD-3-Clause
// The part of the proof that is about how fast joints go.
#include "path_body_proof.h"

#include <algorithm>

#include "path_looks.h"

namespace pkm_workspace
{
namespace
{
using Eigen::Vector3d;

/// Pieces of arcs are divided down to this angle before their boxes are [rad].
constexpr double MOST_BEND = 1.0 / 32.0;

/// The box as that of a piece.
SkewBox<double> asSkew(const Box& box)
{
  const CenteredBox<double> centered(box);
  SkewBox<double> skew{};
  skew.center = centered.center;
  for (std::size_t k = 0; k < 3; ++k)
    skew.edges[k][k] = centered.half_widths[k];
  skew.slack = centered.slack;
  return skew;
}

/// The same points as a box whose edges say nothing of where on the piece they are.
SkewBox<double> loosened(const SkewBox<double>& box)
{
  SkewBox<double> loose{};
  loose.center = box.center;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const AffineForm<double> form = coordinate(box, k);
    const Interval center(form.center);
    loose.slack =
        std::max({ loose.slack, (Interval(form.upper()) - center).upper(), (center - Interval(form.lower())).upper() });
  }
  return loose;
}

SkewBox<double> anyUpTo(double magnitude)
{
  SkewBox<double> box{};
  box.slack = magnitude;
  return box;
}
}  // namespace

/// Encloses what joints do on the part wherever it is in the box.
BoxVerdict PathBody::Proof::ratesOn(const PathTree::Part& part, const Box& box) const
{
  CurvePiece piece;
  SkewBox<double> curvatures;
  if (part.level > 0)
  {
    piece.tangents = anyUpTo(1.0);
    curvatures = anyUpTo(moves_.curvature(part));
  }
  else
  {
    const Curve& curve = moves_.curve(part);
    piece.tangents = loosened(curve.piece(part.first, part.last).tangents);
    curvatures = loosened(curve.curvatures(part.first, part.last));
  }
  piece.points = asSkew(box);
  PieceRates rates;
  test_.kernel().rates(&piece, &curvatures, 1, &rates);
  return verdictOn(rates, body_.limits_, moves_.speed(part));
}

/// By which angle the direction of a piece turns [rad].
double PathBody::Proof::bend(const PathTree::Part& piece) const
{
  return (piece.last - piece.first) * moves_.curve(piece).angle().magnitude();
}

/// Collects the pieces that are not proved to keep the limits there.
void PathBody::Proof::addTooFast(const Part& part, const Box& box, Parts& too_fast)
{
  if (moves_.speed(part.path).upper() == 0.0)
    return;
  const BoxVerdict verdict = ratesOn(part.path, box);
  if (verdict == BoxVerdict::INSIDE)
    return;
  if (part.path.level > 0 || (verdict == BoxVerdict::UNDECIDED && bend(part.path) > MOST_BEND))
  {
    halve(part, [&](const Part& smaller) { addTooFast(smaller, box, too_fast); });
    return;
  }
  too_fast.push_back(part);
  if (verdict == BoxVerdict::OUTSIDE)
  {
    body_.learnFast({ part.path, half(part.path.first, part.path.last) });
    result_.verdict = Containment::OUTSIDE;
  }
}
}  // namespace pkm_workspace
