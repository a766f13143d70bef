#include "support/embree_scene.h"

#include <embree3/rtcore.h>

#include <cstring>
#include <stdexcept>

namespace isolume::test {

struct EmbreeScene::Handles {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  ~Handles() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

namespace {

RTCRay makeRay(const GridRay& ray) {
  RTCRay result{};
  result.org_x = static_cast<float>(ray.origin.x);
  result.org_y = static_cast<float>(ray.origin.y);
  result.org_z = static_cast<float>(ray.origin.z);
  result.dir_x = static_cast<float>(ray.direction.x);
  result.dir_y = static_cast<float>(ray.direction.y);
  result.dir_z = static_cast<float>(ray.direction.z);
  result.tnear = static_cast<float>(ray.start);
  result.tfar = static_cast<float>(ray.end);
  result.mask = ~0U;
  return result;
}

}  // namespace

EmbreeScene::EmbreeScene(const std::vector<glm::vec3>& triangles) : handles_(std::make_unique<Handles>()) {
  handles_->device = rtcNewDevice(nullptr);
  if (!handles_->device) throw std::runtime_error("Embree: no device");
  handles_->scene = rtcNewScene(handles_->device);
  rtcSetSceneFlags(handles_->scene, RTC_SCENE_FLAG_ROBUST);
  if (!triangles.empty()) {
    const RTCGeometry mesh = rtcNewGeometry(handles_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* corners = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                            triangles.size());
    std::memcpy(corners, triangles.data(), triangles.size() * sizeof(glm::vec3));
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(unsigned), triangles.size() / 3));
    for (std::size_t i = 0; i < triangles.size(); ++i) indices[i] = static_cast<unsigned>(i);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(handles_->scene, mesh);
    rtcReleaseGeometry(mesh);
  }
  rtcCommitScene(handles_->scene);
  if (rtcGetDeviceError(handles_->device) != RTC_ERROR_NONE) throw std::runtime_error("Embree: no scene");
}

EmbreeScene::~EmbreeScene() = default;

std::optional<double> EmbreeScene::firstHit(const GridRay& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit hit{};
  hit.ray = makeRay(ray);
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(handles_->scene, &context, &hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return hit.ray.tfar;
}

bool EmbreeScene::isBlocked(const GridRay& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay shadow = makeRay(ray);
  rtcOccluded1(handles_->scene, &context, &shadow);
  return shadow.tfar < 0;  // Embree's sign for "occluded"
}

}  // namespace isolume::test
