// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "gcode_lines.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Eigen::Vector3d;
using Kind = GcodeMove::Kind;
using Feed = GcodeMove::Feed;

/// The moves of all lines.
std::vector<GcodeMove> movesOf(const std::vector<std::string>& lines, const GcodeSetup& setup = atZero())
{
  GcodeJob job(setup);
  std::vector<GcodeMove> moves;
  for (const std::string& line : lines)
    if (const auto move = job.read(line))
      moves.push_back(*move);
  return moves;
}

Vector3d lastEnd(const std::vector<std::string>& lines, const GcodeSetup& setup = atZero())
{
  return movesOf(lines, setup).back().end;
}

TEST(GcodeJob, LinesGoOnFromWhereTheToolIs)
{
  const auto moves = movesOf({ "N10 g1 x10 Y-20.5 F600", "  Z 3 ; up", "(still) X+.5(here)Y0" });
  ASSERT_EQ(moves.size(), 3U);
  EXPECT_EQ(moves[0].start, Vector3d(0.0, 0.0, 0.0));
  EXPECT_EQ(moves[0].end, Vector3d(0.01, -0.0205, 0.0));
  EXPECT_EQ(moves[1].start, moves[0].end);
  EXPECT_EQ(moves[1].end, Vector3d(0.01, -0.0205, 0.003));
  EXPECT_EQ(moves[2].end, Vector3d(0.0005, 0.0, 0.003));
  for (const GcodeMove& move : moves)
  {
    EXPECT_EQ(move.kind, Kind::LINE);
    EXPECT_EQ(move.feed, Feed::SPEED);
    EXPECT_TRUE(move.feed_value.contains(0.01));
    EXPECT_LT(move.feed_value.width(), 1e-17);
  }
}

/// The compiler's doubles are those nearest to what is written.
TEST(GcodeJob, CoordinatesAreTheNearestDoubles)
{
  EXPECT_EQ(lastEnd({ "G1 F1 X0.1 Y12.345678 Z-123.456789012345" }), Vector3d(0.0001, 0.012345678, -0.123456789012345));
  EXPECT_EQ(lastEnd({ "G20", "G1 F1 X1 Y.001 Z-12.3456" }), Vector3d(0.0254, 0.0000254, -0.31357824));
  EXPECT_EQ(lastEnd({ "G1 F1 X0.1234567890126" }).x(), 0.000123456789013) << "rounded to 1e-12 mm";
  EXPECT_EQ(lastEnd({ "G1 F1 X12345.678901234567" }).x(), 12.345678901234567) << "more digits than a double counts";
}

TEST(GcodeJob, SumsAreExact)
{
  std::vector<std::string> lines = { "G91 G1 F1" };
  lines.insert(lines.end(), 10, "X0.1");
  EXPECT_EQ(lastEnd(lines).x(), 0.001);
  EXPECT_EQ(lastEnd({ "G20", "G91 G1 F1 X1", "X.1", "X.001" }).x(), 0.0279654);
  EXPECT_EQ(lastEnd({ "G20", "G1 F1 X1.1", "G21", "G1 F1 Y1" }), Vector3d(0.02794, 0.001, 0.0));
}

