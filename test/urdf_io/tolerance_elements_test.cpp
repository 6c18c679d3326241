// SPDX-License-Identifier: BSD-3-Clause
// Tolerances in a URDF: the element <pkm_tolerances>, which other readers pass over.
#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include "urdf_io/expect_refused.h"
#include "urdf_io/urdf_edit.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
const std::string ALL = "<pkm_tolerances tolerance_length=\"0.0001\" tolerance_slider=\"2e-4\"/>";

UrdfOptions given(const char* name, const std::vector<double>& numbers)
{
  UrdfOptions options;
  options.tolerances.set(*toleranceKind(name), numbers);
  return options;
}

std::vector<double> numbersIn(const std::string& elements, const char* name, const UrdfOptions& options = {})
{
  return numbersOf(*toleranceKind(name), tolerancesOf(readUrdf(withElements(good(), elements), options).machine));
}

void expectWritten(const Tolerances& tolerances, const std::string& element)
{
  const Machine machine = withTolerances(orthoglide(), tolerances);
  const std::string urdf = writeUrdf(machine);
  EXPECT_NE(urdf.find(element), std::string::npos) << urdf.substr(urdf.find("<pkm"));
  const Machine read = readUrdf(urdf).machine;
  EXPECT_EQ(read.geometryHash(), withTolerances(readUrdf(good()).machine, tolerances).geometryHash());
  EXPECT_TRUE(urdf::parseURDF(urdf));
}
}  // namespace

TEST(ToleranceElements, areReadAndOthersPassOverThem)
{
  EXPECT_EQ(numbersIn(ALL, "tolerance_length"), std::vector<double>{ 1e-4 });
  EXPECT_EQ(numbersIn(ALL, "tolerance_slider"), std::vector<double>{ 2e-4 });
  EXPECT_EQ(numbersIn(ALL, "tolerance_zero"), std::vector<double>{ 0.0 });
  EXPECT_TRUE(urdf::parseURDF(withElements(good(), ALL)));
  EXPECT_TRUE(readUrdf(withElements(good(), ALL)).warnings.empty());
  EXPECT_FALSE(readUrdf(good()).machine.hasTolerances());
}

TEST(ToleranceElements, ofOneJointCountInPlaceOfThoseOfAll)
{
  const std::string one = "<pkm_tolerances joint=\"rail_y\" tolerance_slider=\"1e-3 0 2e-3\" tolerance_zero=\"1e-3\"/>";
  for (const std::string& both : { ALL + one, one + ALL })
  {
    EXPECT_EQ(numbersIn(both, "tolerance_length"), std::vector<double>{ 1e-4 });
    EXPECT_EQ(numbersIn(both, "tolerance_slider"),
              (std::vector<double>{ 2e-4, 2e-4, 2e-4, 1e-3, 0, 2e-3, 2e-4, 2e-4, 2e-4 }));
    EXPECT_EQ(numbersIn(both, "tolerance_zero"), (std::vector<double>{ 0, 1e-3, 0 }));
  }
  UrdfOptions turned;
  turned.rails = { "rail_y", "rail_z", "rail_x" };  // by the joint, whatever the order of the legs
  EXPECT_EQ(numbersIn(one, "tolerance_zero", turned)[readUrdf(good(), turned).machine.leg(0).joint == "rail_y" ? 0 : 1],
            1e-3);
}

TEST(ToleranceElements, givenOnesCountInPlaceOfTheirKind)
{
  EXPECT_EQ(numbersIn(ALL, "tolerance_length", given("tolerance_length", { 0.0 })), std::vector<double>{ 0.0 });
  EXPECT_EQ(numbersIn(ALL, "tolerance_slider", given("tolerance_length", { 0.0 })), std::vector<double>{ 2e-4 });
  EXPECT_EQ(numbersIn(ALL, "tolerance_zero", given("tolerance_zero", { 1e-3, 0, 0 })),
            (std::vector<double>{ 1e-3, 0, 0 }));
}

