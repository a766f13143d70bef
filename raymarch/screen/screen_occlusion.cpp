#include "raymarch/screen/screen_occlusion.h"

namespace isolume {

const char* screenEstimatorName(ScreenEstimator estimator) {
  switch (estimator) {
    case ScreenEstimator::crytek:
      return "crytek";
    case ScreenEstimator::hbao:
      return "hbao";
    case ScreenEstimator::gpuSphere:
      return "gpu-sphere";
    case ScreenEstimator::gpuHemisphere:
      return "gpu-hemisphere";
    case ScreenEstimator::gpuImportance:
      return "gpu-importance";
    case ScreenEstimator::gpuTangent:
      return "gpu-tangent";
    case ScreenEstimator::gpuDisk:
      return "gpu-disk";
    case ScreenEstimator::szirmayContainment:
      return "szirmay10-containment";
    case ScreenEstimator::szirmayVolumetric:
      return "szirmay10-volumetric";
    case ScreenEstimator::loosPoint:
      return "loos10-point";
    case ScreenEstimator::loosLine:
      return "loos10-line";
    case ScreenEstimator::loosArea:
      return "loos10-area";
    case ScreenEstimator::ssdo:
      return "ssdo";
    case ScreenEstimator::gtao:
      return "gtao";
    case ScreenEstimator::bitmask:
      return "bitmask";
    case ScreenEstimator::klehm11:
      return "klehm11";
    case ScreenEstimator::envImportance:
      return "env-importance";
  }
  return nullptr;
}

const char* bentSourceName(BentSource source) {
  switch (source) {
    case BentSource::crytek2d:
      return "crytek-2d";
    case BentSource::crytek3d:
      return "crytek-3d";
    case BentSource::hbao:
      return "hbao";
    case BentSource::sweep:
      return "sweep";
  }
  return nullptr;
}

const char* bentLightName(BentLight light) {
  switch (light) {
    case BentLight::none:
      return "none";
    case BentLight::normal:
      return "normal";
    case BentLight::cone:
      return "cone";
    case BentLight::cap:
      return "cap";
  }
  return nullptr;
}

std::array<ScreenEstimator, kScreenEstimators> screenEstimators() {
  std::array<ScreenEstimator, kScreenEstimators> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<ScreenEstimator>(i);
  return all;
}

bool readsCharacteristic(const ScreenOcclusion& settings) {
  switch (settings.estimator) {
    case ScreenEstimator::loosArea:
    case ScreenEstimator::hbao:
    case ScreenEstimator::gtao:
    case ScreenEstimator::bitmask:
      return false;
    case ScreenEstimator::klehm11:
      return settings.bentFrom == BentSource::crytek3d;
    default:
      return true;
  }
}

bool readsSky(ScreenEstimator estimator) {
  return estimator == ScreenEstimator::klehm11 || estimator == ScreenEstimator::ssdo ||
         estimator == ScreenEstimator::envImportance;
}

bool readsNeighbourhood(const ScreenOcclusion& settings) {
  return settings.estimator != ScreenEstimator::klehm11 || settings.bentFrom != BentSource::sweep;
}

bool readsSteps(const ScreenOcclusion& settings) {
  return settings.estimator == ScreenEstimator::envImportance ||
         (settings.estimator == ScreenEstimator::klehm11 && settings.bentFrom == BentSource::crytek3d);
}

bool readsThickness(const ScreenOcclusion& settings) {
  if (settings.estimator == ScreenEstimator::bitmask || settings.estimator == ScreenEstimator::loosArea) return true;
  if (settings.estimator == ScreenEstimator::klehm11 && settings.bentFrom == BentSource::crytek2d) return true;
  return readsCharacteristic(settings) && settings.surface == Characteristic::zBuffer;
}

std::vector<Membership> takenMemberships(ScreenEstimator estimator) {
  switch (estimator) {
    case ScreenEstimator::gpuImportance:
    case ScreenEstimator::szirmayContainment:
      return {Membership::classical, Membership::squareRoot, Membership::linear, Membership::volumetric,
              Membership::quartic};
    case ScreenEstimator::gpuSphere:
    case ScreenEstimator::gpuHemisphere:
    case ScreenEstimator::gpuTangent:
      return {Membership::squareRoot, Membership::linear, Membership::volumetric, Membership::quartic};
    default:
      return {};
  }
}

bool readsNormalisation(ScreenEstimator estimator) {
  switch (estimator) {
    case ScreenEstimator::crytek:
    case ScreenEstimator::hbao:
    case ScreenEstimator::gpuImportance:
    case ScreenEstimator::szirmayContainment:
    case ScreenEstimator::loosPoint:
    case ScreenEstimator::klehm11:
      return false;
    default:
      return true;
  }
}

bool isLoos10(ScreenEstimator estimator) {
  return estimator == ScreenEstimator::loosPoint || estimator == ScreenEstimator::loosLine ||
         estimator == ScreenEstimator::loosArea;
}

}  // namespace isolume
