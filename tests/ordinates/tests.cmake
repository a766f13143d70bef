isolume_test(test_ordinates
  ordinates/carried_rays_test.cpp
  ordinates/light_sweeps_test.cpp
  ordinates/openness_caps_test.cpp
  ordinates/openness_reference_test.cpp
  ordinates/openness_test.cpp
  ordinates/ordinate_set_test.cpp
  ordinates/plane_test.cpp
  ordinates/ray_points_test.cpp
  ordinates/sheared_rays_test.cpp
  ordinates/sky_ordinates_test.cpp
  ordinates/solid_lattice_test.cpp
  ordinates/surface_feet_test.cpp
  support/plain_carried.cpp
  support/plain_rays.cpp
  support/random_grids.cpp
  LIBS isolume_sweep isolume_reference isolume_volumes hwy::hwy)
