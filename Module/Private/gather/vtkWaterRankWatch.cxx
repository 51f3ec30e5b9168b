// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterRankWatch.h"

#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace
{
constexpr double kPatience = 10.0; // s, until a wait is said
}

//------------------------------------------------------------------------------
vtkWaterRankWatch::~vtkWaterRankWatch()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsEnded = true;
  }
  this->Changed.notify_all();
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

//------------------------------------------------------------------------------
void vtkWaterRankWatch::SetLimit(double seconds)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Limit = seconds;
  }
  this->Changed.notify_all();
}

//------------------------------------------------------------------------------
void vtkWaterRankWatch::Begin(const std::string& who, const char* what)
{
  bool wasIdle = false;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Begun = Clock::now();
    this->Who = who;
    this->What = what;
    this->IsWaiting = true;
    this->IsSaid = false;
    wasIdle = this->IsIdle;
  }
  if (!this->Thread.joinable())
  {
    try
    {
      this->Thread = std::thread([this]() { this->Run(); });
    }
    catch (const std::system_error&)
    {
      // without a thread there is no watch; the other ranks still wait in this call
    }
  }
  else if (wasIdle) // else it wakes before this wait is long
  {
    this->Changed.notify_all();
  }
}

//------------------------------------------------------------------------------
void vtkWaterRankWatch::End()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->IsWaiting = false;
}

//------------------------------------------------------------------------------
void vtkWaterRankWatch::Say(double seconds, bool isLast)
{
  // not by VTK: its output windows belong to the thread that waits
  std::fprintf(stderr,
    "vtkWaterReflectionPass: %s has waited %.3g s for the other ranks, for %s. Every rank must "
    "show "
    "this water with a controller and render each frame, and none may have ended. %s\n",
    this->Who.c_str(), seconds, this->What,
    isLast ? "The time of SetRankWaitLimit is over: this process ends."
           : "It keeps waiting; SetRankWaitLimit can limit this.");
  std::fflush(stderr);
}

//------------------------------------------------------------------------------
void vtkWaterRankWatch::Run()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (!this->IsEnded)
  {
    const bool isLimited = this->Limit > 0.0;
    if (!this->IsWaiting || (this->IsSaid && !isLimited))
    {
      this->IsIdle = true;
      this->Changed.wait(lock);
      this->IsIdle = false;
      continue;
    }
    const bool isLast = isLimited && (this->IsSaid || this->Limit <= kPatience);
    const double seconds = isLast ? this->Limit : kPatience;
    const Clock::time_point begun = this->Begun;
    const auto until =
      begun + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    if (Clock::now() < until)
    {
      this->Changed.wait_until(lock, until); // a later wait is seen then, in time
      continue;
    }
    const std::chrono::duration<double> waited = Clock::now() - begun;
    this->Say(waited.count(), isLast);
    if (isLast)
    {
      std::_Exit(EXIT_FAILURE); // nothing may be destroyed under a thread that waits
    }
    this->IsSaid = true;
  }
}
