// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "pkm_workspace/dexterity/machine_model.h"
#include "pkm_workspace/dexterity/path_piece.h"
#include "pkm_workspace/interval/cube_cut.h"
#include "pkm_workspace/interval/half_space.h"

namespace pkm_workspace
{
/// Box verification, the paper's M(B) (section 2.2): about all points of a box. Not the answer of a containment test.
enum class BoxVerdict : unsigned char
{
  INSIDE,     ///< every point is proved to satisfy the criterion
  OUTSIDE,    ///< no point does, proved
  UNDECIDED,  ///< neither is proved
};

/// What a necessary form says: of a condition, and by which vectors. Of a matrix S it is v^T S v; of a leg's reach b^2
/// less the least that psi_max leaves it, n^2 / psi_max^2 (or 0).
struct FormOrigin
{
  Subject subject;
  std::array<double, 3> u;  ///< of the condition number, the first one
  std::array<double, 3> v;  ///< rounded, where the form is from multi-precision
};

/// The exponent of the power of two that makes lengths of a machine numbers without unit in these forms.
/// @param squared_scale LegModels::squaredScale() [m^2]
int exponentPerLength(double squared_scale);

/// What the criterion makes necessary at the points of one box, as affine forms that are negative nowhere in its set.
struct NecessaryForms
{
  /// One for each side on which the factors are bounded, 3 for forces, 1 for the stiffness, 4 for errors of position.
  static constexpr std::size_t MOST_MATRICES = 10;
  /// One for each matrix (four from multi-precision, where the last ones may be left out), 3 each for the reach, the
  /// condition number and the tool's speed, 1 for the aspect, 6 each for the joint limits and the struts' angles, 3 or
  /// 6 for ball joints, and the rest for hinges.
  static constexpr std::size_t MOST = 64;

  bool violated = false;     ///< no point of the box can satisfy the criterion, proved
  std::size_t matrices = 0;  ///< how many of the matrices are in use
  std::size_t forms = 0;     ///< how many of the forms are in use; the aspect's only where in doubt
  std::array<SymmetricForms<double>, MOST_MATRICES> matrix;  ///< those that count, without unit
  std::array<ConditionKind, MOST_MATRICES> kind;             ///< of each matrix
  std::array<AffineForm<double>, MOST> form;                 ///< without unit
};

/// The convex hull of points [m]; what is fewer than six has the last one several times.
using SmallHull = std::array<Eigen::Vector3d, 6>;

/// What is known of the criterion within one box, by planes: it holds where all conditions do.
struct BoxCuts
{
  static constexpr std::size_t MOST = 16;

  bool violated = false;  ///< no point of the box satisfies the criterion, proved
  std::size_t count = 0;  ///< how many of the cuts are in use: those of conditions that do not hold all over the box
  std::array<CubeCut, MOST> cut;  ///< delta from -1 to 1 along each side; but for a set without volume
};

/// Which of all machines within tolerances is the worst at a point, in floating point.
struct WorstMachine
{
  static constexpr std::size_t COUNT = 3 * STRUT_PARAMETERS;

  Subject subject = { ConditionKind::REACH };  ///< what is closest to failing, or fails most
  double margin = NO_MARGIN;                   ///< of that machine, without unit
  std::array<double, COUNT> parameter{};       ///< its parameters, leg by leg (ParameterSet)
  std::array<double, COUNT> loss{};            ///< what each of them takes off the margin, >= 0
};

/// The arithmetic of the verdicts, for several boxes at a time: as many as the processor works on side by side. What it
/// computes for one box does not depend on the others, nor on how many there are at a time.
class BoxKernel
{
public:
  virtual ~BoxKernel();

  /// Boxes that are worked on side by side.
  virtual std::size_t width() const = 0;
  /// One look at each box as a whole, without subdivision.
  /// @param worst for boxes that stay undecided the form v^T S v that stands in the way, or one that is 0; or nullptr
  /// @param within one for each box, or nullptr: INSIDE is then said of the points that lie in both, and, where the
  /// criterion settles it, of all but the aspect: one point of a connected region settles that
  virtual void classify(const Box* boxes, std::size_t count, BoxVerdict* verdicts, AffineForm<double>* worst = nullptr,
                        const HalfSpace* within = nullptr) const = 0;
  /// One look at each piece as a whole: its verdict as that of a box, and what the machine does on it.
  /// @param motions one for each piece, or nullptr; all numbers where a strut is not proved to reach, with the margin
  /// that psi_max asks for
  virtual void look(const CurvePiece* pieces, std::size_t count, BoxVerdict* verdicts, PieceMotion* motions) const = 0;
  /// One look at each piece as a whole: how fast the joints go there.
  /// @param curvatures Curve::curvatures() of each piece @param rates one for each piece; from 0 to INF where a strut
  /// is not proved to reach, as above
  virtual void rates(const CurvePiece* pieces, const SkewBox<double>* curvatures, std::size_t count,
                     PieceRates* rates) const = 0;
  /// The necessary forms at the centers' box, moved by offset.at(size) for each offset.
  /// @param origins NecessaryForms::MOST for each offset, of its forms in turn; or nullptr. Where they are violated,
  /// the first form and its origin tell by which leg
  virtual void necessaryForms(const CenteredBox<double>& centers, double size, const GrowingVector* offsets,
                              std::size_t count, NecessaryForms* results, FormOrigin* origins = nullptr) const = 0;
  /// One look at each hull as a whole, as at boxes.
  virtual void classify(const SmallHull* hulls, std::size_t count, BoxVerdict* verdicts) const = 0;
  /// What is known within each box.
  virtual void cuts(const Box* boxes, std::size_t count, BoxCuts* results) const = 0;
  /// The worst machine at a point [m]; of a kernel for one machine, that one.
  virtual WorstMachine worst(const Eigen::Vector3d& /*point*/) const { return {}; }
  /// MachineModel::margin at each of the points [m].
  virtual void margins(const Eigen::Vector3d* points, std::size_t count, double* results) const = 0;
};

/// The kernel in multi-precision, one box at a time and some thousand times slower: for what doubles cannot settle. Its
/// forms are in doubles, rounded last.
std::unique_ptr<const BoxKernel> preciseKernel(const Machine& machine, const Criterion& criterion);

/// The kernels that this processor can run, the fastest first.
std::vector<std::unique_ptr<const BoxKernel>> boxKernels(const MachineModel<double>& model);
/// The same for all machines within tolerances: INSIDE holds for each of them, and of every point that is OUTSIDE one
/// of them fails.
/// @param all the model of the enclosure of them all
std::vector<std::unique_ptr<const BoxKernel>> boxKernels(const MachineModel<double>& all, const LegSpreads& spreads);
}  // namespace pkm_workspace
