// SPDX-License-Identifier: BSD-3-Clause
// A rank that dies, throws, runs out of memory, loses its context or never comes: the others say so
// and go on, or end with an error, in time. None hangs. Each fault has processes of its own.
#include "WaterRankPart.h"
#include "WaterSocketRanks.h"
#include "WaterTestScene.h"

#include "vtkShaderProperty.h"
#include "vtkWaterReflectionPass.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace
{
constexpr int kRanks = 3;
constexpr double kWaitLimit = 2.0; // s, the setting, where ranks are to end
constexpr double kSlow = 30.0;     // s, where they are not, on a busy machine
constexpr double kPatience = 10.0; // s, from the fault to the end of every process
// What a rank sends in a frame with clear water; with more, a fault would come in the next frame.
constexpr int kMessages = 10;
// What it sends in a frame with all views between its mirrored view and its picture.
constexpr int kFirstOfViews = 9;
constexpr int kEndOfViews = 20;

enum Ends
{
  RIGHT = 0,
  ENDED_BY_LIMIT = 1, // of SetRankWaitLimit: EXIT_FAILURE
  SAID = 10,          // an error, and the rank has given up
  WRONG = 11,
  THREW = 12
};

enum Expected
{
  ALL_SAY, // each rank has an error, and reflects again once the fault is over
  ALL_GO_ON,
  OTHERS_END, // with an error
  NONE_HANGS  // VTK alone does not survive it everywhere
};

struct Fault
{
  std::string Name;
  Expected Ending;
  bool IsFirst; // in the first frame
  int Rank;
  std::function<void(Part&)> Break;
  std::function<void(Part&)> Mend;
};

void Die()
{
  kill(getpid(), SIGKILL);
}
void Throw()
{
  throw std::runtime_error("of the user");
}
void LoseMemory()
{
  throw std::bad_alloc();
}
void Forget(Part& part)
{
  part.Action = nullptr;
  part.Thing->IsBroken = false;
  part.Thing->IsHidingTime = false;
  part.Thing->IsHidingData = false;
}

std::vector<Fault> GetFaults()
{
  using P = Part&;
  const auto mirrored = [](std::function<void()> action) {
    return [action](P part) { part.When(part.First, RankView::MIRRORED, action); };
  };
  const auto drawn = [](std::function<void()> action) {
    return [action](P part) { part.When(part.First, RankView::PICTURE, action); };
  };
  const auto blended = [](std::function<void()> action) {
    return [action](P part) { part.When(part.Glass, RankView::MIRRORED, action); };
  };
  const auto inView = [](RankView view, std::function<void()> action) {
    return [view, action](
             P part) { part.When(view == RankView::SKY ? part.Dome : part.First, view, action); };
  };
  const auto leave = [](P) { _exit(RIGHT); };
  const auto removeWater = [](P part) { part.Renderer->RemoveActor(part.Water); };
  const auto noController = [](P part) { part.Water->GetReflectionPass()->SetController(nullptr); };
  const auto rest = [](double seconds) {
    return [seconds](P) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); };
  };
  // what it sends is that of another version of the water
  const auto speakAs = [](double version) {
    return [version](P part) {
      vtkMultiProcessController* controller = part.Water->GetReflectionPass()->GetController();
      static_cast<WaterSocketCommunicator*>(controller->GetCommunicator())->Version = version;
    };
  };
  std::vector<Fault> faults = {
    { "leaves before the first frame", OTHERS_END, true, 2, leave, nullptr },
    { "leaves", OTHERS_END, false, 2, leave, nullptr },
    { "the root leaves", OTHERS_END, false, 0, leave, nullptr },
    { "one in the middle leaves", OTHERS_END, false, 1, leave, nullptr },
    { "is killed between frames", OTHERS_END, false, 2, [](P) { Die(); }, nullptr },
    { "is killed in its mirrored view", OTHERS_END, false, 2, mirrored(Die), nullptr },
    { "the root is killed in its mirrored view", OTHERS_END, false, 0, mirrored(Die), nullptr },
    { "is killed in its picture", OTHERS_END, false, 2, drawn(Die), nullptr },
    { "aborts in its mirrored view", OTHERS_END, false, 1, mirrored([] { std::abort(); }),
      nullptr },
    { "throws in its mirrored view", ALL_SAY, false, 2, mirrored(Throw), Forget },
    { "throws in its first mirrored view", ALL_SAY, true, 2, mirrored(Throw), Forget },
    { "the root throws in its mirrored view", ALL_SAY, false, 0, mirrored(Throw), Forget },
    { "has no memory in its mirrored view", ALL_SAY, false, 1, mirrored(LoseMemory), Forget },
    { "has no memory for what it blends", ALL_SAY, false, 1, blended(LoseMemory), Forget },
    { "throws in its own view", ALL_SAY, false, 2, inView(RankView::OWN, Throw), Forget },
    { "throws in its sun view", ALL_SAY, false, 1, inView(RankView::SUN, Throw), Forget },
    { "the root throws in its sky view", ALL_SAY, false, 0, inView(RankView::SKY, Throw), Forget },
    { "has no memory in its sun view", ALL_SAY, false, 2, inView(RankView::SUN, LoseMemory),
      Forget },
    { "is killed in its sun view", OTHERS_END, false, 2, inView(RankView::SUN, Die), nullptr },
    { "throws when it is read", ALL_SAY, false, 2,
      [](P part) {
        part.Thing->IsBroken = true;
        part.Thing->IsCulled = false;
      },
      Forget },
    { "throws when its ground is compared", ALL_SAY, false, 2,
      [](P part) {
        part.Thing->IsHidingTime = true;
        part.Thing->IsCulled = false;
      },
      Forget },
    { "the root throws when its ground is read", ALL_SAY, false, 0,
      [](P part) {
        part.Thing->IsHidingData = true;
        part.Thing->IsCulled = false;
        part.Thing->Modified();
      },
      Forget },
    { "throws when its ground is first read", ALL_SAY, true, 1,
      [](P part) { part.Thing->IsHidingData = true; }, Forget },
    { "throws in its picture", OTHERS_END, false, 2, drawn(Throw), nullptr },
    { "throws in its picture below clear water", OTHERS_END, false, 1,
      [](P part) {
        part.Water->GetWaterProperty()->RefractionOn();
        part.When(part.First, RankView::PICTURE, Throw);
      },
      nullptr },
    { "never adds its water", OTHERS_END, true, 2, removeWater, nullptr },
    { "hides its water from the first", OTHERS_END, true, 2,
      [](P part) { part.Water->VisibilityOff(); }, nullptr },
    { "has no controller", OTHERS_END, true, 2, noController, nullptr },
    { "loses its controller", OTHERS_END, false, 1, noController, nullptr },
    { "rests for long", OTHERS_END, false, 2, rest(2.0 * kWaitLimit), nullptr },
    { "rests a while", ALL_GO_ON, false, 2, rest(0.4 * kWaitLimit), nullptr },
    { "runs another version", ALL_SAY, true, 2, speakAs(1.0), speakAs(0.0) },
    { "comes to run an older version", ALL_SAY, false, 1, speakAs(-1.0), speakAs(0.0) },
    { "removes its water", ALL_SAY, false, 2, removeWater,
      [](P part) { part.Renderer->AddActor(part.Water); } },
    { "finalizes its window", ALL_GO_ON, false, 2, [](P part) { part.Window->Finalize(); },
      nullptr },
    { "finalizes its window in its mirrored view", NONE_HANGS, false, 2,
      [](P part) {
        part.When(part.First, RankView::MIRRORED, [&part]() {
          part.Action = nullptr;
          part.Window->Finalize();
        });
      },
      nullptr },
  };
  // wherever the others are in their agreements
  const auto addLeaving = [&faults](int message, const char* where, bool isFirst) {
    faults.push_back(
      { "leaves before message " + std::to_string(message) + where, OTHERS_END, isFirst, 1,
        [message](P part) {
          vtkMultiProcessController* controller = part.Water->GetReflectionPass()->GetController();
          static_cast<WaterSocketCommunicator*>(controller->GetCommunicator())->MessagesLeft =
            message;
        },
        nullptr });
  };
  for (int i = 0; i < kMessages; ++i)
  {
    addLeaving(i, " below clear water", false);
  }
  for (int i = 0; i < kMessages; ++i)
  {
    addLeaving(i, " over ground", true); // which is sent in the first frame
  }
  for (int i = kFirstOfViews; i < kEndOfViews; ++i)
  {
    addLeaving(i, " of all views", false);
  }
  return faults;
}

