// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <sstream>

#include "pkm_workspace/machine/catalogue.h"
#include "pkm_workspace/urdf_io/urdf_reader.h"
#include "pkm_workspace/urdf_io/urdf_writer.h"
#include "support/comma_locale.h"
#include "support/random.h"
#include "urdf_io/expect_machine.h"
#include "urdf_io/urdf_edit.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
using Number = boost::multiprecision::cpp_bin_float_100;
using Exact = Eigen::Matrix<Number, 3, 1>;
using ExactMatrix = Eigen::Matrix<Number, 3, 3>;
using Eigen::Vector3d;

Vector3d anyVector(Random& random, double size)
{
  return { random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size) };
}

std::string text(const Vector3d& v)
{
  std::ostringstream stream;
  stream.precision(17);
  stream << "\"" << v.x() << " " << v.y() << " " << v.z() << "\"";
  return stream.str();
}

/// Rz(yaw) Ry(pitch) Rx(roll), in 100 digits.
ExactMatrix exactRotation(const Vector3d& rpy)
{
  const Number cr = cos(Number(rpy[0])), sr = sin(Number(rpy[0]));
  const Number cp = cos(Number(rpy[1])), sp = sin(Number(rpy[1]));
  const Number cy = cos(Number(rpy[2])), sy = sin(Number(rpy[2]));
  ExactMatrix rotation;
  rotation << cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr, sy * cp, sy * sp * sr + cy * cr,
      sy * sp * cr - cy * sr, -sp, cp * sr, cp * cr;
  return rotation;
}

/// One leg as its URDF has it.
struct RandomLeg
{
  Vector3d origin;
  Vector3d rpy;
  Vector3d axis;
  Vector3d strut;
  Vector3d tcp;

  std::string urdf(const std::string& n) const
  {
    const std::string first = "<axis xyz=\"0 0.5 2\"/>";
    const std::string second = "<axis xyz=\"1 0 0\"/>";
    return branch("rail" + n, "prismatic", "base",
                  "<origin xyz=" + text(origin) + " rpy=" + text(rpy) + "/><axis xyz=" + text(axis) +
                      "/><limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>") +
           branch("u" + n, "continuous", "rail" + n, first) + branch("v" + n, "continuous", "u" + n, second) +
           branch("w" + n, "continuous", "v" + n,
                  "<origin xyz=" + text(strut) + "/>" + second + "<mimic joint=\"v" + n + "\" multiplier=\"-1\"/>") +
           branch("t" + n, "continuous", "w" + n, first + "<mimic joint=\"u" + n + "\" multiplier=\"-1\"/>") +
           branch("tcp" + n, "fixed", "t" + n, "<origin xyz=" + text(tcp) + "/>");
  }
};

/// A leg that reaches the point p in the frame of its mount, up to rounding.
RandomLeg legTo(const Vector3d& p, double scale, Random& random)
{
  RandomLeg leg;
  leg.origin = anyVector(random, 2.0 * scale);
  leg.rpy = anyVector(random, 4.0);
  leg.axis = anyVector(random, 3.0);
  leg.strut = scale * (anyVector(random, 0.3) + leg.axis.normalized());
  const Eigen::Matrix3d rotation = exactRotation(leg.rpy).cast<double>();
  leg.tcp = rotation.transpose() * (p - leg.origin) - leg.strut;
  return leg;
}

void expectContains(const IntervalVector& enclosure, const Exact& exact)
{
  for (int k = 0; k < 3; ++k)
  {
    const Interval& side = enclosure[static_cast<std::size_t>(k)];
    EXPECT_TRUE(side.lower() <= exact[k] && exact[k] <= side.upper()) << side << " and " << exact[k];
  }
}

void expectEncloses(const Leg& leg, const RandomLeg& random, const Vector3d& mount_at, const Vector3d& mount_rpy)
{
  const ExactMatrix mount = exactRotation(mount_rpy);
  const ExactMatrix slider = mount * exactRotation(random.rpy);
  const Exact axis = random.axis.cast<Number>();
  const Exact strut = random.strut.cast<Number>();
  expectContains(slidingStrut(leg).origin, mount_at.cast<Number>() + mount * random.origin.cast<Number>());
  expectContains(slidingStrut(leg).axis, slider * (axis / sqrt(Number(axis.dot(axis)))));
  expectContains(slidingStrut(leg).platform, -(slider * random.tcp.cast<Number>()));
  const Number length = sqrt(Number(strut.dot(strut)));
  EXPECT_TRUE(slidingStrut(leg).length.lower() <= length && length <= slidingStrut(leg).length.upper())
      << slidingStrut(leg).length << " and " << length;
}

