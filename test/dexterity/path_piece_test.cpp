// SPDX-License-Identifier: BSD-3-Clause
// Looks at boxes with edges in any direction, and what the machine does there, against points of them.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "pkm_workspace/dexterity/verdict.h"
#include "support/cases.h"
#include "support/machines.h"
#include "support/oracle.h"
#include "support/random.h"
#include "support/same_bits.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t MOST_PIECES = 9;

const Box CUBE{ Vector3d::Constant(-1.0), Vector3d::Constant(1.0) };

SkewBox<double> skewBox(const Vector3d& center, const Matrix3d& edges)
{
  SkewBox<double> box;
  for (std::size_t k = 0; k < 3; ++k)
  {
    box.center[k] = center[static_cast<int>(k)];
    for (std::size_t j = 0; j < 3; ++j)
      box.edges[k][j] = edges(static_cast<int>(k), static_cast<int>(j));
  }
  return box;
}

/// A piece of a curve, more or less: a long edge and two short ones, anywhere in the space of the machine.
struct Piece
{
  Vector3d center;
  Matrix3d edges;
  Vector3d tangent;

  Piece(const Machine& machine, RandomBoxes& random)
  {
    center = random.pointIn(
        { 0.8 * spaceOf(machine).lower + 0.2 * machine.zero(), 0.8 * spaceOf(machine).upper + 0.2 * machine.zero() });
    const double size = machine.scale() * std::pow(10.0, random.between(-5.0, -0.5));
    edges.col(0) = size * random.pointIn(CUBE);
    edges.col(1) = 0.1 * size * random.pointIn(CUBE);
    edges.col(2) = 0.01 * size * random.pointIn(CUBE);
    tangent = edges.col(0).normalized();
  }

  CurvePiece asPathPiece() const { return { skewBox(center, edges), skewBox(tangent, Matrix3d::Zero()) }; }
  Vector3d point(const Vector3d& delta) const { return center + edges * delta; }
};

/// 1 at the ends mostly.
Vector3d randomDelta(RandomBoxes& random)
{
  Vector3d delta = random.pointIn(CUBE);
  for (double& entry : delta)
    entry = random.between(0.0, 1.0) < 0.5 ? std::copysign(1.0, entry) : entry;
  return delta;
}

void expectHolds(const PieceMotion& motion, const Machine& machine, const Vector3d& p, const Vector3d& tangent)
{
  const auto jacobian = jacobians(machine, p);
  ASSERT_TRUE(jacobian) << "all points are reached";
  const Vector3d psi = transmissionFactors(*jacobian);
  const Vector3d rho = *inverseKinematics(machine, p);
  const Vector3d speed = (jacobian->j_inverse * tangent).cwiseAbs();
  const double noise = 1e-9 * (1.0 + psi[2] * psi[2]);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const int k = static_cast<int>(i);
    EXPECT_GE(psi[k], motion.psi[i].lower - noise);
    EXPECT_LE(psi[k], motion.psi[i].upper + noise);
    EXPECT_GE(rho[k], motion.joint[i].lower - 1e-9 * machine.scale());
    EXPECT_LE(rho[k], motion.joint[i].upper + 1e-9 * machine.scale());
    EXPECT_LE(speed[k], motion.speed[i] + noise);
  }
}

bool isBounded(const PieceMotion& motion)
{
  return motion.psi[2].upper < std::numeric_limits<double>::infinity();
}

Criterion reachable()
{
  Criterion criterion;
  criterion.set = Criterion::Set::REACHABLE;
  criterion.aspect = Criterion::Aspect::BOTH;
  return criterion;
}

/// @param inside, @param outside the fewest of 300 pieces that have to be
void expectVerdictsOfTheOracle(const Machine& machine, int inside, int outside)
{
  for (const Criterion& criterion : { Criterion(), reachable() })
  {
    const BoxTest test(machine, criterion);
    const Oracle oracle(machine, criterion);
    RandomBoxes random(SEED);
    std::array<int, 3> found{};
    for (int k = 0; k < cases(300); ++k)
    {
      const Piece piece(machine, random);
      const CurvePiece path_piece = piece.asPathPiece();
      BoxVerdict verdict;
      test.kernel().look(&path_piece, 1, &verdict, nullptr);
      ++found[static_cast<std::size_t>(verdict)];
      for (int sample = 0; sample < 4 && verdict != BoxVerdict::UNDECIDED; ++sample)
        ASSERT_EQ(oracle.isGood(piece.point(0.999999999 * randomDelta(random))), verdict == BoxVerdict::INSIDE)
            << machine.name() << ", seed " << SEED << ", case " << k;
    }
    EXPECT_GT(found[0], cases(inside)) << machine.name();
    EXPECT_GE(found[1], cases(outside)) << machine.name();
  }
}
}  // namespace

TEST(PathPiece, verdictsAgreeWithTheOracle)
{
  for (const Machine& machine : slidingKinds())
    expectVerdictsOfTheOracle(machine, 10, 21);
  for (const Machine& machine : otherLegs())
    expectVerdictsOfTheOracle(machine, 3, 0);  // of a tripod every point is reached
}

