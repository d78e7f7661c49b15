// Deals out pieces of work by MPI. The first rank's main thread answers requests, which it polls every
// millisecond, while another thread of it works; that one calls MPI only to abort.

#include "extras/sweep/mpi/deal.h"

#include <mpi.h>

#include <chrono>
#include <mutex>
#include <thread>

namespace {

constexpr int asks = 1, gets = 2;
constexpr long nothing_left = -1;

struct Deal {
  long (*next)(void*);
  int (*work)(void*, long);
  void* it;
  std::mutex mutex = {};

  long piece() {
    const std::lock_guard lock(mutex);
    return next(it);
  }
  void do_it(long piece) const {
    if (const int failed = work(it, piece)) MPI_Abort(MPI_COMM_WORLD, failed);
  }
};

void serve(Deal& deal, int others) {
  std::jthread worker([&] {
    for (long piece = deal.piece(); piece != nothing_left; piece = deal.piece()) deal.do_it(piece);
  });
  while (others > 0) {
    int there = 0;
    MPI_Status who;
    MPI_Iprobe(MPI_ANY_SOURCE, asks, MPI_COMM_WORLD, &there, &who);
    if (!there) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      continue;
    }
    MPI_Recv(nullptr, 0, MPI_BYTE, who.MPI_SOURCE, asks, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    const long piece = deal.piece();
    if (piece == nothing_left) --others;
    MPI_Send(&piece, 1, MPI_LONG, who.MPI_SOURCE, gets, MPI_COMM_WORLD);
  }
}

void ask_and_work(Deal& deal) {
  for (;;) {
    long piece = nothing_left;
    MPI_Send(nullptr, 0, MPI_BYTE, 0, asks, MPI_COMM_WORLD);
    MPI_Recv(&piece, 1, MPI_LONG, 0, gets, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (piece == nothing_left) return;
    deal.do_it(piece);
  }
}

}  // namespace

int oddity_deal(long (*next)(void*), int (*work)(void*, long), void* it) {
  int granted = 0, rank = 0, size = 1;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &granted);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  Deal deal{next, work, it};
  if (rank == 0)
    serve(deal, size - 1);
  else
    ask_and_work(deal);
  MPI_Finalize();
  return rank;
}
