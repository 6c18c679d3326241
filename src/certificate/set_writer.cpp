// SPDX-License-Identifier: BSD-3-Clause
// Certificates of pavings and paths.
#include <stdexcept>

#include "certificate_json.h"

namespace pkm_workspace
{
using namespace certificate;

namespace
{
/// Pieces of a segment are not halved further than this.
constexpr double SHORTEST_PIECE = 0x1p-30;

void requireKnown(const Machine& machine, const Criterion& criterion)
{
  Problems problems;
  validateCertificate(machine, criterion, nullptr, problems);
  throwProblems(problems);
}

/// Walks the boxes of a paving as they are divided, and writes down what is known of each.
class PavingWriter
{
public:
  PavingWriter(const BoxTest& test, const BoxTree& tree) : test_(test), tree_(tree), next_(tree.levels(), 0) {}

  std::string text()
  {
    std::string tree;
    std::vector<std::pair<Cell, std::size_t>> open = { { Cell{}, 0 } };
    while (!open.empty())
    {
      const auto [cell, level] = open.back();
      open.pop_back();
      const CellState state = tree_.level(level)[next_[level]++];
      tree += tree.empty() ? '[' : ',';
      if (state != CellState::SPLIT)
      {
        appendLeaf(state, tree_.bisection().box(cell, level), tree);
        continue;
      }
      const Cell first = tree_.bisection().half(cell, level, 0);
      const Box whole = tree_.bisection().box(cell, level);
      const Box half = tree_.bisection().box(first, level + 1);
      const int axis = axisOf(whole, half);
      appendCut(axis, half.upper[axis], tree);
      open.emplace_back(tree_.bisection().half(cell, level, 1), level + 1);
      open.emplace_back(first, level + 1);
    }
    return tree + ']';
  }

private:
  static int axisOf(const Box& whole, const Box& half)
  {
    int axis = 0;
    (whole.upper - half.upper).maxCoeff(&axis);
    return axis;
  }

  /// What no single form says is not claimed.
  void appendLeaf(CellState state, const Box& box, std::string& text) const
  {
    std::string violation;
    if (state == CellState::OUTSIDE && appendViolation(test_, box, violation))
      text += '{' + violation + '}';
    else
      text += state == CellState::INSIDE ? '1' : '0';
  }

  const BoxTest& test_;
  const BoxTree& tree_;
  std::vector<std::size_t> next_;  ///< box of each level
};

/// Appends the ends of pieces that are proved, first to last, but for the first one.
void provePieces(const BoxTest& test, const Curve& curve, double first, double last, Json& cuts)
{
  const CurvePiece piece = curve.piece(first, last);
  BoxVerdict verdict = BoxVerdict::UNDECIDED;
  test.kernel().look(&piece, 1, &verdict, nullptr);
  if (verdict == BoxVerdict::INSIDE)
  {
    cuts.push_back(last);
    return;
  }
  if (verdict == BoxVerdict::OUTSIDE || last - first < SHORTEST_PIECE)
    throw std::invalid_argument("a segment is not inside: there is nothing to certify");
  const double middle = 0.5 * (first + last);
  provePieces(test, curve, first, middle, cuts);
  provePieces(test, curve, middle, last, cuts);
}
}  // namespace

std::string certificateOf(const Machine& machine, const Criterion& criterion, const Paving& paving)
{
  requireKnown(machine, criterion);
  const BoxTest test(machine, criterion);
  const std::string boxes =
      withMember({ { "box", toJson(paving.box) } }, "tree", PavingWriter(test, paving.tree).text());
  return fileOf(machine, criterion, nullptr, { { "boxes", boxes } });
}

std::string certificateOf(const Machine& machine, const Criterion& criterion, const std::vector<PathSegment>& path)
{
  requireKnown(machine, criterion);
  const BoxTest test(machine, criterion);
  Json segments = Json::array();
  for (const PathSegment& segment : path)
  {
    if (!segment.ends())
      throw std::invalid_argument("certificates do not know arcs yet: give the path in straight segments");
    Json cuts = { 0.0 };
    provePieces(test, segment.curve(), 0.0, 1.0, cuts);
    segments.push_back({ toJson((*segment.ends())[0]), toJson((*segment.ends())[1]), cuts });
  }
  return fileOf(machine, criterion, nullptr, { { "path", segments.dump() } });
}
}  // namespace pkm_workspace
