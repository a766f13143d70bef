// `isolume reference`: the picture that others are measured with, by Monte Carlo on the CPU (sweep/reference).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "src/io/srgb.h"
#include "src/jobs/camera_choice.h"
#include "src/jobs/color.h"
#include "src/jobs/run_options.h"
#include "src/jobs/surface.h"
#include "sweep/reference/reference.h"

namespace isolume {

inline constexpr int kDefaultBounces = 3;

struct ReferenceJob {
  SurfaceRequest surface;
  std::string output;  ///< .exr
  CameraRequest camera;
  glm::ivec2 size{1024, 1024};
  Color albedo{"#cccccc", glm::vec3(linearFromSrgb(0.8F))};  ///< that of `isolume render`
  Color background{"white", glm::vec3(1)};
  bool transparent = false;

  Integrand integrand = Integrand::ambient;
  ReferenceNormals normals = ReferenceNormals::data;
  std::optional<double> radius;  ///< world units
  std::optional<Membership> membership;
  std::optional<glm::dvec3> lightDirection;  ///< world, towards the light
  std::optional<double> lightRadius;         ///< degrees
  std::string environment;                   ///< picture of the sky, or ""
  std::optional<int> bounces;
  std::optional<double> opacity;

  std::optional<int> rays, maxRays;
  std::optional<double> targetError;
  std::optional<std::uint64_t> seed;
  RunOptions run;
};

/// UsageError for options that the integrand does not read, that exclude each other, or that it cannot do without.
void checkReference(const ReferenceJob& job);

const char* integrandName(Integrand integrand);
const char* membershipName(Membership membership);

/// Stages: read, environment (if there is one), cells (what the tracer skips by), trace, write. Nothing is written
/// unless all went well. Pixels that do not reach --stderr are counted in a warning. Throws the errors of src/errors.h.
void runReferenceJob(const ReferenceJob& job);

}  // namespace isolume
