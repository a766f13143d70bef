# The comparison: measures, similarity, limits and heat map on pictures made of known numbers.
isolume_test(test_compare
  compare/color_map_test.cpp
  compare/heat_map_test.cpp
  compare/layer_pair_test.cpp
  compare/limits_test.cpp
  compare/measures_test.cpp
  compare/ssim_test.cpp
  LIBS isolume_compare isolume_sweep fmt::fmt)
