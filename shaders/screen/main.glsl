// One pixel's openness; where nothing is seen, 1.
layout(location = 0) out vec4 outLight;  // linear light, and openness

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depthTexture, pixel, 0).r;
  if (depth >= kNothingSeen) {
    outLight = vec4(1.0f);
    return;
  }
  place = placeOf(pixel, depth);
  outLight = vec4(estimate(shadedAt(pixel)));
}
