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
  }
  return nullptr;
}

std::array<ScreenEstimator, kScreenEstimators> screenEstimators() {
  std::array<ScreenEstimator, kScreenEstimators> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<ScreenEstimator>(i);
  return all;
}

bool readsCharacteristic(ScreenEstimator estimator) {
  return estimator != ScreenEstimator::loosArea && estimator != ScreenEstimator::hbao &&
         estimator != ScreenEstimator::gtao && estimator != ScreenEstimator::bitmask;
}

bool readsThickness(const ScreenOcclusion& settings) {
  if (settings.estimator == ScreenEstimator::bitmask || settings.estimator == ScreenEstimator::loosArea) return true;
  return readsCharacteristic(settings.estimator) && settings.surface == Characteristic::zBuffer;
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
