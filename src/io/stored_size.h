// How many bytes a file must have for its header's claims. ITK's readers of these formats return without an error, and
// with arbitrary samples, where a file ends too soon.
#pragma once

#include <cstdint>
#include <string>

namespace isolume {

/// InputError unless the file (or the .img beside a NIfTI .hdr) is long enough, once unpacked, for its samples.
void requireWholeNifti(const std::string& path);
void requireWholeMrc(const std::string& path);
/// Legacy VTK images whose samples are text are refused too: what is missing in them cannot be told.
void requireWholeVtk(const std::string& path, std::uint64_t sampleBytes);
/// Every directory of a TIFF (or BigTIFF) lies in the file: ITK takes the pages before a missing one for the whole
/// stack.
void requireWholeTiff(const std::string& path);
/// Any uncompressed or gzip-compressed file with `headerBytes` before so many bytes of samples.
void requireContent(const std::string& path, std::uint64_t headerBytes, std::uint64_t sampleBytes);

}  // namespace isolume