// What all ranks have by the fault's name.
void SetUp(Part& part, const Fault& fault, int rank)
{
  const auto isNamed = [&fault](
                         const char* word) { return fault.Name.find(word) != std::string::npos; };
  if (isNamed("clear"))
  {
    part.Water->GetWaterProperty()->RefractionOn();
  }
  if (isNamed("ground"))
  {
    part.Water->SetSheetToAutomatic();
  }
  if (isNamed("own view") || isNamed("sun view") || isNamed("sky view") || isNamed("all views"))
  {
    part.WantViews(rank == 0);
  }
}

// What a rank that is right itself does.
int Judge(Part& part, const Fault& fault, bool isFaulty)
{
  part.Render();
  if (fault.Ending == OTHERS_END)
  {
    for (int i = 0; i < 3 && part.GetError().empty(); ++i)
    {
      part.Render();
    }
    if (isFaulty) // it is there, and keeps its line
    {
      std::this_thread::sleep_for(std::chrono::duration<double>(3.0 * kWaitLimit));
    }
    return isFaulty || !part.GetError().empty() ? SAID : WRONG;
  }
  if (fault.Ending == NONE_HANGS)
  {
    part.Render();
    return RIGHT;
  }
  const bool isOfVersions = fault.Name.find("version") != std::string::npos;
  if (isOfVersions && part.GetError().find("the same version") == std::string::npos)
  {
    std::fprintf(stderr, "error: \"%s\"\n", part.GetError().c_str());
    return WRONG;
  }
  // a water that was removed says nothing
  const bool isSilent = isFaulty && !part.Renderer->HasViewProp(part.Water);
  if (!isSilent && part.GetError().empty() != (fault.Ending == ALL_GO_ON))
  {
    std::fprintf(stderr, "error: \"%s\"\n", part.GetError().c_str());
    return WRONG;
  }
  if (isFaulty && fault.Mend)
  {
    fault.Mend(part);
  }
  part.Render();
  if (!part.GetError().empty() || !part.IsReflecting())
  {
    std::fprintf(stderr, "afterwards: \"%s\"\n", part.GetError().c_str());
    return WRONG;
  }
  return RIGHT;
}

