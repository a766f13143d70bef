// Sphere-traces an isosurface in one GLSL pass and shades it with swept occlusion.
#pragma once

#include <array>
#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/mat4x4.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "camera.h"
#include "color_field.h"
#include "context.h"
#include "light_field.h"
#include "screen/screen_occlusion.h"
#include "sweep/grid.h"
#include "sweep/octants.h"
#include "sweep/octants/geometry_terms.h"

namespace isolume {

/// What is uploaded; borrowed for the duration of Renderer::upload. All grids have the same size and spacing.
/// GPU memory: level 4 B/voxel (R32F), distance 2 B/voxel (R16F, in units of the smallest spacing), clearance 1 B/voxel
/// (clearance.h), octants 8 B/voxel, each light field 2 B/voxel (R16). At least two samples along each axis.
struct SceneFields {
  glm::dmat4 worldFromGrid{1};     ///< index to world: rotation or reflection, spacing, translation; no shear
  GridView<const float> level;     ///< > 0 inside; the surface is its trilinear zero set (sweep/level.h)
  GridView<const float> distance;  ///< world units, < 0 inside; may be empty: only NormalSource::distance reads it
  std::array<GridView<const glm::u8vec4>, 2> octants;  ///< may be empty: only Shading::octants reads them
  std::vector<LightField> lights;                      ///< up to kMostLightFields; only Shading::lights reads them
  std::optional<ColorField> color = {};                ///< in place of the albedo of the settings
};

enum class NormalSource { data, distance };
enum class Shading {
  octants,  ///< sum I_s V_s G_s(N) / pi ([Singh10] Eq. 3, 4), normalised: an open point under I = 1 gives 1
  lights,   ///< the sum of the light fields, interpolated at the hit, times their colours, a head light and suns
  local,    ///< head light, N . V: nothing swept needed
};

/// The uniform white sky.
inline constexpr std::array<glm::vec3, kOctantCount> kWhiteOctants{
    glm::vec3(1), glm::vec3(1), glm::vec3(1), glm::vec3(1), glm::vec3(1), glm::vec3(1), glm::vec3(1), glm::vec3(1)};

struct RenderSettings {
  glm::ivec2 size{1024, 1024};
  int samples = 1;  ///< anti-aliasing samples per pixel, >= 1
  Shading shading = Shading::octants;
  NormalSource normals = NormalSource::data;
  float occlusionOffsetVoxels =
      0;  ///< octants are read that far above the hit along the normal, index space; 0 is [Singh10]
  /// Octants: G_s divided by what the eight give on an open plane, read at that offset (sweep/octants/open_plane.h).
  /// For `front` terms of an opaque solid.
  bool openPlaneTerms = false;
  /// I_s, linear, finite, >= 0, by octant of sweep/octants.h (grid axes). The four with towardsLight().z > 0 alone are
  /// a cloudy day ([Singh10] Fig. 7). They and the geometry term change at the cost of a frame.
  std::array<glm::vec3, kOctantCount> octantLight = kWhiteOctants;
  GeometryTerm geometryTerm = GeometryTerm::front;  ///< octants: bothSides for a translucent solid
  std::vector<glm::vec3> lightColors = {};          ///< of each light field, linear, >= 0; empty: white
  glm::vec3 headLight{0};                           ///< lights: one from the eye without shadows, linear
  std::vector<HardSun> suns = {};                   ///< lights: up to kMostSuns, with shadows of the solid itself
  float gamma = 1;                                  ///< colour = albedo * light^(1 / gamma) ([Singh10] Sec. 2 uses 2)
  glm::vec3 albedo{1};                              ///< linear
  glm::vec4 background{1, 1, 1, 1};                 ///< linear, not premultiplied; alpha 0 = transparent
  std::optional<ScreenOcclusion> screen = {};  ///< light from the screen in place of `shading`; screen/screen_pass.h
  bool layers = false;                         ///< also fill light, normal, position, depth
};

/// Row-major, top row first. Colour is linear and premultiplied. Layers are taken at the centre of the pixel, never
/// averaged; where nothing is hit: light 1, normal 0, position NaN, depth +inf. Nothing behind the eye is seen (nor,
/// in orthographic pictures, behind the plane through it). An eye inside the solid sees the surface, and the caps, from
/// behind.
struct Frame {
  glm::ivec2 size{0};
  std::vector<glm::vec4> color;
  std::vector<glm::vec3> light;     ///< E / pi: an open point under a white sky has 1; before albedo and gamma; empty
                                    ///< unless asked for, as the following
  std::vector<glm::vec3> normal;    ///< world, unit, out of the solid
  std::vector<glm::vec3> position;  ///< world
  std::vector<glm::vec3> index;     ///< the same in index space; 0 where nothing is hit
  std::vector<float> depth;         ///< along the view axis, world units
};

/// Owns the GL objects of one scene. Must be used on the context's thread and destroyed before the context.
class Renderer {
 public:
  explicit Renderer(Context& context);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Replaces the scene. GpuError if a texture is larger than the context takes.
  void upload(const SceneFields& fields);
  /// Builds the program that pictures of the scene with these settings need, so that the first takes as long as others;
  /// never needed for what it draws.
  void prepare(const RenderSettings& settings);
  /// One picture, in the memory of `storage` where it has any (16 MB of fresh pages take a twentieth of the time of a
  /// 1024^2 frame). Bitwise the same on every call with the same scene, camera and settings. std::invalid_argument, one
  /// line, for a camera that contradicts itself; GpuError for settings that cannot be drawn.
  Frame render(const Camera& camera, const RenderSettings& settings = {}, Frame storage = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace isolume
