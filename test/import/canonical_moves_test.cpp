// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "pkm_workspace/import/rs274.h"

// Calls as rs274 prints them: LinuxCNC/linuxcnc, src/emc/sai/saicanon.cc.

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;
using Kind = GcodeMove::Kind;

/// Reads calls, the first of them as those of the setup, which ends in a place that is known.
class CanonicalMoves : public ::testing::Test
{
protected:
  CanonicalMoves() { tell({ "N0     STRAIGHT_TRAVERSE(0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)" }); }

  std::vector<GcodeMove> tell(const std::vector<std::string>& calls)
  {
    std::vector<GcodeMove> moves;
    for (const std::string& call : calls)
      if (const auto move = reader_->read("   12 " + call))
        moves.push_back(*move);
    return moves;
  }

  GcodeMove last(const std::vector<std::string>& calls) { return tell(calls).back(); }

  void expectRefused(const std::string& call, const std::string& reason)
  {
    try
    {
      reader_->read(call);
      ADD_FAILURE() << call;
    }
    catch (const std::invalid_argument& refusal)
    {
      EXPECT_NE(std::string(refusal.what()).find(reason), std::string::npos) << call << ": " << refusal.what();
    }
  }

  std::unique_ptr<MoveReader> reader_ = canonicalMoves({});
};

void expectNear(const Vector3d& point, double x, double y, double z)
{
  EXPECT_LT((point - 1e-3 * Vector3d(x, y, z)).norm(), 1e-12) << point.transpose();
}

TEST_F(CanonicalMoves, LinesHaveTheNumbersOfTheirWordsN)
{
  const auto moves =
      tell({ "N7     SET_FEED_RATE(600.0000)", "N7     STRAIGHT_FEED(1.0000, -2.5000, 3.0001, 0.0000, 0.0000, 0.0000)",
             "N1234567STRAIGHT_TRAVERSE(4.0000, 0.0000, 0.0000, 0.0000, -0.0000, 0.0000)" });
  ASSERT_EQ(moves.size(), 2U);
  EXPECT_EQ(moves[0].kind, Kind::LINE);
  EXPECT_EQ(moves[0].start, Vector3d::Zero());
  EXPECT_EQ(moves[0].end, Vector3d(0.001, -0.0025, 0.0030001));
  EXPECT_FALSE(moves[0].is_rapid);
  EXPECT_TRUE(moves[0].feed_value.contains(0.01));
  EXPECT_TRUE(moves[0].feed_value.contains((600 - 0.0000499) / 60e3)) << "it was rounded";
  EXPECT_TRUE(moves[0].feed_value.contains((600 + 0.0000499) / 60e3));
  EXPECT_LT(moves[0].feed_value.width(), 2e-9);
  EXPECT_TRUE(moves[1].is_rapid);
  EXPECT_EQ(moves[1].feed, GcodeMove::Feed::NONE);
  EXPECT_EQ(reader_->line(), 1234567U);
  tell({ "N..... STRAIGHT_TRAVERSE(5.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)" });
  EXPECT_EQ(reader_->line(), 1234567U) << "of a subroutine in another file";
  EXPECT_EQ(reader_->summary().moves, 3U);
}

TEST_F(CanonicalMoves, PlacesAreTurnedThenMoved)
{
  const GcodeMove move = last(
      { "N1     USE_LENGTH_UNITS(CANON_UNITS_INCHES)",
        "N1     SET_G5X_OFFSET(2, 1.0000, 2.0000, 3.0000, 0.0000, 0.0000, 0.0000)",
        "N1     SET_G92_OFFSET(0.5000, -0.2500, 0.1250, 0.0000, 0.0000, 0.0000)", "N1     SET_XY_ROTATION(30.0000)",
        "N1     USE_TOOL_LENGTH_OFFSET(0.0000 0.1000 4.0000, 0.0000 0.0000 0.0000, 0.0000 0.0000 0.0000)",
        "N1     STRAIGHT_TRAVERSE(2.0000, 1.0000, -1.0000, 0.0000, 0.0000, 0.0000)" });
  const Vector3d turned = Eigen::AngleAxisd(EIGEN_PI / 6, Vector3d::UnitZ()) * Vector3d(2.5, 0.75, -0.875);
  const Vector3d place = 25.4 * (turned + Vector3d(1.0, 2.1, 7.0));
  expectNear(move.end, place.x(), place.y(), place.z());
}

