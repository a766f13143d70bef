// Every SIMD target that this machine can run, one after the other.
#pragma once

#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <cstdint>

namespace isolume::test {

/// Calls body() once per target, with dispatch limited to it; failures name the target. Returns how many there were.
template <class Body>
int onEverySimdTarget(const Body& body) {
  int tried = 0;
  for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
    const std::int64_t target = targets & -targets;
    if ((target & HWY_ATTAINABLE_TARGETS) == 0) continue;
    hwy::SetSupportedTargetsForTest(target);
    SCOPED_TRACE(hwy::TargetName(static_cast<std::uint32_t>(target)));
    body();
    ++tried;
    hwy::SetSupportedTargetsForTest(0);
  }
  return tried;
}

}  // namespace isolume::test
