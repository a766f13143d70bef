#include "src/jobs/reference_image.h"

#include <fmt/core.h>

#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace isolume {
namespace {

constexpr std::size_t kColors = 4, kPlacement = 7;  // R G B A; normal, position, Z

/// Share of the light that a surface of albedo 1 sends back, per colour.
glm::dvec3 lightOf(Integrand integrand, const Channels& value) {
  switch (integrand) {
    case Integrand::ambient:
    case Integrand::translucent:
      return glm::dvec3(value[0]);
    case Integrand::shadow:
    case Integrand::light:
      return glm::dvec3(value[1]);
    case Integrand::bent:
      return glm::dvec3(value[3] / (std::numbers::pi / 2));
    default:
      return {value[0], value[1], value[2]};
  }
}

nlohmann::ordered_json referenceSettings(const ReferenceJob& job) {
  const IntegrandSettings defaults;
  const SamplingSettings sampling;
  nlohmann::ordered_json settings;
  settings["size"] = fmt::format("{}x{}", job.size.x, job.size.y);
  settings["integrand"] = integrandName(job.integrand);
  if (job.radius) {
    settings["radius"] = *job.radius;
    settings["membership"] = membershipName(job.membership.value_or(defaults.membership));
  }
  if (job.lightDirection)
    settings["light-direction"] =
        fmt::format("{},{},{}", job.lightDirection->x, job.lightDirection->y, job.lightDirection->z);
  if (job.lightRadius) settings["light-radius"] = *job.lightRadius;
  if (!job.environment.empty()) settings["environment"] = job.environment;
  if (job.integrand == Integrand::bounce) settings["bounces"] = job.bounces.value_or(kDefaultBounces);
  if (job.opacity) settings["opacity"] = *job.opacity;
  settings["normals"] = job.normals == ReferenceNormals::data ? "data" : "exact";
  if (!isExact(job.integrand)) {
    if (job.targetError) {
      settings["stderr"] = *job.targetError;
      settings["max-rays"] = job.maxRays.value_or(sampling.maxRays);
    } else {
      settings["rays"] = job.rays.value_or(sampling.rays);
    }
    settings["seed"] = job.seed.value_or(sampling.seed);
  }
  settings["albedo"] = job.albedo.text;
  settings["background"] = job.background.text;
  return settings;
}

}  // namespace

std::vector<std::string> referenceChannelNames(const ReferenceJob& job) {
  std::vector<std::string> names{"R", "G", "B", "A"};
  const std::vector<std::string> estimated = channelNames(job.integrand);
  names.insert(names.end(), estimated.begin(), estimated.end());
  for (const std::string& name : estimated) names.push_back("stderr." + name);
  names.insert(names.end(), {"normal.X", "normal.Y", "normal.Z", "position.X", "position.Y", "position.Z", "Z"});
  return names;
}

Image emptyReferenceImage(const ReferenceJob& job) {
  const std::size_t count = static_cast<std::size_t>(job.size.x) * job.size.y;
  const float alpha = job.transparent ? 0.0f : 1.0f;
  const auto background = [&](const std::string& name) {
    if (name == "A") return alpha;
    if (name == "R") return job.background.linear.r * alpha;
    if (name == "G") return job.background.linear.g * alpha;
    if (name == "B") return job.background.linear.b * alpha;
    if (name == "ambient.Y" || name == "translucent.Y") return 1.0f;
    if (name == "Z") return std::numeric_limits<float>::infinity();
    return name.starts_with("position.") ? std::numeric_limits<float>::quiet_NaN() : 0.0f;
  };
  Image image;
  image.size = job.size;
  for (const std::string& name : referenceChannelNames(job))
    image.channels.push_back({name, std::vector<float>(count, background(name))});
  return image;
}

void storePixels(Image& image, const ReferenceJob& job, const PixelRect& rect,
                 const std::vector<ReferencePixel>& pixels, const GridFrame& frame, const Camera& camera) {
  const glm::dvec3 forward = cameraAxes(camera).forward, albedo(job.albedo.linear);
  const std::size_t layers = channelNames(job.integrand).size(), placement = image.channels.size() - kPlacement;
  const int width = rect.end.x - rect.begin.x;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const ReferencePixel& pixel = pixels[i];
    if (!pixel.hit) continue;
    const std::size_t x = rect.begin.x + i % width, y = rect.begin.y + i / width;
    const auto store = [&image, at = y * image.size.x + x](std::size_t channel, double value) {
      image.channels[channel].values[at] = static_cast<float>(value);
    };
    const ChannelEstimate& estimate = pixel.estimate.channels;
    const glm::dvec3 color = albedo * lightOf(job.integrand, estimate.value);
    const glm::dvec3 normal = glm::normalize(frame.worldFromAxes * pixel.point.normal);
    const glm::dvec3 position(frame.worldFromGrid * glm::dvec4(pixel.point.hit.position, 1));
    for (int c = 0; c < 3; ++c) {
      store(c, color[c]);
      store(placement + c, normal[c]);
      store(placement + 3 + c, position[c]);
    }
    store(kColors - 1, 1);
    store(placement + kPlacement - 1, glm::dot(position - camera.eye, forward));
    for (std::size_t c = 0; c < layers; ++c) {
      store(kColors + c, estimate.value[c]);
      store(kColors + layers + c, estimate.standardError[c]);
    }
  }
}

Provenance referenceProvenance(const ReferenceJob& job, const Surface& surface, const Camera& camera,
                               const std::string& checksums, const std::string& environmentChecksum) {
  Provenance provenance = surfaceProvenance(job.run.command, job.surface.input, surface, checksums);
  const nlohmann::ordered_json settings = referenceSettings(job);
  const std::string cameraText = cameraOptions(camera);
  provenance.metadata.emplace_back("isolume:camera", cameraText);
  provenance.metadata.emplace_back("isolume:settings", optionText(settings));
  if (!environmentChecksum.empty()) provenance.metadata.emplace_back("isolume:environment_sha256", environmentChecksum);
  provenance.settings.update(settings);
  provenance.settings["camera"] = cameraText;
  return provenance;
}

}  // namespace isolume