TEST(GcodeJob, OffsetsAdd)
{
  GcodeSetup setup = atZero();
  setup.origin = { 0.1, -0.2, 0.3 };
  setup.work_offsets[1] = { 0.01, 0.02, 0.03 };
  setup.tool_lengths[3] = 0.005;
  EXPECT_EQ(lastEnd({ "G1 F1 X1 Y1 Z1" }, setup), Vector3d(0.101, -0.199, 0.301));
  EXPECT_EQ(lastEnd({ "G55 G1 F1 X1 Y1 Z1" }, setup), Vector3d(0.111, -0.179, 0.331));
  EXPECT_EQ(lastEnd({ "G55 G43 H3 G1 F1 X1 Y1 Z1" }, setup), Vector3d(0.111, -0.179, 0.336));
  EXPECT_EQ(lastEnd({ "G43 H3", "G49 G1 F1 X1 Y1 Z1" }, setup), Vector3d(0.101, -0.199, 0.301));
  EXPECT_EQ(lastEnd({ "G55 G43 H3", "G53 G0 X1 Y1 Z1" }, setup), Vector3d(0.101, -0.199, 0.301));
  EXPECT_EQ(lastEnd({ "G10 L2 P2 X5", "G55 G1 F1 X1 Y1 Z1" }, setup), Vector3d(0.106, -0.179, 0.331));
  EXPECT_EQ(lastEnd({ "G55", "G10 L2 P0 Y5", "G1 F1 X1 Y1 Z1" }, setup), Vector3d(0.111, -0.194, 0.331));
  for (const char* const system : { "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3" })
    EXPECT_EQ(lastEnd({ system, "G1 F1 X1 Y1 Z1" }, setup), Vector3d(0.101, -0.199, 0.301)) << system;
  for (const double tiny : { 123e-15, 5e-15, 1e-12, -7.25e-12 })
  {
    GcodeSetup near = atZero();
    near.origin.x() = tiny;
    EXPECT_EQ(lastEnd({ "G0 X0" }, near).x(), tiny);
  }
  setup.work_offsets[8] = { 1.0, 0.0, 0.0 };
  EXPECT_EQ(lastEnd({ "G59.3 G1 F1 X1 Y1 Z1" }, setup).x(), 1.101);
}

TEST(GcodeJob, CoordinatesAreShifted)
{
  GcodeSetup setup = atZero();
  setup.work_offsets[0] = { 0.01, 0.0, 0.0 };
  EXPECT_EQ(lastEnd({ "G1 F1 X5 Y5", "G92 X0", "X1" }, setup), Vector3d(0.016, 0.005, 0.0));
  EXPECT_EQ(lastEnd({ "G1 F1 X5 Y5", "G92 X0", "G92 X3 E0", "X4" }, setup), Vector3d(0.016, 0.005, 0.0));
  EXPECT_EQ(lastEnd({ "G1 F1 X5", "G92 X0", "G92.1", "X1" }, setup).x(), 0.011);
  EXPECT_EQ(lastEnd({ "G1 F1 X5", "G92 X0", "G92.2", "X1" }, setup).x(), 0.011);
  EXPECT_EQ(lastEnd({ "G1 F1 X5", "G92 X0", "G92.2", "G92.3", "X1" }, setup).x(), 0.016);
  EXPECT_EQ(lastEnd({ "G1 F1 X5", "G92 X0", "G92.1", "G92.3", "X1" }, setup).x(), 0.011);
}

TEST(GcodeJob, FeedsAreInTheirUnits)
{
  const auto feedOf = [](const std::vector<std::string>& lines) { return movesOf(lines).back().feed_value; };
  EXPECT_TRUE(feedOf({ "G1 X1 F6000" }).contains(0.1));
  EXPECT_TRUE(feedOf({ "G20", "G1 X1 F100" }).contains(2.54 / 60.0));
  const auto moves = movesOf({ "G93 G1 X1 F120", "X2 F30", "G94 X3 F60" });
  EXPECT_EQ(moves[0].feed, Feed::PER_TIME);
  EXPECT_TRUE(moves[0].feed_value.contains(2.0));
  EXPECT_TRUE(moves[1].feed_value.contains(0.5));
  EXPECT_EQ(moves[2].feed, Feed::SPEED);
  EXPECT_EQ(refusalOf({ "G1 X1" }).substr(0, 24), "no feed is in effect: an");
  EXPECT_NE(refusalOf({ "G1 X1 F1", "G93 X2" }), "");
  EXPECT_NE(refusalOf({ "G93 G1 X1 F1", "X2" }), "");
  EXPECT_NE(refusalOf({ "G93 G1 X1 F1", "G94 X2" }), "");
  EXPECT_NE(refusalOf({ "G1 X1 F1", "G20 X1" }), "");
  EXPECT_NE(refusalOf({ "G1 X1 F0" }), "");
  EXPECT_NE(refusalOf({ "G20 F1" }), "");
}