/// The UraneSX with other numbers for the axes of its rails.
Machine withAxes(const std::array<std::string, 3>& axes, const std::string& mount)
{
  std::string urdf = writeUrdf(uranesx());
  for (std::size_t i = 0; i < 3; ++i)
    urdf = withJoint(urdf, "rail_" + std::to_string(i + 1), "axis xyz=\"0 0 1\"", "axis xyz=\"" + axes[i] + "\"");
  return readUrdf(mounted(urdf, mount)).machine;
}
}  // namespace

TEST(UrdfEnclosure, holdsTheExactNumbersOfTurnedRailsOnTurnedMounts)
{
  const std::uint64_t seed = 20260801;
  Random random(seed);
  for (int run = 0; run < cases(); ++run)
  {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", run " + std::to_string(run));
    const double scale = std::pow(10.0, random.integer(-3, 3));
    const Vector3d mount_at = anyVector(random, 100.0 * scale);
    const Vector3d mount_rpy = anyVector(random, 4.0);
    const Vector3d p = anyVector(random, scale);
    std::array<RandomLeg, 3> legs;
    std::string urdf =
        "<robot name=\"random\"><link name=\"world\"/>" +
        branch("base", "fixed", "world", "<origin xyz=" + text(mount_at) + " rpy=" + text(mount_rpy) + "/>");
    for (std::size_t i = 0; i < 3; ++i)
    {
      legs[i] = legTo(p, scale, random);
      urdf += legs[i].urdf(std::to_string(i));
    }
    const Machine machine = readUrdf(urdf + "</robot>").machine;
    for (int i = 0; i < 3; ++i)
      expectEncloses(machine.leg(i), legs[static_cast<std::size_t>(i)], mount_at, mount_rpy);
    EXPECT_LE(widest(machine), 1e-12 * scale + 1e-14);
  }
}

TEST(UrdfEnclosure, mountsByQuartersAndShiftsKeepExactNumbers)
{
  // The rails' own numbers are exact; a shift by doubles leaves them so, and a turn by the decimals of pi is none by
  // pi.
  const Machine machine = readUrdf(mounted(writeUrdf(orthoglide()), "xyz=\"8 -4 0.5\"")).machine;
  EXPECT_EQ(slidingStrut(machine.leg(2)).origin, (IntervalVector{ 8.0, -4.0, -0.5 }));
  EXPECT_EQ(slidingStrut(machine.leg(2)).axis, (IntervalVector{ 0.0, 0.0, 1.0 }));
  EXPECT_EQ(machine.zero(), Vector3d(8.0, -4.0, 0.5));
  const Machine turned = readUrdf(mounted(writeUrdf(orthoglide()), "rpy=\"0 0 1.5707963267948966\"")).machine;
  EXPECT_EQ(slidingStrut(turned.leg(2)).axis, (IntervalVector{ 0.0, 0.0, 1.0 }));
  EXPECT_TRUE(slidingStrut(turned.leg(0)).axis[0].certainlyPositive()) << "the double is below pi / 2";
  EXPECT_LE(slidingStrut(turned.leg(0)).axis[0].upper(), 6.2e-17);
}

TEST(UrdfEnclosure, parallelRailsHaveTheSameNumbers)
{
  const std::string mount = "xyz=\"1 2 3\" rpy=\"0.3 -0.2 1.1\"";
  EXPECT_TRUE(withAxes({ "0 0 1", "0 0 3", "0 0 0.1" }, mount).hasParallelRails());
  EXPECT_TRUE(withAxes({ "1 0.13 7.4", "2 0.26 14.8", "0.25 0.0325 1.85" }, mount).hasParallelRails());
  EXPECT_TRUE(withAxes({ "1 0.13 7.4", "3 0.39 22.2", "1 0.13 7.4" }, mount).hasParallelRails() ==
              (3 * 0.13 == 0.39 && 3 * 7.4 == 22.2));
}

TEST(UrdfEnclosure, railsAgainstEachOtherAreParallelToo)
{
  std::string urdf = writeUrdf(uranesx());
  urdf = withJoint(urdf, "rail_2", "axis xyz=\"0 0 1\"", "axis xyz=\"0 0 -2\"");
  const Machine machine = readUrdf(mounted(urdf, "rpy=\"1 1 1\"")).machine;
  EXPECT_TRUE(machine.hasParallelRails());
  EXPECT_EQ(slidingStrut(machine.leg(1)).working_mode, 1);
  EXPECT_EQ(slidingStrut(machine.leg(2)).working_mode, -1);
}