int Run(const WaterSockets& sockets, int rank, const Fault& fault)
{
  const WaterSocketRank self(sockets, rank);
  Part part(self.Controller, kRanks, kSlow);
  SetUp(part, fault, rank);
  if (!fault.IsFirst)
  {
    part.Render();
    if (!part.GetError().empty())
    {
      return WRONG;
    }
  }
  const bool isFaulty = rank == fault.Rank;
  if (fault.Ending == OTHERS_END || fault.Ending == NONE_HANGS)
  {
    part.Water->GetReflectionPass()->SetRankWaitLimit(kWaitLimit);
  }
  try
  {
    if (isFaulty)
    {
      fault.Break(part);
    }
    return Judge(part, fault, isFaulty);
  }
  catch (const std::exception& thrown)
  {
    std::fprintf(stderr, "thrown: %s\n", thrown.what());
    return THREW;
  }
}

struct Child
{
  pid_t Pid = -1;
  std::FILE* Said = nullptr; // its stderr
  int Status = 0;
  bool HasEnded = false;
  double Seconds = 0.0;

  std::string GetSaid() const
  {
    std::string text(4000, ' ');
    std::rewind(this->Said);
    text.resize(std::fread(&text[0], 1, text.size(), this->Said));
    return text;
  }
};

Child Start(const WaterSockets& sockets, int rank, const Fault& fault)
{
  Child child;
  child.Said = std::tmpfile();
  child.Pid = child.Said ? fork() : -1;
  if (child.Pid == 0)
  {
    dup2(fileno(child.Said), STDERR_FILENO);
    _exit(Run(sockets, rank, fault));
  }
  return child;
}

// A rank that is there and keeps its line ends once the others have: it has nothing more to show.
void EndLast(const Fault& fault, const std::vector<Child>& children)
{
  bool haveEnded = fault.Ending == OTHERS_END;
  for (size_t i = 0; i < children.size(); ++i)
  {
    haveEnded = haveEnded && (children[i].HasEnded || static_cast<int>(i) == fault.Rank);
  }
  const Child& faulty = children[static_cast<size_t>(fault.Rank)];
  if (haveEnded && !faulty.HasEnded)
  {
    kill(faulty.Pid, SIGKILL);
  }
}