TEST(GcodeJob, RapidsHaveTheFeedOfPrintersOnly)
{
  GcodeSetup setup = atZero();
  EXPECT_EQ(movesOf({ "G0 X1 F600" }, setup)[0].feed, Feed::NONE);
  setup.rapids_have_feed = true;
  EXPECT_TRUE(movesOf({ "G0 X1 F600" }, setup)[0].feed_value.contains(0.01));
  EXPECT_TRUE(movesOf({ "G0 X1 F600" }, setup)[0].is_rapid);
  EXPECT_NE(refusalOf({ "G0 X1" }, setup), "");
}

/// A point of each arc, by its angle from the start.
Vector3d pointOf(const GcodeMove& arc, double angle)
{
  const Vector3d u = arc.start - arc.center - arc.axis * arc.axis.dot(arc.start - arc.center);
  const Vector3d w(arc.axis.y() * u.z() - arc.axis.z() * u.y(), arc.axis.z() * u.x() - arc.axis.x() * u.z(),
                   arc.axis.x() * u.y() - arc.axis.y() * u.x());
  return arc.start - u + std::cos(angle) * u + std::sin(angle) * w;
}

void expectNear(const Vector3d& a, const Vector3d& b)
{
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(a[k], b[k], 1e-15);
}

/// Quarters, as one sees them from the tip of the axis that the plane is seen along.
TEST(GcodeJob, ArcsTurnAsSeenFromTheTipOfTheAxis)
{
  const GcodeMove xy = movesOf({ "G1 F1 X1", "G3 X0 Y1 I-1" }).back();
  expectNear(pointOf(xy, M_PI / 4.0), 1e-3 * Vector3d(std::sqrt(0.5), std::sqrt(0.5), 0.0));
  const GcodeMove zx = movesOf({ "G18 G1 F1 Z1", "G3 X1 Z0 K-1" }).back();
  expectNear(pointOf(zx, M_PI / 4.0), 1e-3 * Vector3d(std::sqrt(0.5), 0.0, std::sqrt(0.5)));
  const GcodeMove yz = movesOf({ "G19 G1 F1 Y1", "G3 Y0 Z1 J-1" }).back();
  expectNear(pointOf(yz, M_PI / 4.0), 1e-3 * Vector3d(0.0, std::sqrt(0.5), std::sqrt(0.5)));
  const GcodeMove clockwise = movesOf({ "G1 F1 Y1", "G2 X1 Y0 J-1" }).back();
  expectNear(pointOf(clockwise, M_PI / 4.0), 1e-3 * Vector3d(std::sqrt(0.5), std::sqrt(0.5), 0.0));
  EXPECT_EQ(clockwise.kind, Kind::ARC);
  EXPECT_EQ(clockwise.turns, 1);
}

TEST(GcodeJob, CentersAreRelativeOrNot)
{
  EXPECT_EQ(movesOf({ "G1 F1 X1", "G3 X0 Y1 I-1" }).back().center, Vector3d(0.0, 0.0, 0.0));
  EXPECT_EQ(movesOf({ "G1 F1 X1", "G90.1", "G3 X0 Y1 I0 J0" }).back().center, Vector3d(0.0, 0.0, 0.0));
  EXPECT_EQ(movesOf({ "G1 F1 X1", "G90.1", "G91.1 G3 X0 Y1 I-1" }).back().center, Vector3d(0.0, 0.0, 0.0));
  GcodeSetup setup = atZero();
  setup.work_offsets[0] = { 0.0, 0.5, 0.0 };
  EXPECT_EQ(movesOf({ "G1 F1 X1 Y0", "G90.1 G3 X0 Y1 I0 J0" }, setup).back().center, Vector3d(0.0, 0.5, 0.0));
}

