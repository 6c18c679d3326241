// SPDX-License-Identifier: BSD-3-Clause
#include "model.h"
#include "refusal.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <atomic>
#include <mutex>
#include <thread>

namespace pkm_workspace
{
namespace urdf_io
{
namespace
{
/// Catches what urdfdom says while it parses: console_bridge has one output handler for the whole process.
class Listener : public console_bridge::OutputHandler
{
public:
  /// The only one, which is never destroyed: console_bridge keeps its pointer as "the previous one".
  static Listener& instance()
  {
    static Listener& listener = *new Listener;
    return listener;
  }
  void log(const std::string& text, console_bridge::LogLevel level, const char* file, int line) override
  {
    console_bridge::OutputHandler* const others = others_;
    if (std::this_thread::get_id() == thread_)
      messages.push_back(text);
    else if (others != nullptr)
      others->log(text, level, file, line);
  }
  void begin()
  {
    thread_ = std::this_thread::get_id();
    messages.clear();
    level_ = console_bridge::getLogLevel();
    others_ = console_bridge::getOutputHandler();
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_WARN);
    console_bridge::useOutputHandler(this);
  }
  void end()
  {
    console_bridge::restorePreviousOutputHandler();
    console_bridge::setLogLevel(level_);
  }

  std::mutex in_use;
  std::vector<std::string> messages;

private:
  std::atomic<std::thread::id> thread_{ std::thread::id() };
  std::atomic<console_bridge::OutputHandler*> others_{ nullptr };
  console_bridge::LogLevel level_ = console_bridge::CONSOLE_BRIDGE_LOG_WARN;
};

/// Listens for as long as it lives.
class Listening
{
public:
  Listening() : lock_(Listener::instance().in_use) { Listener::instance().begin(); }
  ~Listening() { Listener::instance().end(); }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;
  const std::vector<std::string>& messages() const { return Listener::instance().messages; }

private:
  std::lock_guard<std::mutex> lock_;
};

/// The tree, or null with urdfdom's reasons in @p problems. What urdfdom says of a tree it accepts is a warning.
urdf::ModelInterfaceSharedPtr parseTree(const std::string& xml, Problems& problems, std::vector<Notice>& warnings)
{
  const Listening listening;
  urdf::ModelInterfaceSharedPtr tree;
  try
  {
    tree = urdf::parseURDF(xml);
  }
  catch (const std::exception& exception)
  {
    complain(problems, "urdfdom: ", exception.what());
    return nullptr;
  }
  for (const std::string& message : listening.messages())
    if (tree)
      warnings.push_back({ "urdfdom: " + message, "urdfdom: " + message, "", "" });
    else
      complain(problems, "urdfdom: ", message);
  if (!tree && listening.messages().empty())
    complain(problems, "urdfdom gives no reason");
  return tree;
}

JointFollower masterOf(const urdf::Joint& joint, const urdf::ModelInterface& tree)
{
  JointFollower follower{ joint.name, joint.name, 1.0, 0.0 };
  for (const urdf::Joint* next = &joint; next->mimic; next = tree.joints_.at(follower.source).get())
  {
    follower.offset += follower.factor * next->mimic->offset;
    follower.factor *= next->mimic->multiplier;
    follower.source = next->mimic->joint_name;
  }
  return follower;
}
}  // namespace

std::string typeOf(const urdf::Joint& joint)
{
  const char* const names[] = { "unknown", "revolute", "continuous", "prismatic", "floating", "planar", "fixed" };
  return names[joint.type];
}

Model readModel(const std::string& xml)
{
  Problems problems;
  Model model;
  model.document = readDocument(xml, problems);
  model.tree = parseTree(model.document.elements, problems, model.document.warnings);
  throwRefusal(problems);
  for (const auto& joint : model.tree->joints_)
    model.masters.emplace(joint.first, masterOf(*joint.second, *model.tree));
  return model;
}
}  // namespace urdf_io
}  // namespace pkm_workspace
