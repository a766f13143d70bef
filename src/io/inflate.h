// zlib and gzip streams, read to the end and checked: a stream that is cut short or damaged is an error, where some
// readers return whatever they got.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace isolume {

/// The content of a zlib or gzip stream that begins at `offset` of the file: exactly `expected` bytes, or InputError.
std::vector<std::byte> inflateFile(const std::string& path, std::uint64_t offset, std::uint64_t expected);

/// Bytes of a file's content: of what it unpacks to if it is gzip-compressed, else its size. InputError if the
/// compressed stream is cut short or damaged. As slow as unpacking.
std::uint64_t contentSize(const std::string& path);

}  // namespace isolume
