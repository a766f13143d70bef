// How an output was made: the same facts for an image's metadata, a fields file and the report. No date and no host
// name, so that the same command gives the same bytes.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "raymarch/camera.h"
#include "raymarch/context.h"
#include "src/jobs/surface.h"

namespace isolume {

struct OcclusionSetting;
struct ScreenOcclusion;
struct RenderJob;
struct SurfaceColoring;

struct Provenance {
  /// Image metadata. isolume:camera and isolume:settings are options of `isolume render`: with the input, the isovalue
  /// and the side they draw the same picture again, bit for bit.
  std::vector<std::pair<std::string, std::string>> metadata;
  nlohmann::ordered_json settings;  ///< every setting, defaults resolved
};

/// `HASH  FILE` (SHA-256) for every file, joined by "; ". Thread-safe.
std::string checksumText(const std::vector<std::string>& files);

/// Settings as options of the command line: `--size 64x64 --gamma 2`; an array as an option given again and again.
std::string optionText(const nlohmann::ordered_json& settings);

/// What holds for the surface alone: command, version, input, checksum, isovalue, side.
Provenance surfaceProvenance(const std::string& command, const std::string& input, const Surface& surface,
                             const std::string& checksums);

/// `screen`, where there is one, stands in place of `occlusion`, and `coloring` in place of the albedo.
Provenance renderProvenance(const RenderJob& job, const OcclusionSetting& occlusion,
                            const std::optional<ScreenOcclusion>& screen,
                            const std::optional<SurfaceColoring>& coloring, const Surface& surface,
                            const Camera& camera, const Context& context, const std::string& checksums);

}  // namespace isolume
