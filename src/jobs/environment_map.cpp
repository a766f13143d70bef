#include "src/jobs/environment_map.h"

#include <fmt/core.h>

#include <cmath>

#include "src/errors.h"
#include "src/io/image.h"
#include "src/io/image_codec.h"

namespace isolume {

EnvironmentMap readEnvironmentMap(const std::string& path) {
  const Image image = readImage(path);
  const auto channel = [&](const char* name) -> const std::vector<float>& {
    for (const ImageChannel& each : image.channels)
      if (each.name == name) return each.values;
    throw InputError(fmt::format("{}: expected the channels R, G and B, found no {}", path, name));
  };
  const std::vector<float>&r = channel("R"), &g = channel("G"), &b = channel("B");
  EnvironmentMap map{image.size, std::vector<glm::vec3>(r.size())};
  for (std::size_t i = 0; i < map.radiance.size(); ++i) {
    map.radiance[i] = {r[i], g[i], b[i]};
    for (int c = 0; c < 3; ++c)
      if (!std::isfinite(map.radiance[i][c]) || map.radiance[i][c] < 0)
        throw InputError(fmt::format("{}: pixel {},{}: expected radiance of 0 or more, found {}", path,
                                     i % image.size.x, i / image.size.x, map.radiance[i][c]));
  }
  return map;
}

}  // namespace isolume
