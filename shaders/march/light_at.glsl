// A field of light at a place of the cell whose eight corners are gathered about `centre`, from slice `layer` on.
// Trilinear, weighed by hand: filters round their weights to 8 bits. All corners of a cell that the surface crosses hold
// a value, and so do all solid samples on the border, where caps are hit.
float lightAt(sampler2DArray field, vec2 centre, float layer, vec3 weight) {
  vec4 sides[2];
  for (int z = 0; z < 2; ++z) sides[z] = textureGather(field, vec3(centre, layer + float(z))).wzxy;
  vec4 texels = mix(sides[0], sides[1], weight.z);
  vec2 alongX = mix(texels.xz, texels.yw, weight.x);
  return mix(alongX.x, alongX.y, weight.y);
}
