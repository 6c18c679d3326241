// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "urdf_io/expect_refused.h"
#include "urdf_io/urdf_edit.h"

namespace pkm_workspace
{
namespace test
{
TEST(UrdfRefusal, theUneditedFileIsRead)
{
  EXPECT_NO_THROW(readUrdf(good()));
  EXPECT_TRUE(readUrdf(good()).warnings.empty());
}

// The text as such

TEST(UrdfRefusal, textThatIsNoXml)
{
  expectRefused("", "not well-formed XML: .*XML_ERROR_EMPTY_DOCUMENT");
  expectRefused("rail_x", "not well-formed XML");
  expectRefused(replaced(good(), "</robot>", ""), "not well-formed XML: .*XML_ERROR_PARSING");
  expectRefused(good() + std::string(1, '\0'), "holds a zero byte");
  expectRefused(good() + std::string(4 * 1024 * 1024, ' '), "longer than the 4194304 bytes that are read");
}

TEST(UrdfRefusal, theWrongOutermostElement)
{
  expectRefused("<sdf><robot name=\"x\"/></sdf>", "outermost element is <sdf>, expected <robot>");
  expectRefused("<!-- nothing -->", "outermost element is <>, expected <robot>");
  expectRefused(good() + "<robot name=\"second\"/>", "a second outermost element <robot>, expected one <robot>");
  expectRefused(withElements(good(), "<robot name=\"second\"/>"), "line [0-9]+: a second <robot> inside the first");
}

TEST(UrdfRefusal, whatWouldCrashOrHangTheParser)
{
  std::string nested;
  for (int i = 0; i < 200000; ++i)
    nested += "<a>";
  expectRefused(nested, "nested deeper than 50");
  std::string closed;
  for (int i = 0; i < 60; ++i)
    closed = "<a>" + closed + "</a>";
  expectRefused(withElements(good(), closed), "nested deeper than 50");
  std::string links;
  for (int i = 0; i < 1001; ++i)
    links += "<link name=\"l" + std::to_string(i) + "\"/>";
  expectRefused(withElements(good(), links), "the robot has 10[0-9][0-9] elements <link>, at most 1000 are read");
  std::string attributes;
  for (int i = 0; i < 300000; ++i)
    attributes += " a" + std::to_string(i) + "=\"\"";
  expectRefused(withElements(good(), "<gazebo" + attributes + "/>"),
                "an element has 300000 attributes, at most 1000 are read");
  expectRefused(withElements(good(), "<link name=\"\xef\"/>"), "not printable UTF-8 \\(byte 239\\)");
  expectRefused(withElements(good(), "<link name=\"&#xb;\"/>"), "not printable UTF-8 \\(byte 11\\)");
}

TEST(UrdfRefusal, commentsInAnyEncodingAreRead)
{
  EXPECT_NO_THROW(readUrdf(withElements(good(), "<!-- \xef \xe9t\xe9 --><gazebo>text \xff</gazebo>")));
}

// What urdfdom refuses itself

TEST(UrdfRefusal, whatUrdfdomRefuses)
{
  const auto rail = [](const std::string& from, const std::string& to) {
    return withJoint(good(), "rail_x", from, to);
  };
  for (const char* const word : { "nan", "inf", "one", "0x1" })
    expectRefused(rail("xyz=\"-1 0 0\"", std::string("xyz=\"") + word + " 0 0\""), "urdfdom: .*rail_x");
  expectRefused(rail("lower=\"-1.3\"", "lower=\"-inf\""), "urdfdom: .*limit element for joint \\[rail_x\\]");
  expectRefused(rail("xyz=\"-1 0 0\"", "xyz=\"-1 0\""), "urdfdom: .*origin element for joint \\[rail_x\\]");
  expectRefused(rail("xyz=\"1 0 0\"", "xyz=\"1 0 0 0\""),
                "urdfdom: .*axis element for joint \\[rail_x\\].*4 elements but 3");
  expectRefused(rail("velocity=\"0\"", ""), "urdfdom: joint limit: no velocity");
  expectRefused(replaced(good(), "<robot name=\"orthoglide\">", "<robot>"), "urdfdom: No name given for the robot");
  expectRefused(withElements(good(), "<link name=\"tip_1\"/>"), "urdfdom: link 'tip_1' is not unique");
  expectRefused(withElements(good(), "<link name=\"floor\"/>"),
                "urdfdom: .*Two root links found: \\[base_link\\] and \\[floor\\]");
  expectRefused(rail("type=\"prismatic\"", "type=\"sliding\""),
                "urdfdom: Joint \\[rail_x\\] has no known type \\[sliding\\]");
  expectRefused(withJoint(good(), "revolute_1", "continuous", "revolute"), "REVOLUTE but it does not specify limits");
  expectRefused(rail("<limit lower=\"-1.3\" upper=\"2.3\" effort=\"0\" velocity=\"0\"/>", ""),
                "PRISMATIC without limits");
  expectRefused(rail("<parent link=\"base_link\"/>", "<parent link=\"nowhere\"/>"),
                "parent link \\[nowhere\\].*not found");
}

TEST(UrdfRefusal, twoJointsOfOneName)
{
  const auto twice = withElements(good(),
                                  "<link name=\"x\"/><joint name=\"rail_x\" type=\"fixed\"><parent link=\"tip_1\"/>"
                                  "<child link=\"x\"/></joint>");
  expectRefused(twice, "urdfdom: joint 'rail_x' is not unique");
}

// What urdfdom accepts in silence

TEST(UrdfRefusal, wrongLimits)
{
  const auto limit = [](const std::string& to) {
    return withJoint(good(), "rail_x", "lower=\"-1.3\" upper=\"2.3\" effort=\"0\" velocity=\"0\"", to);
  };
  expectRefused(limit("lower=\"2\" upper=\"1.5\" effort=\"1\" velocity=\"1\""),
                "joint 'rail_x': <limit> lower = 2 m is above upper = 1.5 m, expected lower <= upper");
  expectRefused(limit("upper=\"1\" effort=\"1\" velocity=\"1\""),
                "joint 'rail_x': <limit lower> is missing, expected a number \\[m\\] \\(URDF would take 0\\)");
  expectRefused(limit("lower=\"-1\" effort=\"1\" velocity=\"1\""), "joint 'rail_x': <limit upper> is missing");
  expectRefused(limit("lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"-2\""),
                "joint 'rail_x': <limit velocity> = -2 m/s is negative, expected 0 or more");
  expectRefused(limit("lower=\"0\" upper=\"1\" effort=\"-3\" velocity=\"1\""), "<limit effort> = -3 N is negative");
  const auto passive = withJoint(good(), "revolute_2", "type=\"continuous\">",
                                 "type=\"revolute\"><limit upper=\"1\" effort=\"-1\" velocity=\"-1\"/>");
  expectRefused(passive, "joint 'revolute_2': <limit lower> is missing, expected a number \\[rad\\]");
  expectRefused(passive, "<limit effort> = -1 N m is negative");
  expectRefused(passive, "<limit velocity> = -1 rad/s is negative");
}

TEST(UrdfRefusal, wrongAxes)
{
  const auto axis = [](const std::string& to) { return withJoint(good(), "rail_x", "<axis xyz=\"1 0 0\"/>", to); };
  expectRefused(axis("<axis xyz=\"0 0 0\"/>"), "joint 'rail_x': <axis xyz> = 0 0 0 is not a direction");
  expectRefused(axis("<axis xyz=\"0 -0 1e-400\"/>"), "joint 'rail_x': <axis xyz> = 0 0 0 is not a direction");
  expectRefused(axis(""), "joint 'rail_x': <axis xyz> is missing, expected a direction \\(URDF would take 1 0 0\\)");
  expectRefused(axis("<axis/>"), "joint 'rail_x': <axis xyz> is missing");
  expectRefused(withJoint(good(), "bar_joint_a_1", "<axis xyz=\"0 0 1\"/>", ""),
                "joint 'bar_joint_a_1': <axis xyz> is missing");
}

TEST(UrdfRefusal, wrongMimics)
{
  const auto mimic = [](const std::string& master) {
    return withJoint(good(), "revolute_back_1", "<mimic joint=\"revolute_1\"", "<mimic joint=\"" + master + "\"");
  };
  expectRefused(mimic("revolute_9"), "joint 'revolute_back_1': <mimic> follows 'revolute_9', which is not a joint");
  expectRefused(mimic("revolute_back_1"), "joint 'revolute_back_1': <mimic> follows the joint itself");
  const auto circle = withJoint(mimic("revolute_1"), "revolute_1", "<axis xyz=\"0 1 0\"/>",
                                "<axis xyz=\"0 1 0\"/><mimic joint=\"revolute_back_1\"/>");
  expectRefused(circle, "in a circle by <mimic>: 'revolute_1' -> 'revolute_back_1' -> 'revolute_1'");
}

TEST(UrdfRefusal, linksThatFormNoTree)
{
  const auto child = [](const std::string& to) {
    return withJoint(good(), "tcp_joint_1", "<child link=\"tcp_1\"/>", to);
  };
  expectRefused(child("<child link=\"tip_2\"/>"),
                "link 'tip_2' has two parents, joints 'tcp_joint_1' and 'revolute_back_2', expected one");
  expectRefused(child("<child link=\"slider_1\"/>"), "link 'slider_1' has two parents");
  const auto loop = withElements(good(),
                                 "<link name=\"a\"/><link name=\"b\"/>"
                                 "<joint name=\"ab\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>"
                                 "<joint name=\"ba\" type=\"fixed\"><parent link=\"b\"/><child link=\"a\"/></joint>");
  expectRefused(loop, "links form a loop, each the child of the next: 'a' -> 'b' -> 'a'; expected a tree");
}

TEST(UrdfRefusal, emptyNames)
{
  expectRefused(replaced(good(), "<robot name=\"orthoglide\">", "<robot name=\"\">"), "<robot name> is empty");
  expectRefused(withElements(good(), "<link name=\"\"/>"), "line [0-9]+: <link name> is empty, expected a name");
  expectRefused(replaced(good(), "<joint name=\"rail_y\"", "<joint name=\"\""), "line [0-9]+: <joint name> is empty");
  expectRefused(withJoint(good(), "rail_y", "link=\"base_link\"", "link=\"\""),
                "joint 'rail_y': <parent link> is empty");
}

TEST(UrdfRefusal, whatIsGivenTwice)
{
  expectRefused(
      withJoint(good(), "rail_z", "<limit", "<limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/><limit"),
      "joint 'rail_z': <limit> is given 2 times, expected once");
  expectRefused(withJoint(good(), "rail_z", "<origin", "<origin xyz=\"0 0 0\"/><origin/><origin"),
                "joint 'rail_z': <origin> is given 3 times, expected once");
  expectRefused(withJoint(good(), "rail_z", "lower=\"-1.3\"", "lower=\"-1.3\" lower=\"0\""),
                "not well-formed XML: .*XML_ERROR_PARSING_ATTRIBUTE.*XMLElement name=limit");
}

TEST(UrdfRefusal, numbersOutOfRange)
{
  expectRefused(
      withJoint(good(), "rail_x", "xyz=\"-1 0 0\"", "xyz=\"-1e10 0 0\""),
      "joint 'rail_x': <origin xyz> = -10000000000 0 0 m is out of range, expected numbers from -1000000000 to "
      "1000000000");
  expectRefused(withJoint(good(), "rail_x", "xyz=\"-1 0 0\"", "xyz=\"-1 0 0\" rpy=\"0 0 2e9\""),
                "joint 'rail_x': <origin rpy> = 0 0 2000000000 rad is out of range");
}

TEST(UrdfRefusal, everythingThatIsWrongIsToldAtOnce)
{
  auto urdf = withJoint(good(), "rail_x", "lower=\"-1.3\"", "lower=\"5\"");
  urdf = withJoint(urdf, "rail_y", "<axis xyz=\"0 1 0\"/>", "");
  urdf = withJoint(urdf, "rail_z", "velocity=\"0\"", "velocity=\"fast\"");
  expectRefused(urdf,
                "joint 'rail_x': <limit> lower = 5 m is above upper = 2.3 m[^]*joint 'rail_y': <axis xyz> is "
                "missing[^]*urdfdom: .*velocity value \\(fast\\)|rail_z");
}
}  // namespace test
}  // namespace pkm_workspace