TEST_F(CanonicalMoves, TheOriginIsThatOfTheController)
{
  GcodeSetup setup;
  setup.origin = { 0.1, -0.2, 0.3 };
  reader_ = canonicalMoves(setup);
  tell({ "N0 STRAIGHT_TRAVERSE(0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)" });
  const GcodeMove move = last({ "N1     STRAIGHT_TRAVERSE(1.0000, 2.0000, 3.0000, 0.0000, 0.0000, 0.0000)" });
  EXPECT_EQ(move.start, setup.origin);
  expectNear(move.end, 101, -198, 303);
}

/// The first two numbers are along the two axes of the plane: XY, YZ or ZX.
TEST_F(CanonicalMoves, ArcsLieInTheirPlane)
{
  tell({ "N1     SET_FEED_RATE(60.0000)" });
  GcodeMove arc = last({ "N1     ARC_FEED(10.0000, 10.0000, 10.0000, 0.0000, -1, 3.0000, 0.0000, 0.0000, 0.0000)" });
  EXPECT_EQ(arc.kind, Kind::ARC);
  EXPECT_EQ(arc.axis, -Vector3d::UnitZ());
  EXPECT_EQ(arc.turns, 1);
  expectNear(arc.center, 10, 0, 0);
  expectNear(arc.end, 10, 10, 3);
  tell({ "N2     SELECT_PLANE(CANON_PLANE_XZ)" });
  arc = last({ "N2     ARC_FEED(8.0000, 15.0000, 8.0000, 10.0000, 2, 7.0000, 0.0000, 0.0000, 0.0000)" });
  EXPECT_EQ(arc.axis, Vector3d::UnitY());
  EXPECT_EQ(arc.turns, 2);
  expectNear(arc.center, 10, 10, 8);
  expectNear(arc.end, 15, 7, 8);
  tell({ "N3     SELECT_PLANE(CANON_PLANE_YZ)" });
  arc = last({ "N3     ARC_FEED(9.0000, 10.0000, 7.0000, 10.0000, -1, 14.0000, 0.0000, 0.0000, 0.0000)" });
  EXPECT_EQ(arc.axis, -Vector3d::UnitX());
  expectNear(arc.center, 15, 7, 10);
  expectNear(arc.end, 14, 9, 10);
}

TEST_F(CanonicalMoves, ArcsInTheTurnedPlaneAreTurned)
{
  const GcodeMove arc =
      last({ "N1     SET_FEED_RATE(60.0000)", "N1     SET_XY_ROTATION(90.0000)",
             "N1     ARC_FEED(10.0000, 10.0000, 10.0000, 0.0000, 1, 0.0000, 0.0000, 0.0000, 0.0000)" });
  expectNear(arc.center, 0, 10, 0);
  expectNear(arc.end, -10, 10, 0);
  EXPECT_EQ(arc.axis, Vector3d::UnitZ());
  tell({ "N2     SELECT_PLANE(CANON_PLANE_XZ)" });
  expectRefused("1 N2     ARC_FEED(1.0000, 1.0000, 1.0000, 0.0000, 1, 0.0000, 0.0000, 0.0000, 0.0000)",
                "out of the plane XY");
}

TEST_F(CanonicalMoves, ACircleEndsWhereItBegins)
{
  tell({ "N1     SET_FEED_RATE(60.0000)" });
  const GcodeMove circle =
      last({ "N1     ARC_FEED(0.0000, 0.0000, 5.0000, 0.0000, 1, 0.0000, 0.0000, 0.0000, 0.0000)" });
  EXPECT_EQ(circle.start, circle.end);
  const std::string reason = "do not tell a short arc from a circle";
  expectRefused("1 N2     ARC_FEED(0.0000, 0.0001, 5.0000, 0.0000, 1, 0.0000, 0.0000, 0.0000, 0.0000)", reason);
  expectRefused("1 N2     ARC_FEED(0.0000, -0.0001, 5.0000, 0.0000, 1, 4.0000, 0.0000, 0.0000, 0.0000)", reason);
  EXPECT_EQ(tell({ "N3     ARC_FEED(0.0000, 0.0100, 5.0000, 0.0000, 1, 4.0000, 0.0000, 0.0000, 0.0000)" }).size(), 1U);
}

