// The colour of the surface that a pixel shows, linear. A scene that is coloured by a field has albedo_field.glsl in its
// place (raymarch/surface_colors.h).
vec3 albedoOf(ivec2 pixel) { return frame.albedo.rgb; }