// Waits for all of them, not for long.
void Await(const Fault& fault, std::vector<Child>& children)
{
  using Clock = std::chrono::steady_clock;
  const auto begun = Clock::now();
  // what they do before the fault counts, too
  const double most = kPatience + 10.0;
  size_t count = 0;
  while (count < children.size())
  {
    const double seconds = std::chrono::duration<double>(Clock::now() - begun).count();
    for (Child& child : children)
    {
      if (child.HasEnded)
      {
        continue;
      }
      if (seconds > most)
      {
        kill(child.Pid, SIGKILL);
      }
      if (waitpid(child.Pid, &child.Status, seconds > most ? 0 : WNOHANG) == child.Pid)
      {
        child.HasEnded = true;
        child.Seconds = seconds;
        ++count;
      }
    }
    EndLast(fault, children);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

// Has it said how long it has waited, and was that the limit? A busy machine is late.
bool SaysLimit(const std::string& said)
{
  const std::string words = "has waited ";
  const size_t at = said.find(words);
  const double seconds = at == std::string::npos ? 0.0 : std::atof(&said[at + words.size()]);
  return seconds >= kWaitLimit && seconds <= kPatience;
}

// Has it said an error and ended?
bool IsEnd(const Child& child)
{
  const int code = WIFEXITED(child.Status) ? WEXITSTATUS(child.Status) : -1;
  return code == SAID || (code == ENDED_BY_LIMIT && SaysLimit(child.GetSaid()));
}

bool IsRight(const Fault& fault, const Child& child, bool isFaulty)
{
  if (fault.Ending == OTHERS_END)
  {
    if (isFaulty)
    {
      return true; // it had its fault
    }
    return IsEnd(child);
  }
  const bool isRight = WIFEXITED(child.Status) && WEXITSTATUS(child.Status) == RIGHT;
  return isRight || (fault.Ending == NONE_HANGS && (isFaulty || IsEnd(child)));
}

bool Try(const Fault& fault)
{
  const WaterSockets sockets = WaterConnect(kRanks);
  std::vector<Child> children;
  for (int rank = 0; rank < kRanks && !sockets.empty(); ++rank)
  {
    children.push_back(Start(sockets, rank, fault));
    if (children.back().Pid < 0)
    {
      return false;
    }
  }
  WaterKeepOwn(sockets, -1); // or no rank notices that another has ended
  Await(fault, children);
  bool isGood = !children.empty();
  double seconds = 0.0;
  for (int rank = 0; rank < static_cast<int>(children.size()); ++rank)
  {
    const Child& child = children[static_cast<size_t>(rank)];
    const bool isFaulty = rank == fault.Rank;
    const bool isRight = IsRight(fault, child, isFaulty);
    seconds = isFaulty ? seconds : std::max(seconds, child.Seconds);
    if (!isRight)
    {
      std::cout << "  rank " << rank << " status " << child.Status << ": " << child.GetSaid()
                << std::endl;
    }
    isGood = isGood && isRight;
    std::fclose(child.Said);
  }
  isGood = isGood && seconds <= kPatience;
  std::cout << "a rank: " << fault.Name << ": others' time " << seconds
            << " s (limit = " << kPatience << ") " << (isGood ? "ok" : "FAILED") << std::endl;
  return isGood;
}

// Every other of the faults that are asked for, or all: a process of its own for each half, as most
// of their time is waiting.
bool TryHalf(const std::string& words, int half)
{
  bool isGood = true;
  int number = 0;
  for (const Fault& fault : GetFaults())
  {
    if (number++ % 2 == half && fault.Name.find(words) != std::string::npos)
    {
      isGood = Try(fault) && isGood;
    }
  }
  return isGood;
}
}

int TestWaterRankFaults(int argc, char* argv[])
{
  const std::string words = argc < 2 || argv[1][0] == '-' ? "" : argv[1];
  const pid_t other = fork();
  if (other == 0)
  {
    _exit(TryHalf(words, 1) ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  bool isGood = TryHalf(words, 0) && other > 0;
  int status = EXIT_FAILURE;
  isGood = waitpid(other, &status, 0) == other && status == 0 && isGood;
  return isGood ? EXIT_SUCCESS : EXIT_FAILURE;
}
