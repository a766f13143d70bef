// The one symbol that isolume_image_codec.so exports.
#pragma once

#include "image_codec.h"

extern "C" const isolume::ImageCodec* isolumeImageCodec();
