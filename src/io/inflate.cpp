#include "inflate.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <functional>

#include "errors.h"
#include "input_file.h"

namespace isolume {
namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 18;

InputError damaged(const std::string& path, std::uint64_t found) {
  return InputError(fmt::format(
      "{}: expected a whole compressed stream, found it cut short or damaged after {} bytes of content", path, found));
}

/// Unpacks to the end of the file, piece by piece. gzip allows several streams in a row.
void inflateAll(const InputFile& file, std::uint64_t offset,
                const std::function<void(const std::byte*, std::size_t)>& take) {
  struct Stream : z_stream {
    Stream() : z_stream{} {
      constexpr int kDetectZlibOrGzip = MAX_WBITS + 32;  // as zlib.h documents it
      if (inflateInit2(this, kDetectZlibOrGzip) != Z_OK) throw InputError("zlib: out of memory");
    }
    ~Stream() { inflateEnd(this); }
  } stream;
  std::vector<std::byte> packed(kBuffer), unpacked(kBuffer);
  std::uint64_t total = 0;
  int state = Z_OK;
  while (offset < file.size()) {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(kBuffer, file.size() - offset));
    file.readAt(offset, packed.data(), count);
    offset += count;
    stream.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(count);
    do {
      if (state == Z_STREAM_END) {
        // Zeros after the end are padding, as gzip itself takes them; anything else begins another stream.
        while (stream.avail_in > 0 && *stream.next_in == 0) ++stream.next_in, --stream.avail_in;
        if (stream.avail_in == 0) break;
        inflateReset(&stream);
      }
      stream.next_out = reinterpret_cast<Bytef*>(unpacked.data());
      stream.avail_out = static_cast<uInt>(kBuffer);
      state = inflate(&stream, Z_NO_FLUSH);
      const std::size_t made = kBuffer - stream.avail_out;
      total += made;
      take(unpacked.data(), made);
      if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR) throw damaged(file.path(), total);
    } while (stream.avail_in > 0 || stream.avail_out == 0);
  }
  if (state != Z_STREAM_END) throw damaged(file.path(), total);
}

}  // namespace

std::vector<std::byte> inflateFile(const std::string& path, std::uint64_t offset, std::uint64_t expected) {
  std::vector<std::byte> content;
  content.reserve(static_cast<std::size_t>(expected));
  std::uint64_t found = 0;
  inflateAll(InputFile(path), offset, [&](const std::byte* bytes, std::size_t count) {
    found += count;
    if (found <= expected) content.insert(content.end(), bytes, bytes + count);
  });
  if (found != expected)
    throw InputError(fmt::format("{}: expected {} bytes once unpacked, found {}", path, expected, found));
  return content;
}

std::uint64_t contentSize(const std::string& path) {
  const InputFile file(path);
  if (!file.head(2).starts_with("\x1f\x8b")) return file.size();
  std::uint64_t size = 0;
  inflateAll(file, 0, [&](const std::byte*, std::size_t count) { size += count; });
  return size;
}

}  // namespace isolume
