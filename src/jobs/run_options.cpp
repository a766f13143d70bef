#include "src/jobs/run_options.h"

#include <cstdlib>

#include "sweep/parallel.h"

namespace isolume {

void limitThreads(int threads) {
  if (threads <= 0) return;
  setThreadCount(threads);
  const std::string count = std::to_string(threads);
  for (const char* variable : {"LP_NUM_THREADS", "OPENIMAGEIO_THREADS", "ITK_GLOBAL_DEFAULT_NUMBER_OF_THREADS"})
    setenv(variable, count.c_str(), 1);
}

}  // namespace isolume