TEST(UrdfEnclosure, railsTurnedAboutTheirOwnDirectionAreParallel)
{
  // Each leg is a copy of the first, turned by 120 degrees about z on a tilted mount.
  std::string urdf = writeUrdf(uranesx());
  const auto leg = urdf.substr(urdf.find("<joint name=\"rail_1\""),
                               urdf.find("<joint name=\"rail_2\"") - urdf.find("<joint name=\"rail_1\""));
  for (const std::string n : { "2", "3" })
  {
    std::string copy = leg;
    for (std::size_t at = copy.find("_1\""); at != std::string::npos; at = copy.find("_1\"", at + 1))
      copy[at + 1] = n[0];
    copy = withJoint(copy, "rail_" + n, "<origin xyz=\"0.5384615384615385 0 0\"/>",
                     "<origin xyz=\"" +
                         std::string(n == "2" ? "-0.26923076923 0.46632137127" : "-0.26923076923 -0.46632137127") +
                         " 0\" rpy=\"0 0 " + (n == "2" ? "2.0943951024" : "-2.0943951024") + "\"/>");
    const std::size_t begin = urdf.find("<joint name=\"rail_" + n + "\"");
    const std::size_t end =
        n == "2" ? urdf.find("<joint name=\"rail_3\"") : urdf.find("<joint name=\"platform_joint\"");
    urdf = urdf.substr(0, begin) + copy + urdf.substr(end);
  }
  const UrdfMachine read = readUrdf(mounted(urdf, "rpy=\"0.1 0.2 0.3\""));
  EXPECT_TRUE(read.machine.hasParallelRails());
  EXPECT_TRUE(read.warnings.empty());
}

TEST(UrdfEnclosure, railsThatOnlyLookParallelShareNoDirection)
{
  // The last axes differ, yet doubles enclose their directions by the same numbers.
  const Machine nearly = withAxes({ "1 0.13 7.4", "1 0.13 7.4", "1 0.13 7.4000000000000012" }, "");
  EXPECT_EQ(slidingStrut(nearly.leg(0)).direction, slidingStrut(nearly.leg(1)).direction);
  EXPECT_EQ(slidingStrut(nearly.leg(2)).direction, 0);
  EXPECT_FALSE(withAxes({ "1 0.13 7.4", "1 0.13 7.4", "1 0.13 7.4000000000000012" }, "").hasParallelRails());
  EXPECT_FALSE(
      withAxes({ "1 0.13 7.4", "1 0.13 7.4000000000000012", "-1 -0.13 -7.4000000000000012" }, "").hasParallelRails());
  EXPECT_FALSE(withAxes({ "0 0 1", "0 0 1", "0 1e-200 1" }, "").hasParallelRails());
  EXPECT_TRUE(
      withAxes({ "1 0.13 7.4000000000000012", "-1 -0.13 -7.4000000000000012", "2 0.26 14.8000000000000024" }, "")
          .hasParallelRails());
}

TEST(UrdfEnclosure, whatIsReadCanBeWritten)
{
  // directions that differ in a component of nearly 0 only, or by less than doubles tell from each other
  const std::array<std::string, 3> choices[] = { { "0 0 1", "0 0 1", "0 1e-200 1" },
                                                 { "0 0 1", "0 0 1", "0 4.94e-324 1" },
                                                 { "0 0 1", "0 1e-323 1", "4.94e-324 0 1" },
                                                 { "1 0.13 7.4", "1 0.13 7.4", "1 0.13 7.4000000000000012" } };
  for (const std::array<std::string, 3>& axes : choices)
    for (const char* const mount : { "", "rpy=\"0.1 0.2 0.3\"" })
    {
      const Machine machine = withAxes(axes, mount);
      const Machine back = readUrdf(writeUrdf(machine)).machine;
      EXPECT_EQ(back.hasParallelRails(), machine.hasParallelRails()) << axes[1] << ", " << axes[2] << ' ' << mount;
    }
}

TEST(UrdfEnclosure, readsDecimalsInAnyLocale)
{
  const std::string before = writeUrdf(uranesx());
  const std::string hash = readUrdf(before).machine.geometryHash();
  const CommaLocale locale;
  EXPECT_EQ(before, writeUrdf(uranesx()));
  EXPECT_EQ(hash, readUrdf(before).machine.geometryHash());
}
}  // namespace test
}  // namespace pkm_workspace
