// SPDX-License-Identifier: BSD-3-Clause
// A scene that is split over processes and composited by VTK's own sort-last renderer shows the
// picture of one process. The processes are forked and talk over sockets: no MPI is needed.
#include "WaterTestScene.h"

#include "vtkAbstractArray.h"
#include "vtkCommunicator.h"
#include "vtkCompositedSynchronizedRenderers.h"
#include "vtkDummyController.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWaterReflectionPass.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace
{
constexpr int kRanks = 3;
constexpr unsigned int kPatience = 100; // s, until a process that waits for another is ended
constexpr double kShare = 0.0002;       // of the pixels, that may be off by more than 1 of 255

using Sockets = std::vector<std::vector<int>>; // from a rank to another

// Sends and receives by sockets; VTK's own collectives stand on that.
class SocketCommunicator : public vtkCommunicator
{
public:
  static SocketCommunicator* New();
  vtkTypeMacro(SocketCommunicator, vtkCommunicator);

  void Begin(int rank, const std::vector<int>& sockets)
  {
    this->LocalProcessId = rank;
    this->MaximumNumberOfProcesses = static_cast<int>(sockets.size());
    this->SetNumberOfProcesses(static_cast<int>(sockets.size()));
    this->Others = sockets;
  }

  int SendVoidArray(const void* data, vtkIdType length, int type, int remote, int) override
  {
    const std::int64_t count = length;
    return this->Write(remote, &count, sizeof count) &&
      this->Write(remote, data, SizeOf(length, type));
  }

  int ReceiveVoidArray(void* data, vtkIdType most, int type, int remote, int) override
  {
    std::int64_t count = 0;
    const bool isRead = this->Read(remote, &count, sizeof count) && count <= most &&
      this->Read(remote, data, SizeOf(count, type));
    this->Count = isRead ? count : 0;
    return isRead;
  }

private:
  static size_t SizeOf(vtkIdType length, int type)
  {
    return static_cast<size_t>(length) *
      static_cast<size_t>(vtkAbstractArray::GetDataTypeSize(type));
  }

  bool Write(int remote, const void* data, size_t size)
  {
    const char* next = static_cast<const char*>(data);
    while (size > 0)
    {
      const ssize_t done = write(this->Others[static_cast<size_t>(remote)], next, size);
      if (done <= 0)
      {
        return false;
      }
      next += done;
      size -= static_cast<size_t>(done);
    }
    return true;
  }

  bool Read(int remote, void* data, size_t size)
  {
    char* next = static_cast<char*>(data);
    while (size > 0)
    {
      const ssize_t done = read(this->Others[static_cast<size_t>(remote)], next, size);
      if (done <= 0)
      {
        return false;
      }
      next += done;
      size -= static_cast<size_t>(done);
    }
    return true;
  }

  std::vector<int> Others;
};
vtkStandardNewMacro(SocketCommunicator);

Sockets Connect()
{
  Sockets sockets(kRanks, std::vector<int>(kRanks, -1));
  for (size_t i = 0; i < kRanks; ++i)
  {
    for (size_t j = i + 1; j < kRanks; ++j)
    {
      int pair[2];
      if (socketpair(AF_UNIX, SOCK_STREAM, 0, pair) != 0)
      {
        return Sockets();
      }
      sockets[i][j] = pair[0];
      sockets[j][i] = pair[1];
    }
  }
  return sockets;
}

std::vector<unsigned char> Show(WaterTestScene& scene)
{
  scene.Window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  const int* size = scene.Window->GetSize();
  scene.Window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  return std::vector<unsigned char>(
    pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
}

double ShareOff(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  size_t count = 0;
  for (size_t i = 0; i < a.size(); i += 4)
  {
    const auto isOff = [&](size_t k) { return std::abs(a[i + k] - b[i + k]) > 1; };
    count += isOff(0) || isOff(1) || isOff(2);
  }
  return 4.0 * static_cast<double>(count) / static_cast<double>(a.size());
}

void Fill(WaterTestScene& scene, bool isWet, bool isClear)
{
  scene.AddThings<vtkPolyDataMapper>();
  scene.AddWater();
  scene.Water->SetVisibility(isWet);
  scene.Water->GetWaterProperty()->SetRefraction(isClear);
}

// Leaves a rank its own things.
void KeepPart(WaterTestScene& scene, int rank)
{
  std::vector<vtkProp*> others;
  vtkPropCollection* props = scene.Renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    auto* prop = vtkProp::SafeDownCast(props->GetItemAsObject(i));
    if (prop != scene.Water.Get() && i % kRanks != rank)
    {
      others.push_back(prop);
    }
  }
  for (vtkProp* prop : others)
  {
    scene.Renderer->RemoveViewProp(prop);
  }
}

// What one rank renders; on the root its share of pixels off, elsewhere 0.
double Compare(vtkMultiProcessController* controller, bool isWet, bool isClear)
{
  WaterTestScene scene;
  Fill(scene, isWet, isClear);
  KeepPart(scene, controller->GetLocalProcessId());
  scene.Water->GetReflectionPass()->SetController(controller);
  vtkNew<vtkCompositedSynchronizedRenderers> together;
  together->SetRenderer(scene.Renderer);
  together->SetParallelController(controller);
  together->SetRootProcessId(0);
  const std::vector<unsigned char> picture = Show(scene);
  if (controller->GetLocalProcessId() != 0)
  {
    return 0.0;
  }
  WaterTestScene serial;
  Fill(serial, isWet, isClear);
  return ShareOff(picture, Show(serial));
}

bool Run(int rank, const Sockets& sockets)
{
  alarm(kPatience);
  vtkNew<SocketCommunicator> communicator;
  communicator->Begin(rank, sockets[static_cast<size_t>(rank)]);
  vtkNew<vtkDummyController> dummy;
  dummy->SetCommunicator(communicator);
  dummy->SetRMICommunicator(communicator);
  const double floor = Compare(dummy, false, false);
  const double opaque = Compare(dummy, true, false);
  const double clear = Compare(dummy, true, true);
  if (rank == 0)
  {
    std::cout << "share of pixels off without water: " << floor << ", opaque: " << opaque
              << ", clear: " << clear << " (limit " << kShare << " more)" << std::endl;
  }
  return opaque <= floor + kShare && clear <= floor + kShare;
}
}

int TestWaterSortLast(int, char*[])
{
  const Sockets sockets = Connect(); // and processes, before anything is rendered
  bool isGood = !sockets.empty();
  std::vector<pid_t> others;
  for (int rank = 1; isGood && rank < kRanks; ++rank)
  {
    const pid_t pid = fork();
    if (pid == 0)
    {
      _exit(Run(rank, sockets) ? EXIT_SUCCESS : EXIT_FAILURE);
    }
    isGood = pid > 0;
    others.push_back(pid);
  }
  isGood = isGood && Run(0, sockets);
  for (const pid_t pid : others)
  {
    int status = EXIT_FAILURE;
    isGood = waitpid(pid, &status, 0) == pid && status == 0 && isGood;
  }
  return isGood ? EXIT_SUCCESS : EXIT_FAILURE;
}
