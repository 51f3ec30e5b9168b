// SPDX-License-Identifier: BSD-3-Clause
// WaterSocketRanks.h: processes that talk over sockets, as the ranks of a parallel program do: no
// MPI is needed. They count what they send, and keep the time that it would take on a network.
#ifndef WaterSocketRanks_h
#define WaterSocketRanks_h

#include "vtkAbstractArray.h"
#include "vtkCommunicator.h"
#include "vtkDummyController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <sys/socket.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

// Sends and receives by sockets; VTK's own collectives stand on that.
class WaterSocketCommunicator : public vtkCommunicator
{
public:
  static WaterSocketCommunicator* New();
  vtkTypeMacro(WaterSocketCommunicator, vtkCommunicator);

  std::int64_t BytesSent = 0; // of contents
  std::int64_t MessagesSent = 0;
  // A simulated network: each message says when it is there, so that the time that a rank has
  // waited for is known, however busy this machine is. Sender and receiver are each busy with the
  // bytes.
  double Latency = 0.0; // s
  double SecondsPerByte = 0.0;
  double Clock = 0.0; // s, of this rank
  // Added to the first of the numbers that are sent, as from another version; 0: nothing.
  double Version = 0.0;
  // How many messages this process sends before it ends, as if killed; -1: it does not end.
  std::int64_t MessagesLeft = -1;

  void Begin(int rank, const std::vector<int>& sockets)
  {
    this->LocalProcessId = rank;
    this->MaximumNumberOfProcesses = static_cast<int>(sockets.size());
    this->SetNumberOfProcesses(static_cast<int>(sockets.size()));
    this->Others = sockets;
  }

  int SendVoidArray(const void* data, vtkIdType length, int type, int remote, int) override
  {
    if (this->MessagesLeft == 0)
    {
      _exit(EXIT_FAILURE);
    }
    this->MessagesLeft -= this->MessagesLeft > 0 ? 1 : 0;
    std::vector<double> numbers;
    if (this->Version != 0.0 && type == VTK_DOUBLE && length > 0)
    {
      const auto* sent = static_cast<const double*>(data);
      numbers.assign(sent, sent + length);
      numbers[0] += this->Version;
      data = numbers.data();
    }
    const std::int64_t count = length;
    const size_t size = SizeOf(length, type);
    ++this->MessagesSent;
    this->BytesSent += static_cast<std::int64_t>(size);
    this->Clock += this->SecondsPerByte * static_cast<double>(size);
    const double arrival = this->Clock + this->Latency;
    return this->Write(remote, &count, sizeof count) &&
      this->Write(remote, &arrival, sizeof arrival) && this->Write(remote, data, size);
  }

  int ReceiveVoidArray(void* data, vtkIdType most, int type, int remote, int) override
  {
    std::int64_t count = 0;
    double arrival = 0.0;
    const bool isRead = this->Read(remote, &count, sizeof count) && count <= most &&
      this->Read(remote, &arrival, sizeof arrival) && this->Read(remote, data, SizeOf(count, type));
    this->Count = isRead ? count : 0;
    for (size_t i = 0; !isRead && i < SizeOf(most, type); ++i)
    {
      // nothing is promised here: small numbers, and such as would be a rectangle without end
      static_cast<unsigned char*>(data)[i] = i / 8 % 2 == 0 ? 0 : 0x81;
    }
    const double busy = this->SecondsPerByte * static_cast<double>(SizeOf(this->Count, type));
    this->Clock = std::max(this->Clock + busy, arrival);
    return isRead;
  }

  // By a binomial tree, as MPI does; VTK's own has the root send to each.
  int BroadcastVoidArray(void* data, vtkIdType length, int type, int root) override
  {
    const int count = this->GetNumberOfProcesses();
    const int place = (this->GetLocalProcessId() - root + count) % count;
    int step = 1;
    for (; step < count && place % (2 * step) == 0; step *= 2)
    {
    }
    bool isGood = true;
    if (place != 0)
    {
      const int from = (place - step + root) % count;
      isGood = this->ReceiveVoidArray(data, length, type, from, 0) && this->Count == length;
    }
    for (step /= 2; step > 0; step /= 2)
    {
      if (place + step < count)
      {
        isGood =
          isGood && this->SendVoidArray(data, length, type, (place + step + root) % count, 0);
      }
    }
    return isGood;
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
      // an error, and no signal, when the other has ended
      const ssize_t done =
        send(this->Others[static_cast<size_t>(remote)], next, size, MSG_NOSIGNAL);
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
inline vtkStandardNewMacro(WaterSocketCommunicator);

using WaterSockets = std::vector<std::vector<int>>; // from a rank to another

// Empty: the system has none.
inline WaterSockets WaterConnect(size_t ranks)
{
  WaterSockets sockets(ranks, std::vector<int>(ranks, -1));
  for (size_t i = 0; i < ranks; ++i)
  {
    for (size_t j = i + 1; j < ranks; ++j)
    {
      int pair[2];
      if (socketpair(AF_UNIX, SOCK_STREAM, 0, pair) != 0)
      {
        return WaterSockets();
      }
      sockets[i][j] = pair[0];
      sockets[j][i] = pair[1];
    }
  }
  return sockets;
}

// Closes what the others use: a rank that ends is then noticed.
inline void WaterKeepOwn(const WaterSockets& sockets, int rank)
{
  for (size_t i = 0; i < sockets.size(); ++i)
  {
    for (const int socket : sockets[i])
    {
      if (static_cast<int>(i) != rank && socket >= 0)
      {
        close(socket);
      }
    }
  }
}

// What a process that has begun is: a controller of it.
struct WaterSocketRank
{
  WaterSocketRank(const WaterSockets& sockets, int rank)
    : Rank(rank)
    , Ranks(static_cast<int>(sockets.size()))
  {
    WaterKeepOwn(sockets, rank);
    this->Communicator->Begin(rank, sockets[static_cast<size_t>(rank)]);
    this->Controller->SetCommunicator(this->Communicator);
    this->Controller->SetRMICommunicator(this->Communicator);
  }

  const int Rank;
  const int Ranks;
  vtkNew<WaterSocketCommunicator> Communicator;
  vtkNew<vtkDummyController> Controller;
};

// Runs a function of a WaterSocketRank in a process for each rank. Are all of its results true?
//
// patience  s, until a process that waits for another is ended
template <typename Function>
bool WaterRunRanks(int ranks, unsigned int patience, Function run)
{
  const WaterSockets sockets = WaterConnect(static_cast<size_t>(ranks));
  bool isGood = !sockets.empty();
  std::vector<pid_t> children;
  for (int rank = 0; isGood && rank < ranks; ++rank)
  {
    std::cout.flush(); // or a child says it, too
    const pid_t pid = fork();
    if (pid == 0)
    {
      alarm(patience);
      const WaterSocketRank self(sockets, rank);
      const bool isRight = run(self);
      alarm(0);
      _exit(isRight ? EXIT_SUCCESS : EXIT_FAILURE);
    }
    isGood = pid > 0;
    children.push_back(pid);
  }
  WaterKeepOwn(sockets, -1);
  for (const pid_t pid : children)
  {
    int status = EXIT_FAILURE;
    isGood = waitpid(pid, &status, 0) == pid && status == 0 && isGood;
  }
  return isGood;
}

#endif