TEST_F(CanonicalMoves, APlaceIsKnownWhenItsAxesWereSaid)
{
  reader_ = canonicalMoves({});
  const auto moves =
      tell({ "N0     STRAIGHT_TRAVERSE(2000000.0000, 2000000.0000, 2000000.0000, 0.0000, 0.0000, 0.0000)",
             "N1     STRAIGHT_TRAVERSE(1.0000, 2.0000, 2000000.0000, 0.0000, 0.0000, 0.0000)",
             "N2     STRAIGHT_TRAVERSE(1.0000, 2.0000, 3.0000, 0.0000, 0.0000, 0.0000)",
             "N3     STRAIGHT_TRAVERSE(4.0000, 2.0000, 3.0000, 0.0000, 0.0000, 0.0000)" });
  ASSERT_EQ(moves.size(), 2U);
  EXPECT_EQ(moves[0].kind, Kind::POINT);
  expectNear(moves[0].end, 1, 2, 3);
  EXPECT_EQ(moves[1].kind, Kind::LINE);
  EXPECT_EQ(reader_->summary().unknown_moves, 2U);
  EXPECT_EQ(reader_->summary().first_unknown, 1U);
  tell({ "N4     STRAIGHT_TRAVERSE(2000000.0000, 2.0000, 3.0000, 0.0000, 0.0000, 0.0000)" });
  const std::string here = "not known here";
  expectRefused("1 N4     ARC_FEED(1.0000, 2.0000, 5.0000, 0.0000, 1, 0.0000, 0.0000, 0.0000, 0.0000)", here);
  tell({ "N5     STRAIGHT_TRAVERSE(2000000.0000, 2.0000, 3.0000, 0.0000, 0.0000, 0.0000)",
         "N5     SET_XY_ROTATION(10.0000)" });
  expectRefused("1 N5     STRAIGHT_TRAVERSE(1.0000, 2.0000, 3.0000, 0.0000, 0.0000, 0.0000)", "G10 R has turned");
}

/// At a change of tool rs274 forgets what tool lengths have changed.
TEST_F(CanonicalMoves, AfterAChangeOfToolAnAxisMayNotBeKnown)
{
  const std::string longer =
      "USE_TOOL_LENGTH_OFFSET(0.0000 0.0000 10.0000, 0.0000 0.0000 0.0000, 0.0000 0.0000 0.0000)";
  auto moves =
      tell({ "N1     STRAIGHT_TRAVERSE(0.0000, 0.0000, 50.0000, 0.0000, 0.0000, 0.0000)", "N2     CHANGE_TOOL(1)",
             "N2     " + longer, "N3     STRAIGHT_TRAVERSE(5.0000, 0.0000, 40.0000, 0.0000, 0.0000, 0.0000)" });
  ASSERT_EQ(moves.size(), 2U) << "nothing had changed";
  expectNear(moves[1].end, 5, 0, 50);
  moves =
      tell({ "N4     CHANGE_TOOL(2)", "N4     STRAIGHT_TRAVERSE(6.0000, 0.0000, 40.0000, 0.0000, 0.0000, 0.0000)" });
  ASSERT_EQ(moves.size(), 1U);
  tell({ "N5     USE_TOOL_LENGTH_OFFSET(0.0000 0.0000 0.0000, 0.0000 0.0000 0.0000, 0.0000 0.0000 0.0000)",
         "N5     CHANGE_TOOL_NUMBER(1)" });
  EXPECT_TRUE(tell({ "N6     STRAIGHT_TRAVERSE(7.0000, 0.0000, 40.0000, 0.0000, 0.0000, 0.0000)" }).empty());
  EXPECT_TRUE(
      tell({ "N7     " + longer, "N7     STRAIGHT_TRAVERSE(8.0000, 0.0000, 30.0000, 0.0000, 0.0000, 0.0000)" }).empty())
      << "30 follows from 40 by the length of the tool";
  moves = tell({ "N8     STRAIGHT_TRAVERSE(8.0000, 0.0000, 31.0000, 0.0000, 0.0000, 0.0000)" });
  ASSERT_EQ(moves.size(), 1U);
  EXPECT_EQ(moves[0].kind, Kind::POINT);
  expectNear(moves[0].end, 8, 0, 41);
  EXPECT_EQ(reader_->summary().unknown_moves, 3U);
}

