#include "src/jobs/frame_image.h"

#include <string>
#include <utility>

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

}  // namespace

Image imageOf(const Frame& frame, const RenderJob& job) {
  Image image;
  image.size = frame.size;
  const bool png = job.output.ends_with(".png");
  const char* const kColors[] = {"R", "G", "B", "A"};
  const int colors = png && !job.transparent ? 3 : 4;
  for (int i = 0; i < colors; ++i) image.channels.push_back(channelOf(kColors[i], frame.color, i));
  const Layers& layers = job.layers;
  const bool hasAmbient = job.occlusion.method != OcclusionMethod::none;
  if (hasAmbient && (layers.ambient || layers.all)) image.channels.push_back(channelOf("ambient.Y", frame.light, 0));
  if (layers.normal || layers.all) addVector(image, "normal", frame.normal);
  if (layers.position || layers.all) addVector(image, "position", frame.position);
  if (layers.depth || layers.all) image.channels.push_back({"Z", frame.depth});
  return image;
}

std::size_t frameBytes(const Frame& frame) {
  return frame.color.size() * sizeof(glm::vec4) + frame.depth.size() * sizeof(float) +
         (frame.light.size() + frame.normal.size() + frame.position.size()) * sizeof(glm::vec3);
}

}  // namespace isolume