TEST(GcodeJob, RadiusSaysWhichArc)
{
  const auto centerOf = [](const std::string& line) { return movesOf({ "G1 F1 X1", line }).back().center; };
  expectNear(centerOf("G3 X0 Y1 R1"), Vector3d(0.0, 0.0, 0.0));
  expectNear(centerOf("G3 X0 Y1 R-1"), Vector3d(0.001, 0.001, 0.0));
  expectNear(centerOf("G2 X0 Y1 R1"), Vector3d(0.001, 0.001, 0.0));
  expectNear(centerOf("G2 X0 Y1 R-1"), Vector3d(0.0, 0.0, 0.0));
  expectNear(centerOf("G2 X-1 R1"), Vector3d(0.0, 0.0, 0.0));
}

TEST(GcodeJob, HelicesAndWholeCircles)
{
  const GcodeMove helix = movesOf({ "G1 F1 X1", "G2 Z5 I-1 P3" }).back();
  EXPECT_EQ(helix.turns, 3);
  EXPECT_EQ(helix.end, Vector3d(0.001, 0.0, 0.005));
  EXPECT_EQ(helix.axis, Vector3d(0.0, 0.0, -1.0));
}

TEST(GcodeJob, AnUnknownPlaceEndsWithThreeCoordinates)
{
  GcodeJob job(GcodeSetup{});
  EXPECT_FALSE(job.read("G21 G90 G1 F600"));
  EXPECT_FALSE(job.read("G91 X1 Y1 Z1"));
  EXPECT_FALSE(job.read("G90 X1 Z2"));
  EXPECT_THROW(job.read("G92 Y0"), std::invalid_argument);
  EXPECT_THROW(job.read("G2 X1 I1"), std::invalid_argument);
  const auto point = job.read("G1 Y3");
  ASSERT_TRUE(point);
  EXPECT_EQ(point->kind, Kind::POINT);
  EXPECT_EQ(point->feed, Feed::NONE);
  EXPECT_EQ(point->end, Vector3d(0.001, 0.003, 0.002));
  EXPECT_TRUE(job.read("X2"));
  for (const char* const loses : { "G28 X Y", "G28", "G29", "G30", "M84", "M600", "T1 M6" })
  {
    EXPECT_FALSE(job.read(loses)) << loses;
    EXPECT_FALSE(job.read("X1 Y3")) << loses;
    EXPECT_TRUE(job.read("Z2")) << loses;
  }
  EXPECT_EQ(job.summary().first_unknown, 2U);
  EXPECT_EQ(job.summary().moves, 1U);
  EXPECT_EQ(job.summary().unknown_moves, 3U + 7U * 2U + 4U) << "G28, G29 and G30 are moves themselves";
}

TEST(GcodeJob, WhatDoesNotMoveIsCounted)
{
  GcodeJob job(atZero());
  for (const char* const line :
       { "%", "M104 S200", "M117 O-word? (no", "N5 M105*36", "M3 S1000 G1 X1 F100 E.5", "G4 P100", "G64 P0.01 G40",
         "M862.3 P \"MK3S\"", "M220 S100", "M0", "X1 E1", "", "  ; nothing", "M30", "what follows is not read" })
    job.read(line);
  const GcodeSummary summary = job.summary();
  EXPECT_TRUE(summary.has_ended);
  EXPECT_EQ(summary.moves, 1U) << "a line that ends where it begins moves nothing";
  const std::map<std::string, std::size_t> expected = { { "E", 2 },    { "N", 1 },     { "S", 2 },    { "G4", 1 },
                                                        { "G40", 1 },  { "G64", 1 },   { "M0", 1 },   { "M3", 1 },
                                                        { "M30", 1 },  { "M104", 1 },  { "M105", 1 }, { "M117", 1 },
                                                        { "M220", 1 }, { "M862.3", 1 } };
  EXPECT_EQ(summary.ignored, expected);
}
}  // namespace
}  // namespace test
}  // namespace pkm_workspace
