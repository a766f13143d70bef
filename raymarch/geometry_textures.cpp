#include "geometry_textures.h"

#include "sweep/octants/open_plane.h"
#include "textures.h"

namespace isolume {
namespace {

GeometryTextures::Pair upload(const GeometryTermTables& tables) {
  GeometryTextures::Pair textures;
  for (std::size_t i = 0; i < textures.size(); ++i) {
    textures[i] =
        makeTexture2D("geometry terms", glm::ivec2(tables.size), kRGBA32F, GL_LINEAR, tables.texels[i].data());
  }
  return textures;
}

}  // namespace

const GeometryTextures::Pair& GeometryTextures::of(GeometryTerm term) {
  Pair& textures = tables_[static_cast<std::size_t>(term)];
  if (!textures[0]) textures = upload(makeGeometryTermTables(kGeometryTableSize, term));
  return textures;
}

const GeometryTextures::Pair& GeometryTextures::dividedByOpenPlane(glm::dvec3 spacing, float offset) {
  if (!divided_[0] || spacing_ != spacing || offset_ != offset) {
    GeometryTermTables tables = makeGeometryTermTables();
    divideByOpenPlane(tables, makeOpenPlaneTable(spacing, offset));
    divided_ = upload(tables);
    spacing_ = spacing;
    offset_ = offset;
  }
  return divided_;
}

}  // namespace isolume