TEST(ToleranceElements, areWrittenAsTheyAre)
{
  Tolerances tolerances;
  setTolerance(*toleranceKind("tolerance_length"), { 1e-4 }, tolerances);
  setTolerance(*toleranceKind("tolerance_direction"), { 0.1 / 3.0 }, tolerances);
  expectWritten(tolerances, "<pkm_tolerances tolerance_length=\"0.0001\" tolerance_direction=\"0.03333333333333333");
  setTolerance(*toleranceKind("tolerance_slider"), { 0, 0, 0, 1e-3, 2e-3, 3e-3, 0, 0, 0 }, tolerances);
  expectWritten(tolerances,
                "<pkm_tolerances joint=\"rail_y\" tolerance_length=\"0.0001\" "
                "tolerance_slider=\"0.001 0.002 0.003\"");
  setTolerance(*toleranceKind("tolerance_length"), { 0, 1e-4, 0 }, tolerances);
  setTolerance(*toleranceKind("tolerance_direction"), { 0 }, tolerances);
  const std::string one_leg = writeUrdf(withTolerances(orthoglide(), tolerances));
  EXPECT_EQ(one_leg.find("<pkm_tolerances joint=\"rail_x\""), std::string::npos);
  expectWritten(tolerances, "<pkm_tolerances joint=\"rail_y\"");
  EXPECT_EQ(writeUrdf(withTolerances(orthoglide(), {})), good());
}

TEST(ToleranceElements, whatIsNotUnderstoodIsRefusedWithItsLine)
{
  const auto refused = [](const std::string& elements, const std::string& pattern) {
    expectRefused(withElements(good(), elements), "line [0-9]+: <" + pattern);
  };
  refused("<pkm_tolerances length=\"1e-4\"/>",
          "pkm_tolerances>: it has no attribute length; these are: joint, tolerance_length");
  refused("<pkm_tolerances tolerance_length=\"-1e-4\"/>",
          "pkm_tolerances>: tolerance_length = -0.0001 m must be from 0 to 1000 m");
  refused("<pkm_tolerances tolerance_length=\"wide\"/>", "pkm_tolerances>: tolerance_length=\"wide\" must be a number");
  refused("<pkm_tolerances tolerance_length=\"\"/>", "pkm_tolerances>: tolerance_length=\"\" must be a number");
  refused("<pkm_tolerances tolerance_length=\"nan\"/>", "pkm_tolerances>: tolerance_length");
  refused("<pkm_tolerances tolerance_slider=\"1e-4 0 0\"/>",
          "pkm_tolerances>: tolerance_slider has one number for all legs; give one leg its own with joint=\"NAME\"");
  refused("<pkm_tolerances joint=\"rail_x\" tolerance_length=\"1e-4 0 0\"/>",
          "pkm_tolerances joint=\"rail_x\">: tolerance_length has 3 numbers, expected one for a leg");
  refused("<pkm_tolerances joint=\"elbow\" tolerance_length=\"1e-4\"/>",
          "pkm_tolerances joint=\"elbow\">: there is no such rail, expected one of 'rail_x', 'rail_y', 'rail_z'");
  refused(ALL + ALL, "pkm_tolerances>: a second one for all legs, expected one");
  refused("<pkm_tolerances/>", "pkm_tolerances>: expected attributes");
  refused("<pkm_tolerances tolerance_zero=\"0\"><joint/></pkm_tolerances>",
          "pkm_tolerances>: expected attributes .*, and no elements");
  refused("<pkm_tolerance tolerance_length=\"1e-4\"/>", "pkm_tolerance> is not understood within <robot>");
  refused("<gazebo>" + ALL + "</gazebo>", "pkm_tolerances> is not understood within <gazebo>");
  expectRefused(withElements(good(), "<pkm_tolerances tolerance_length=\"0.5\"/>"),
                "a tolerance of 0.5 m of its strut's length must be at most 0.1 m");
}
}  // namespace test
}  // namespace pkm_workspace
