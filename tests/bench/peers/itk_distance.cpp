// ITK's exact Euclidean transform of a mask, used as its documentation recommends: SignedMaurerDistanceMapImageFilter,
// distances instead of their squares, spacing respected. It sees a mask, so the surface lies at voxel centres for it.
#include <itkImage.h>
#include <itkMultiThreaderBase.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>
#include <itkVersion.h>

#include <algorithm>

#include "tests/bench/report/distance_solver.h"

namespace isolume::bench {
namespace {

using Mask = itk::Image<unsigned char, 3>;
using Field = itk::Image<float, 3>;

Mask::Pointer maskOf(GridView<const float> level, double unit) {
  const auto mask = Mask::New();
  Mask::SizeType size;
  Mask::SpacingType spacing;
  for (unsigned axis = 0; axis < 3; ++axis) {
    size[axis] = static_cast<itk::SizeValueType>(level.size[static_cast<int>(axis)]);
    spacing[axis] = level.spacing[static_cast<int>(axis)] / unit;
  }
  mask->SetRegions(size);
  mask->SetSpacing(spacing);
  mask->Allocate();
  std::transform(level.data, level.data + level.count(), mask->GetBufferPointer(),
                 [](float value) { return static_cast<unsigned char>(value > 0 ? 1 : 0); });
  return mask;
}

}  // namespace

SolverOrGap itkMaurerSolver(GridView<const float> level, int threads) {
  const std::string name = "ITK signed Maurer";
  itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(static_cast<itk::ThreadIdType>(threads));
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(static_cast<itk::ThreadIdType>(threads));
  using Filter = itk::SignedMaurerDistanceMapImageFilter<Mask, Field>;
  const auto filter = Filter::New();
  filter->SetInput(maskOf(level, smallestSpacing(level.spacing)));
  filter->SquaredDistanceOff();
  filter->UseImageSpacingOn();
  filter->SetNumberOfWorkUnits(static_cast<itk::ThreadIdType>(threads));
  const auto solve = [filter] {
    filter->Modified();
    filter->Update();
  };
  const auto distanceAt = [filter](int x, int y, int z) {
    return static_cast<double>(filter->GetOutput()->GetPixel({x, y, z}));
  };
  return {name,
          DistanceSolver{name, itk::Version::GetITKVersion(),
                         "SignedMaurerDistanceMapImageFilter of the mask, spacing on, squares off", solve, distanceAt},
          ""};
}

}  // namespace isolume::bench
