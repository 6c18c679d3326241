// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace pkm_workspace
{
/// A linear programme in a few unknowns x in [-1, 1]^N with many rows: maximise objective . x where offset + slope . x
/// >= 0 for every row. Floating point, no guarantee: whoever needs a proof checks the certificate in interval
/// arithmetic.
template <std::size_t N>
class LinearProgramme
{
public:
  using Vector = std::array<double, N>;

  struct Row
  {
    double offset;
    Vector slope;
  };

  /// A row with its weight >= 0 in a linear combination of rows; row < 0 stands for a bound of the box.
  struct Term
  {
    int row = -1;
    double weight = 0.0;
  };

  /// Forgets all rows and starts at the corner of the box that is best for @p objective. Keeps its memory.
  void reset(const Vector& objective);
  /// Adds a row; a later solve() goes on from where the last one ended.
  void add(const Row& row) { rows_.push_back(row); }
  std::size_t rows() const { return rows_.size(); }
  /// Dual simplex: every iterate bounds the optimum from above. @return false when no x satisfies all rows
  bool solve();

  const Vector& point() const { return point_; }
  /// The weights that prove the optimum or, when solve() is false, the contradiction.
  std::array<Term, N + 1> certificate() const;

private:
  // A constraint is a row's index, or -1 - 2 k - (upper ? 1 : 0) for a bound of unknown k; all read normal . x <=
  // bound.
  double excess(int constraint) const;
  Vector normal(int constraint) const;
  double bound(int constraint) const;
  int mostViolated() const;
  Vector weightsOf(const Vector& normal) const;
  std::size_t leavingFor(const Vector& weights) const;
  void exchange(std::size_t leaving, int entering, const Vector& weights);
  void moveToVertex();

  std::vector<Row> rows_;
  std::array<Term, N> active_;
  std::array<Vector, N> inverse_;  ///< inverse of the matrix whose rows are the active normals
  Vector point_{};
  Term contradiction_;  ///< the row that the active ones contradict
};

extern template class LinearProgramme<5>;
extern template class LinearProgramme<6>;
}  // namespace pkm_workspace
