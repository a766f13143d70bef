isolume_test(test_output out/test_checksum.cpp out/test_image.cpp out/test_interrupt.cpp out/test_output_file.cpp
  out/test_png_text.cpp LIBS isolume_writers)
isolume_test(test_scenes out/test_scene_distances.cpp out/test_scene_shapes.cpp LIBS isolume_volumes isolume_sweep)
