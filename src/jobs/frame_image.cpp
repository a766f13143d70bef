#include "src/jobs/frame_image.h"

#include <cmath>
#include <string>
#include <utility>

#include "sweep/parallel.h"

namespace isolume {
namespace {

/// Component `i` of each vector.
template <class Vector>
ImageChannel channelOf(std::string name, const std::vector<Vector>& pixels, int i) {
  ImageChannel channel{std::move(name), {}};
  channel.values.reserve(pixels.size());
  for (const Vector& pixel : pixels) channel.values.push_back(pixel[i]);
  return channel;
}

void addVector(Image& image, const std::string& layer, const std::vector<glm::vec3>& pixels) {
  const char* const kAxes[] = {".X", ".Y", ".Z"};
  for (int i = 0; i < 3; ++i) image.channels.push_back(channelOf(layer + kAxes[i], pixels, i));
}

float fieldAt(const SurfaceField& field, glm::vec3 index) {
  return static_cast<float>(surfaceValueAt(field, glm::dvec3(index)));
}

bool isHit(const Frame& frame, std::size_t i) { return std::isfinite(frame.depth[i]); }

void addBent(Image& image, const Frame& frame, const std::array<SurfaceField, 3>& bent) {
  const std::size_t first = image.channels.size(), count = frame.depth.size();
  for (const char* name : {"bent.X", "bent.Y", "bent.Z", "cone.Y"})
    image.channels.push_back({name, std::vector<float>(count, 0)});
  parallelFor(static_cast<std::size_t>(frame.size.y), [&](std::size_t row) {
    const auto width = static_cast<std::size_t>(frame.size.x);
    for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
      if (!isHit(frame, i)) continue;
      glm::vec3 mean;
      for (int c = 0; c < 3; ++c) mean[c] = bentComponent(fieldAt(bent[static_cast<std::size_t>(c)], frame.index[i]));
      const BentNormal normal = bentNormal(mean);
      for (int c = 0; c < 3; ++c) image.channels[first + static_cast<std::size_t>(c)].values[i] = normal.direction[c];
      image.channels[first + 3].values[i] = normal.cone;
    }
  });
}

void addThickness(Image& image, const Frame& frame, const SweptLight& thickness) {
  std::vector<float> values(frame.depth.size(), 0);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (isHit(frame, i)) values[i] = thickness.valueOf(fieldAt(thickness.values, frame.index[i]));
  image.channels.push_back({"thickness.Y", std::move(values)});
}

}  // namespace

Image imageOf(const Frame& frame, const RenderJob& job, const SweptLighting& lighting) {
  Image image;
  image.size = frame.size;
  const bool png = job.output.ends_with(".png");
  const char* const kColors[] = {"R", "G", "B", "A"};
  const int colors = png && !job.transparent ? 3 : 4;
  for (int i = 0; i < colors; ++i) image.channels.push_back(channelOf(kColors[i], frame.color, i));
  const Layers& layers = job.layers;
  const bool lit = job.occlusion.method != OcclusionMethod::none, plain = isPlain(job.light);
  if (lit && plain && (layers.ambient || layers.all)) image.channels.push_back(channelOf("ambient.Y", frame.light, 0));
  if (lit && (layers.irradiance || (layers.all && !plain))) {
    const char* const kChannels[] = {"irradiance.R", "irradiance.G", "irradiance.B"};
    for (int i = 0; i < 3; ++i) image.channels.push_back(channelOf(kChannels[i], frame.light, i));
  }
  if (layers.normal || layers.all) addVector(image, "normal", frame.normal);
  if (lighting.bent) addBent(image, frame, *lighting.bent);
  if (layers.thickness && lighting.thickness) addThickness(image, frame, *lighting.thickness);
  if (layers.position || layers.all) addVector(image, "position", frame.position);
  if (layers.depth || layers.all) image.channels.push_back({"Z", frame.depth});
  return image;
}

std::size_t frameBytes(const Frame& frame) {
  return frame.color.size() * sizeof(glm::vec4) + frame.depth.size() * sizeof(float) +
         (frame.light.size() + frame.normal.size() + frame.position.size() + frame.index.size()) * sizeof(glm::vec3);
}

}  // namespace isolume
