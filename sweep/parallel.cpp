#include "parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <memory>

#ifdef __SANITIZE_THREAD__
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#endif

namespace isolume {
namespace {

std::unique_ptr<tbb::global_control>& limit() {
  static std::unique_ptr<tbb::global_control> control;
  return control;
}

}  // namespace

#ifdef __SANITIZE_THREAD__
// The sanitizer does not see how a oneTBB that was built without it hands work from thread to thread, and finds races
// everywhere: for it, threads that it knows.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr thrown;
  std::mutex guard;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) body(i);
    } catch (...) {
      const std::scoped_lock lock(guard);
      if (!thrown) thrown = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> others(std::min<std::size_t>(static_cast<std::size_t>(threadCount()), count) - (count > 0));
  for (std::thread& each : others) each = std::thread(work);
  work();
  for (std::thread& each : others) each.join();
  if (thrown) std::rethrow_exception(thrown);
}
#else
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&body](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
      },
      tbb::simple_partitioner());
}
#endif

void setThreadCount(int count) {
  limit().reset();
  if (count > 0) {
    limit() = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<std::size_t>(count));
  }
}

int threadCount() {
  const auto permitted = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return static_cast<int>(permitted);
}

}  // namespace isolume
