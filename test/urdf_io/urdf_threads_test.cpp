// SPDX-License-Identifier: BSD-3-Clause
#include <console_bridge/console.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "urdf_io/expect_refused.h"
#include "urdf_io/urdf_edit.h"

namespace pkm_workspace
{
namespace test
{
namespace
{
/// Counts what others say.
class Counter : public console_bridge::OutputHandler
{
public:
  void log(const std::string&, console_bridge::LogLevel, const char*, int) override { ++count; }
  std::atomic<int> count{ 0 };
};

std::string brokenAt(const std::string& joint)
{
  return withJoint(good(), joint, "velocity=\"0\"", "velocity=\"" + joint + "\"");
}
}  // namespace

TEST(UrdfThreads, theOutputHandlerOfTheProcessComesBack)
{
  Counter counter;
  console_bridge::OutputHandler* const before = console_bridge::getOutputHandler();
  const auto level = console_bridge::getLogLevel();
  console_bridge::useOutputHandler(&counter);
  console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  expectRefused(brokenAt("rail_x"), "urdfdom: velocity value \\(rail_x\\)");
  EXPECT_EQ(console_bridge::getOutputHandler(), &counter);
  EXPECT_EQ(console_bridge::getLogLevel(), console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  EXPECT_EQ(counter.count, 0);
  console_bridge::setLogLevel(level);
  CONSOLE_BRIDGE_logError("said by somebody else");
  EXPECT_EQ(counter.count, 1);
  console_bridge::useOutputHandler(before);
}

TEST(UrdfThreads, reasonsDoNotMixBetweenThreads)
{
  const auto reader = [](const std::string& own, const std::string& other) {
    for (int run = 0; run < 50; ++run)
      try
      {
        readUrdf(brokenAt(own));
        ADD_FAILURE() << own;
      }
      catch (const std::invalid_argument& refusal)
      {
        const std::string text = refusal.what();
        EXPECT_NE(text.find("(" + own + ")"), std::string::npos) << text;
        EXPECT_EQ(text.find("(" + other + ")"), std::string::npos) << text;
      }
  };
  std::thread first(reader, "rail_x", "rail_y");
  std::thread second(reader, "rail_y", "rail_x");
  first.join();
  second.join();
}
}  // namespace test
}  // namespace pkm_workspace
