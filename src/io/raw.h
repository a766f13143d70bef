// Raw volumes: samples and nothing else. What they are comes from RawLayout, then from the file's name:
// `skull_256x256x108_int16.raw`, `skull_256x256x108_int16_be.raw` (big-endian). x varies fastest. Little-endian, offset
// 0, spacing 1 and origin 0 where nobody says otherwise; dimensions and type must be said.
#pragma once

#include <string>

#include "volume.h"

namespace isolume {

/// Whether the name says dimensions and type.
bool isRawName(const std::string& path);

/// InputError if dimensions or type are missing, contradict themselves or do not fit the file's size to the byte.
Volume readRaw(const std::string& path, const RawLayout& layout);

}  // namespace isolume
