// SPDX-License-Identifier: BSD-3-Clause
#include "pkm_workspace/common/parallel.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <csignal>
#include <filesystem>
#include <iterator>

namespace pkm_workspace
{
namespace test
{
namespace
{
std::atomic<bool> is_stopped{ false };
std::atomic<bool> may_go_on{ false };

/// What a thread does that the scheduler does not run.
void standStill(int)
{
  is_stopped = true;
  while (!may_go_on)
    ;
}

int threadsOfThisProcess()
{
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return static_cast<int>(std::distance(begin(tasks), end(tasks)));
}

/// Work that ends only where that many threads share it.
void meet(ThreadPool& pool, std::size_t threads)
{
  std::atomic<std::size_t> here(0);
  pool.forEach(threads, [&](std::size_t) {
    ++here;
    while (here < threads)
      ;
  });
}
}  // namespace

TEST(ThreadPool, doesEveryIndexOnce)
{
  for (const int threads : { 1, 2, 3, 8 })
  {
    ThreadPool pool(threads, 0.0);
    for (std::size_t count = 0; count < 400; ++count)
    {
      std::vector<int> done(count, 0);
      pool.forEach(count, [&](std::size_t index) { ++done[index]; });
      ASSERT_EQ(std::vector<int>(count, 1), done) << threads << " threads";
    }
  }
}

TEST(ThreadPool, startsNobodyForShortWork)
{
  const int before = threadsOfThisProcess();
  ThreadPool pool(8);
  int most = 0;
  for (int k = 0; k < 20; ++k)
    pool.forEach(16, [&](std::size_t) {});
  pool.forEach(2, [&](std::size_t) { most = std::max(most, threadsOfThisProcess()); });
  EXPECT_EQ(before, most);
}

TEST(ThreadPool, sharesLongWorkAmongAll)
{
  ThreadPool pool(4, 0.0);
  meet(pool, 4);
}

TEST(ThreadPool, doesNotWaitForAThreadThatHasBegunNothing)
{
  ThreadPool pool(2, 0.0);
  const pthread_t caller = pthread_self();
  std::atomic<pthread_t> helper(caller);
  std::atomic<int> here(0);
  pool.forEach(2, [&](std::size_t) {
    if (!pthread_equal(pthread_self(), caller))
      helper = pthread_self();
    for (++here; here < 2;)
      ;
  });
  struct sigaction action
  {
  };
  struct sigaction before
  {
  };
  action.sa_handler = standStill;
  sigaction(SIGUSR1, &action, &before);
  pthread_kill(helper, SIGUSR1);
  while (!is_stopped)
    ;
  std::size_t done = 0;
  for (int k = 0; k < 1000; ++k)
    pool.forEach(16, [&](std::size_t) { ++done; });
  EXPECT_EQ(16000U, done);
  may_go_on = true;
  meet(pool, 2);
  sigaction(SIGUSR1, &before, nullptr);
}
}  // namespace test
}  // namespace pkm_workspace
