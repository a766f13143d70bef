#include "src/jobs/provenance.h"

#include <fmt/core.h>

#include <filesystem>

#include "src/io/checksum.h"
#include "src/jobs/render_job.h"
#include "src/version.h"

namespace isolume {
namespace {

std::string layerList(const Layers& layers) {
  std::string list;
  const auto add = [&list](bool wanted, const char* name) {
    if (wanted) list.append(list.empty() ? "" : ",").append(name);
  };
  add(layers.ambient, "ambient");
  add(layers.irradiance, "irradiance");
  add(layers.normal, "normal");
  add(layers.position, "position");
  add(layers.depth, "depth");
  add(layers.bent, "bent");
  add(layers.thickness, "thickness");
  add(layers.all, "all");
  return list;
}

nlohmann::ordered_json pictureSettings(const RenderJob& job, const OcclusionSetting& occlusion,
                                       const std::optional<ScreenOcclusion>& screen,
                                       const std::optional<SurfaceColoring>& coloring) {
  nlohmann::ordered_json settings;
  settings["size"] = fmt::format("{}x{}", job.size.x, job.size.y);
  settings["samples"] = job.samples;
  if (!screen || sweepsBent(job.screen)) settings.update(occlusionSettings(occlusion));
  if (screen) settings.update(screenSettings(*screen));
  settings.update(lightingSettings(job.light));
  settings["normals"] = job.normals == NormalSource::data ? "data" : "distance";
  settings["gamma"] = job.gamma;
  if (coloring)
    settings.update(colorSettings(job.color, *coloring));
  else
    settings["albedo"] = job.albedo.text;
  settings["background"] = job.background.text;
  if (job.layers.any()) settings["layers"] = layerList(job.layers);
  if (job.bitDepth) settings["bit-depth"] = *job.bitDepth;
  return settings;
}

std::string calibratedText(double error) { return fmt::format("{:.4f} on the reference scenes", error); }

}  // namespace

std::string optionText(const nlohmann::ordered_json& settings) {
  std::string text;
  const auto add = [&text](const std::string& key, const nlohmann::ordered_json& value) {
    text += fmt::format("{}--{} {}", text.empty() ? "" : " ", key,
                        value.is_string() ? value.get<std::string>() : value.dump());
  };
  for (const auto& [key, value] : settings.items()) {
    if (!value.is_array())
      add(key, value);
    else
      for (const auto& each : value) add(key, each);
  }
  return text;
}

std::string checksumText(const std::vector<std::string>& files) {
  std::string text;
  for (const std::string& file : files)
    text += fmt::format("{}{}  {}", text.empty() ? "" : "; ", sha256OfFile(file),
                        std::filesystem::path(file).filename().string());
  return text;
}

Provenance surfaceProvenance(const std::string& command, const std::string& input, const Surface& surface,
                             const std::string& checksums) {
  Provenance provenance;
  provenance.metadata = {
      {"Software", fmt::format("isolume {}", kVersion)},
      {"isolume:command", command},
      {"isolume:version", std::string(kVersion)},
      {"isolume:input", input},
      {"isolume:input_sha256", checksums},
      {"isolume:isovalue", fmt::format("{}", surface.isovalue)},
      {"isolume:inside", insideName(surface.inside)},
  };
  if (!surface.gridName.empty()) provenance.metadata.emplace_back("isolume:grid", surface.gridName);
  if (!surface.source.empty()) provenance.metadata.emplace_back("isolume:fields_source", surface.source);
  nlohmann::ordered_json& settings = provenance.settings;
  settings["isovalue"] = surface.isovalue;
  settings["isovalue_choice"] = surface.isovalueReason;
  settings["inside"] = insideName(surface.inside);
  if (!surface.gridName.empty()) settings["grid"] = surface.gridName;
  settings.update(surface.method);
  return provenance;
}

Provenance renderProvenance(const RenderJob& job, const OcclusionSetting& occlusion,
                            const std::optional<ScreenOcclusion>& screen,
                            const std::optional<SurfaceColoring>& coloring, const Surface& surface,
                            const Camera& camera, const Context& context, const std::string& checksums) {
  Provenance provenance = surfaceProvenance(job.run.command, job.surface.input, surface, checksums);
  nlohmann::ordered_json picture = pictureSettings(job, occlusion, screen, coloring);
  picture.update(surface.method);
  const std::string backend(context.backend());
  const std::string cameraText = cameraOptions(camera);
  provenance.metadata.insert(provenance.metadata.end(), {{"isolume:camera", cameraText},
                                                         {"isolume:settings", optionText(picture)},
                                                         {"isolume:backend", backend},
                                                         {"isolume:gl", context.description()}});
  if (occlusion.error) provenance.metadata.emplace_back("isolume:openness_rmse", calibratedText(*occlusion.error));
  provenance.settings.update(picture);
  if (occlusion.error) provenance.settings["calibrated_error"] = *occlusion.error;
  provenance.settings["camera"] = cameraText;
  provenance.settings["backend"] = backend;
  provenance.settings["gl"] = context.description();
  return provenance;
}

}  // namespace isolume