TEST_F(CanonicalMoves, WhatIsNotReadIsRefused)
{
  for (const char* const call :
       { "STRAIGHT_PROBE(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)", "RIGID_TAP(0.0000, 0.0000, -1.0000)",
         "NURBS_FEED(4, ...)", "START_SPEED_FEED_SYNC(1.000000,0)", "PALLET_SHUTTLE()", "ENABLE_ADAPTIVE_FEED()",
         "STRAIGHT_FEEDS(1)", "CANON_ERROR(x)", "SPINDLE_RETRACT()" })
    expectRefused("1 N5     " + std::string(call), "is not among the calls of rs274 that are read");
  expectRefused("1 N5     STRAIGHT_FEED(1.0000, 0.0000, 0.0000, 3.0000, 0.0000, 0.0000)", "turns an axis");
  expectRefused("1 N5     SET_G92_OFFSET(1.0000, 0.0000, 0.0000, 3.0000, 0.0000, 0.0000)", "turns an axis");
  expectRefused("1 N5     ARC_FEED(1.0000, 0.0000, 0.5000, 0.0000, 1, 0.0000, 0.0000, 1.0000, 0.0000)",
                "turns an axis");
  expectRefused("1 N5     ARC_FEED(1.0000, 0.0000, 0.5000, 0.0000, 0, 0.0000, 0.0000, 0.0000, 0.0000)", "arguments");
  expectRefused("1 N5     STRAIGHT_FEED(1.0000, 0.0000, 0.0000)", "arguments are not those");
  expectRefused("1 N5     STRAIGHT_FEED(1.0000, 0.0000, 1.0000, 0.0000, 0.0000, 0.0000)", "no feed is in effect");
  expectRefused("1 N5     STRAIGHT_FEED(1.00, 0.0000, 1.0000, 0.0000, 0.0000, 0.0000)", "four digits");
  expectRefused("1 N5     STRAIGHT_FEED(nan, 0.0000, 1.0000, 0.0000, 0.0000, 0.0000)", "four digits");
  expectRefused("1 N5     STRAIGHT_FEED(1e5, 0.0000, 1.0000, 0.0000, 0.0000, 0.0000)", "four digits");
  expectRefused("1 N5     STRAIGHT_TRAVERSE(99999999.0000, 0.0000, 1.0000, 0.0000, 0.0000, 0.0000)", "up to 2050 m");
  expectRefused("1 N5     USE_LENGTH_UNITS(UNKNOWN)", "arguments are not those");
  expectRefused("1 N5     SELECT_PLANE(CANON_PLANE_UNKNOWN)", "arguments are not those");
  expectRefused("1 N0     SELECT_PLANE(CANON_PLANE_XY)", "N0 is read");
  for (const char* const printed : { "PLUGIN_CALL(3)", "5 N..... ", "5 STRAIGHT_FEED(1)", "", "5 N5 (1)", "5 N5 A)1(" })
    expectRefused(printed, "which is not a call that this reader knows");
}

TEST_F(CanonicalMoves, FeedsByTheTurnAreRefused)
{
  tell({ "N1     SET_FEED_MODE(0, 1)", "N1     SET_FEED_RATE(1.0000)" });
  const std::string feed = "1 N1     STRAIGHT_FEED(1.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)";
  expectRefused(feed, "per turn of the spindle (G95)");
  reader_->read("1 N2     SET_FEED_MODE(0, 0)");
  reader_->read("1 N2     USE_LENGTH_UNITS(CANON_UNITS_INCHES)");
  expectRefused(feed, "no feed is in effect");
}

TEST_F(CanonicalMoves, WhatDoesNotMoveIsCounted)
{
  tell({ "N1     DWELL(0.1000)", "N1     COMMENT(\"interpreter: STRAIGHT_FEED(1)\")", "N2     DWELL(1.0000)",
         "N2     FLOOD_ON()", "N3     PROGRAM_END()" });
  const GcodeSummary summary = reader_->summary();
  EXPECT_EQ(summary.ignored, (std::map<std::string, std::size_t>{ { "DWELL", 2 }, { "FLOOD_ON", 1 } }));
  EXPECT_TRUE(summary.has_ended);
  EXPECT_EQ(summary.moves, 0U);
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
