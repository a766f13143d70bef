// How much memory this process may still take, so that a volume that cannot fit is refused before anything is read.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

namespace isolume {

/// Bytes available without swapping: the smaller of the system's MemAvailable and what the control groups of this
/// process leave. The largest value if the system tells neither.
std::uint64_t availableMemory();

/// "1.5 GiB": a size to be read by people.
std::string formatBytes(std::uint64_t bytes);

/// InputError naming both sizes unless size.x * size.y * size.z * bytesPerSample bytes are available. 64-bit sizes:
/// what a damaged header claims need not fit into an index.
void requireMemory(const std::string& path, glm::i64vec3 size, std::uint64_t bytesPerSample);

}  // namespace isolume
