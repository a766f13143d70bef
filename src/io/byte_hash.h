// A 64-bit hash that notices damage to a file; not cryptographic. Threaded over fixed chunks: the same for any number
// of threads. About as fast as memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

namespace isolume {

std::uint64_t hashBytes(std::string_view bytes);

/// The same for bytes that are fetched: `fetch(first, count, to)` fills `to`, from several threads at once.
std::uint64_t hashBytes(std::uint64_t size,
                        const std::function<void(std::uint64_t first, std::size_t count, char* to)>& fetch);

}  // namespace isolume
