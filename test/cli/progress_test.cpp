// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <gtest/gtest.h>

#include <sstream>

namespace pkm_workspace
{
namespace cli
{
namespace
{
/// Text that a test waits for.
class Listener : public std::streambuf
{
public:
  /// Returns once the text ends with @p end. @return all of it
  std::string waitFor(const std::string& end)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] {
      return text_.size() >= end.size() && text_.compare(text_.size() - end.size(), end.size(), end) == 0;
    });
    return text_;
  }

protected:
  int_type overflow(int_type letter) override
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    text_.push_back(traits_type::to_char_type(letter));
    changed_.notify_all();
    return letter;
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string text_;
};

constexpr std::chrono::milliseconds SOON(1);
constexpr std::chrono::hours NEVER(24);
}  // namespace

TEST(Progress, speaksWithoutATerminalAndWithoutBeingTold)
{
  Listener listener;
  std::ostream stream(&listener);
  const Progress progress(stream, false, SOON);
  EXPECT_EQ(listener.waitFor("\n").find("0 s: still computing\n"), 0u);
}

TEST(Progress, saysWhatItWasToldLast)
{
  Listener listener;
  std::ostream stream(&listener);
  Progress progress(stream, false, SOON);
  progress.tell("size 1");
  progress.tell("size 2");
  const std::string text = listener.waitFor(" s: size 2\n");
  EXPECT_EQ(text.find('\r'), std::string::npos) << "what is no terminal gets lines";
}

TEST(Progress, takesItsLineAwayFromATerminal)
{
  Listener listener;
  std::ostream stream(&listener);
  {
    const Progress progress(stream, true, SOON);
    listener.waitFor(" s: still computing");
  }
  const std::string text = listener.waitFor("\r\033[K");
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(Progress, isSilentAboutShortComputations)
{
  std::ostringstream stream;
  for (const bool is_terminal : { false, true })
    Progress(stream, is_terminal, NEVER).tell("size 1");
  EXPECT_EQ(stream.str(), "");
}
}  // namespace cli
}  // namespace pkm_workspace
