// The one place that starts threads: a parallel loop over an index range, and the limit on threads.
// Every body must give the same result in any order; reductions are done over fixed chunks, in order.
#pragma once

#include <cstddef>
#include <functional>

namespace isolume {

/// Calls body(i) once for each i in [0, count), on up to the permitted number of threads.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body);

/// Limits all later loops of this process to that many threads; 0 means all cores.
void setThreadCount(int count);
int threadCount();

}  // namespace isolume
