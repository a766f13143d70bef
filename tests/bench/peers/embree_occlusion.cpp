#include "tests/bench/peers/embree_occlusion.h"

#include <embree3/rtcore.h>
#include <fmt/core.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "sweep/parallel.h"
#include "volumes/random.h"

namespace isolume::bench {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

RTCRay rayFrom(glm::vec3 origin, glm::vec3 direction) {
  RTCRay ray{};
  ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
  ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
  ray.tfar = kInfinity;
  ray.mask = ~0U;
  return ray;
}

/// Centres of the cells of a k x k grid on the unit square.
std::vector<glm::vec2> strata(int rays) {
  const int k = static_cast<int>(std::lround(std::sqrt(static_cast<double>(rays))));
  if (rays < 1 || k * k != rays)
    throw std::invalid_argument(fmt::format("--rays: expected square numbers, found {}", rays));
  std::vector<glm::vec2> points;
  for (int j = 0; j < k; ++j)
    for (int i = 0; i < k; ++i) points.push_back((glm::vec2(i, j) + 0.5F) / static_cast<float>(k));
  return points;
}

/// Unit square to cosine-weighted hemisphere about +z. [Shirley97]
glm::vec3 hemisphere(glm::vec2 u) {
  const glm::vec2 p = 2.0F * u - 1.0F;
  if (p.x == 0 && p.y == 0) return {0, 0, 1};
  constexpr float kQuarter = std::numbers::pi_v<float> / 4;
  const bool wide = std::abs(p.x) > std::abs(p.y);
  const float radius = wide ? p.x : p.y;
  const float angle = wide ? kQuarter * (p.y / p.x) : 2 * kQuarter - kQuarter * (p.x / p.y);
  const glm::vec2 d = radius * glm::vec2(std::cos(angle), std::sin(angle));
  return {d, std::sqrt(std::max(0.0F, 1 - glm::dot(d, d)))};
}

/// Two directions across a unit vector. [Duff17]
void basis(glm::vec3 n, glm::vec3& x, glm::vec3& y) {
  const float sign = std::copysign(1.0F, n.z);
  const float a = -1 / (sign + n.z), b = n.x * n.y * a;
  x = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
  y = {b, sign + n.y * n.y * a, -n.y};
}

glm::vec2 rotationOf(std::size_t pixel) {
  const std::uint64_t bits = mixBits(mixBits(pixel + 1));
  return {static_cast<float>(bits >> 40) * 0x1p-24F, static_cast<float>(bits & 0xffffff) * 0x1p-24F};
}

template <class T>
void copyBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const std::vector<T>& items) {
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), items.size());
  std::memcpy(buffer, items.data(), items.size() * sizeof(T));
}

}  // namespace

struct EmbreeOcclusion::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  SurfaceMesh mesh;
  float offset = 0;

  bool blocked(glm::vec3 origin, glm::vec3 direction) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray = rayFrom(origin, direction);
    rtcOccluded1(scene, &context, &ray);
    return ray.tfar < 0;
  }

  float openness(glm::vec3 point, glm::vec3 normal, const std::vector<glm::vec2>& points, glm::vec2 rotation) const {
    glm::vec3 x, y;
    basis(normal, x, y);
    int open = 0;
    for (const glm::vec2 u : points) {
      const glm::vec3 d = hemisphere(glm::fract(u + rotation));
      open += blocked(point + offset * normal, d.x * x + d.y * y + d.z * normal) ? 0 : 1;
    }
    return static_cast<float>(open) / static_cast<float>(points.size());
  }
};

EmbreeOcclusion::EmbreeOcclusion(const SurfaceMesh& mesh, int threads) : impl_(std::make_unique<Impl>()) {
  impl_->mesh = mesh;
  impl_->device = rtcNewDevice(fmt::format("threads={},set_affinity=0", threads).c_str());
  if (!impl_->device)
    throw std::runtime_error(fmt::format("Embree: no device, error {}", int(rtcGetDeviceError(nullptr))));
  RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  // Embree reads 16 bytes at each point; its own buffers are padded for that.
  copyBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.points);
  copyBuffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
  rtcCommitGeometry(geometry);
  impl_->scene = rtcNewScene(impl_->device);
  rtcAttachGeometry(impl_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(impl_->scene);
  glm::vec3 low(kInfinity), high(-kInfinity);
  for (const glm::vec3 p : mesh.points) low = glm::min(low, p), high = glm::max(high, p);
  impl_->offset = kRayOffset * glm::length(high - low);
}

EmbreeOcclusion::~EmbreeOcclusion() {
  rtcReleaseScene(impl_->scene);
  rtcReleaseDevice(impl_->device);
}

Frame EmbreeOcclusion::render(const Camera& camera, glm::ivec2 size, int rays) const {
  const std::vector<glm::vec2> points = strata(rays);
  const CameraAxes axes = cameraAxes(camera);
  const double pixel = 2 * std::tan(glm::radians(camera.fovDegrees) / 2) / camera.zoom / size.y;
  const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  Frame frame;
  frame.size = size;
  frame.color.assign(count, glm::vec4(0));
  frame.light.assign(count, glm::vec3(1));
  frame.normal.assign(count, glm::vec3(0));
  frame.position.assign(count, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
  frame.depth.assign(count, kInfinity);

  parallelFor(static_cast<std::size_t>(size.y), [&](std::size_t row) {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (int x = 0; x < size.x; ++x) {
      const glm::dvec2 at = (glm::dvec2(x, row) + 0.5 - 0.5 * glm::dvec2(size)) * pixel;
      const glm::vec3 direction(axes.forward + at.x * axes.right - at.y * axes.up);
      RTCRayHit query{};
      query.ray = rayFrom(glm::vec3(camera.eye), direction);
      query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(impl_->scene, &context, &query);
      if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
      const std::size_t i = row * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
      const auto& [a, b, c] = impl_->mesh.triangles[query.hit.primID];
      const float u = query.hit.u, v = query.hit.v;
      const auto interpolate = [&](const std::vector<glm::vec3>& of) {
        return (1 - u - v) * of[a] + u * of[b] + v * of[c];
      };
      const glm::vec3 sum = interpolate(impl_->mesh.normals);
      const float length = glm::length(sum);
      const glm::vec3 normal = length > 0 ? sum / length : impl_->mesh.normals[a];
      frame.normal[i] = normal;
      frame.position[i] = interpolate(impl_->mesh.points);
      frame.depth[i] = query.ray.tfar;  // the direction's part along the view axis is 1
      frame.light[i] = glm::vec3(impl_->openness(frame.position[i], normal, points, rotationOf(i)));
      frame.color[i] = glm::vec4(frame.light[i], 1);
    }
  });
  return frame;
}

std::string embreeVersion() { return fmt::format("{}.{}.{}", RTC_VERSION_MAJOR, RTC_VERSION_MINOR, RTC_VERSION_PATCH); }

}  // namespace isolume::bench