TEST(PathPiece, motionsHoldEveryPoint)
{
  for (const Machine& machine : everyKind())
  {
    const BoxTest test(machine, reachable());
    RandomBoxes random(SEED);
    int bounded = 0;
    for (int k = 0; k < cases(300); ++k)
    {
      const Piece piece(machine, random);
      const CurvePiece path_piece = piece.asPathPiece();
      BoxVerdict verdict;
      PieceMotion motion;
      test.kernel().look(&path_piece, 1, &verdict, &motion);
      if (!isBounded(motion))
        continue;
      ++bounded;
      for (int sample = 0; sample < 4 && !testing::Test::HasFailure(); ++sample)
      {
        SCOPED_TRACE(machine.name() + ", seed " + std::to_string(SEED) + ", case " + std::to_string(k));
        expectHolds(motion, machine, piece.point(randomDelta(random)), piece.tangent);
      }
    }
    EXPECT_GT(bounded, cases(20)) << machine.name();
  }
}

// What is left over goes with the square of the length: of the ranges, which shrink with the length itself, little.
TEST(PathPiece, motionsAreTightToSecondOrder)
{
  for (const Machine& machine : everyKind())
  {
    const BoxTest test(machine, Criterion());
    RandomBoxes random(SEED);
    int tried = 0;
    for (int k = 0; k < cases(3000) && tried <= cases(30); ++k)
    {
      Piece piece(machine, random);
      const double length = 1e-4 * machine.scale();
      piece.edges << length * piece.tangent, Vector3d::Zero(), Vector3d::Zero();
      const CurvePiece path_piece = piece.asPathPiece();
      BoxVerdict verdict;
      PieceMotion motion;
      test.kernel().look(&path_piece, 1, &verdict, &motion);
      if (verdict != BoxVerdict::INSIDE)
        continue;
      ++tried;
      const Vector3d first = transmissionFactors(*jacobians(machine, piece.point({ -1.0, 0.0, 0.0 })));
      const Vector3d last = transmissionFactors(*jacobians(machine, piece.point({ 1.0, 0.0, 0.0 })));
      const Vector3d speed = (jacobians(machine, piece.center)->j_inverse * piece.tangent).cwiseAbs();
      for (int i = 0; i < 3; i += 2)
      {
        const auto& psi = motion.psi[static_cast<std::size_t>(i)];
        EXPECT_GE(psi.lower, std::min(first[i], last[i]) - 3e-5) << machine.name() << ", case " << k;
        EXPECT_LE(psi.upper, std::max(first[i], last[i]) + 3e-5);
      }
      EXPECT_LE(motion.speed[0], speed[0] / driveScale(machine.leg(0)).mid() + 2e-3);
    }
    EXPECT_GT(tried, cases(10)) << machine.name();
  }
}

TEST(PathPiece, coincidingFactorsAreBoundedTightly)
{
  const BoxTest test(orthoglide(), Criterion());  // at its zero all three factors are 1
  const CurvePiece piece{ skewBox(Vector3d::Zero(), Matrix3d::Zero()), skewBox(Vector3d::UnitX(), Matrix3d::Zero()) };
  BoxVerdict verdict;
  PieceMotion motion;
  test.kernel().look(&piece, 1, &verdict, &motion);
  EXPECT_EQ(verdict, BoxVerdict::INSIDE);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_LE(motion.psi[i].lower, 1.0);
    EXPECT_GE(motion.psi[i].upper, 1.0);
    EXPECT_LE(motion.psi[i].upper - motion.psi[i].lower, 1e-11);
    EXPECT_NEAR(motion.speed[i], i == 0 ? 1.0 : 0.0, 1e-12);
  }
}

TEST(PathPiece, everyKernelSaysTheSameInEveryPlace)
{
  for (const Machine& machine : everyKind())
  {
    const MachineModel<double> model(machine, Criterion());
    RandomBoxes random(SEED);
    std::vector<CurvePiece> pieces;
    while (pieces.size() < MOST_PIECES)
      pieces.push_back(Piece(machine, random).asPathPiece());
    const auto kernels = boxKernels(model);
    std::array<BoxVerdict, MOST_PIECES> expected, verdicts;
    std::array<PieceMotion, MOST_PIECES> alone, motions;
    for (std::size_t k = 0; k < MOST_PIECES; ++k)
      kernels.back()->look(&pieces[k], 1, &expected[k], &alone[k]);
    for (const auto& kernel : kernels)
    {
      kernel->look(pieces.data(), MOST_PIECES, verdicts.data(), motions.data());
      EXPECT_EQ(verdicts, expected);
      for (std::size_t k = 0; k < MOST_PIECES; ++k)
        for (std::size_t i = 0; i < 3; ++i)
        {
          EXPECT_TRUE(sameBits(motions[k].psi[i].lower, alone[k].psi[i].lower));
          EXPECT_TRUE(sameBits(motions[k].psi[i].upper, alone[k].psi[i].upper));
          EXPECT_TRUE(sameBits(motions[k].joint[i].lower, alone[k].joint[i].lower));
          EXPECT_TRUE(sameBits(motions[k].speed[i], alone[k].speed[i]));
        }
    }
  }
}
}  // namespace test
}  // namespace pkm_workspace
