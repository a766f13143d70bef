// The colour of the surface at a hit, linear. A scene that is coloured by a field has albedo_field.glsl in its place
// (raymarch/surface_colors.h).
vec3 albedoAt(vec3 hit) { return frame.albedo.rgb; }
