// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRankWatch: sees to it that a rank does not wait for the others in silence. A collective
// call of a communicator cannot be ended from outside, so a thread says what is waited for, and
// ends the process when the user has set a limit.
#ifndef vtkWaterRankWatch_h
#define vtkWaterRankWatch_h

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

class vtkWaterRankWatch
{
public:
  vtkWaterRankWatch() = default;
  ~vtkWaterRankWatch();
  vtkWaterRankWatch(const vtkWaterRankWatch&) = delete;
  void operator=(const vtkWaterRankWatch&) = delete;

  // Seconds until the process is ended; 0: it is not.
  void SetLimit(double seconds);

  // What began, as "rank 1 of 4" and "what all ranks show in a frame". Ended by End.
  void Begin(const std::string& who, const char* what);
  void End();

private:
  using Clock = std::chrono::steady_clock;

  void Run();
  void Say(double seconds, bool isLast);

  std::mutex Mutex;
  std::condition_variable Changed;
  std::thread Thread; // started by the first wait
  Clock::time_point Begun;
  std::string Who;
  const char* What = "";
  double Limit = 0.0;
  bool IsWaiting = false;
  bool IsIdle = false; // the thread sleeps until it is told
  bool IsSaid = false; // that this wait is long
  bool IsEnded = false;
};

#endif
