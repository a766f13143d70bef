// The fields file: ten float grids (level, distance, eight octants) over one box that begins at index (0, 0, 0), and in
// the file's metadata what a picture needs besides. A hash over the whole file is checked before anything is decoded.
#include <fmt/format.h>
#include <openvdb/tools/Dense.h>

#include <cassert>
#include <cstring>
#include <map>

#include "byte_hash.h"
#include "input_file.h"
#include "placement.h"
#include "vdb.h"
#include "vdb_archive.h"
#include "vdb_dense.h"

namespace isolume {
namespace {

constexpr std::int64_t kFieldsVersion = 1;
constexpr const char* kVersionKey = "isolume_fields";
constexpr const char* kHashKey = "isolume_hash";
/// The metadata come first in a VDB, but the text of `source` may be long.
constexpr std::size_t kMetadataLimit = 1 << 18;

/// The bytes before the hash in the file: its name, the name and the size of its type, each with its length as OpenVDB
/// writes it, in this machine's order.
std::string hashMark() {
  const auto length = [](std::uint32_t n) { return std::string(reinterpret_cast<const char*>(&n), sizeof(n)); };
  const std::string type = "int64";
  return kHashKey + length(static_cast<std::uint32_t>(type.size())) + type + length(sizeof(std::int64_t));
}

std::size_t hashPosition(std::string_view head) {
  const std::string mark = hashMark();
  const std::size_t at = head.find(mark);
  return at == head.npos || at + mark.size() + sizeof(std::int64_t) > head.size() ? head.npos : at + mark.size();
}

std::map<std::string, GridView<float>> gridsOf(FieldsFile& fields) {
  std::map<std::string, GridView<float>> grids{{"level", fields.level.view()},
                                               {"distance", fields.swept.distance.view()}};
  for (int s = 0; s < kOctantCount; ++s)
    grids.emplace(fmt::format("visibility_{}", kOctants[static_cast<std::size_t>(s)].name),
                  fields.swept.visibility.octants[static_cast<std::size_t>(s)].view());
  return grids;
}

openvdb::Vec3i toVdb(glm::ivec3 v) { return {v.x, v.y, v.z}; }

template <class T>
T metaValue(const std::string& path, const openvdb::MetaMap& metadata, const char* key) {
  const auto found = metadata.getMetadata<openvdb::TypedMetadata<T>>(std::string("isolume_") + key);
  if (!found) throw InputError(fmt::format("{}: expected the metadata isolume_{}, found none", path, key));
  return found->value();
}

glm::ivec3 metaIndex(const std::string& path, const openvdb::MetaMap& metadata, const char* key) {
  const auto v = metaValue<openvdb::Vec3i>(path, metadata, key);
  return {v.x(), v.y(), v.z()};
}

void checkHash(const std::string& path) {
  const InputFile file(path);
  const std::size_t at = hashPosition(file.head(kMetadataLimit));
  if (at == std::string::npos)
    throw InputError(fmt::format("{}: expected a fields file made by isolume, found none", path));
  std::uint64_t stored = 0;
  file.readAt(at, &stored, sizeof(stored));
  const std::uint64_t found = hashBytes(file.size(), [&](std::uint64_t first, std::size_t count, char* to) {
    file.readAt(first, to, count);
    // The hash itself counted as zeros when it was made.
    for (std::uint64_t i = at; i < at + sizeof(stored); ++i)
      if (i >= first && i < first + count) to[i - first] = 0;
  });
  if (stored != found)
    throw InputError(fmt::format("{}: expected the checksum {:016x}, found {:016x}: the file is cut short or damaged",
                                 path, stored, found));
}

}  // namespace

bool isFieldsFile(const std::string& path) {
  const std::string head = InputFile(path).head(kMetadataLimit);
  return head.starts_with(" BDV") && head.find(kVersionKey) != head.npos && hashPosition(head) != head.npos;
}

std::string encodeFields(const FieldsFile& fields) {
  openvdb::MetaMap metadata;
  const auto put = [&](const char* key, const openvdb::Metadata& value) {
    metadata.insertMeta(std::string("isolume_") + key, value);
  };
  const glm::ivec3 size = fields.level.size();
  openvdb::Mat4d matrix;
  for (int i = 0; i < 16; ++i) matrix(i / 4, i % 4) = fields.worldFromGrid[i / 4][i % 4];
  metadata.insertMeta("creator", openvdb::StringMetadata("isolume"));
  put("fields", openvdb::Int64Metadata(kFieldsVersion));
  put("hash", openvdb::Int64Metadata(0));
  put("size", openvdb::Vec3IMetadata(toVdb(size)));
  put("world_from_grid", openvdb::Mat4DMetadata(matrix));
  put("isovalue", openvdb::DoubleMetadata(fields.isovalue));
  put("inside", openvdb::StringMetadata(fields.inside == Inside::above ? "above" : "below"));
  put("inside_count", openvdb::Int64Metadata(static_cast<std::int64_t>(fields.summary.insideCount)));
  put("replaced_count", openvdb::Int64Metadata(static_cast<std::int64_t>(fields.summary.replacedCount)));
  put("finite_min", openvdb::FloatMetadata(fields.summary.finiteMin));
  put("finite_max", openvdb::FloatMetadata(fields.summary.finiteMax));
  put("solid_min", openvdb::Vec3IMetadata(toVdb(fields.summary.solidMin)));
  put("solid_max", openvdb::Vec3IMetadata(toVdb(fields.summary.solidMax)));
  put("source", openvdb::StringMetadata(fields.source));

  openvdb::GridCPtrVec grids;
  const auto add = [&](const Grid<float>& values, const std::string& name, float background) {
    assert(values.size() == size && "every field has the size of the level");
    grids.push_back(denseVdbGrid(values.view(), fields.worldFromGrid, name, background));
  };
  // Outside the box other programs see: outside the solid, far away, unobstructed. isolume looks at the box alone.
  const glm::dvec3 extent = glm::dvec3(size) * fields.level.view().spacing;
  add(fields.level, "level", -1);
  add(fields.swept.distance, "distance", static_cast<float>(extent.x + extent.y + extent.z));
  for (std::size_t s = 0; s < kOctantCount; ++s)
    add(fields.swept.visibility.octants[s], fmt::format("visibility_{}", kOctants[s].name), 1);
  for (const auto& [name, values] : fields.others) add(values, name, 0);
  std::string bytes = encodeVdbFile(grids, metadata);
  const std::size_t at = hashPosition(bytes);
  const std::uint64_t hash = hashBytes(bytes);
  std::memcpy(bytes.data() + at, &hash, sizeof(hash));
  return bytes;
}

FieldsFile readFields(const std::string& path) {
  checkHash(path);
  return guardVdb(path, [&] {
    VdbArchive archive(path);
    const openvdb::MetaMap& metadata = archive.metadata();
    if (const auto version = metaValue<std::int64_t>(path, metadata, "fields"); version != kFieldsVersion)
      throw InputError(fmt::format("{}: expected fields of version {}, found {}", path, kFieldsVersion, version));
    FieldsFile fields;
    const auto matrix = metaValue<openvdb::Mat4d>(path, metadata, "world_from_grid");
    for (int i = 0; i < 16; ++i) fields.worldFromGrid[i / 4][i % 4] = matrix(i / 4, i % 4);
    checkPlacement(path, fields.worldFromGrid);
    fields.isovalue = metaValue<double>(path, metadata, "isovalue");
    fields.inside = metaValue<std::string>(path, metadata, "inside") == "above" ? Inside::above : Inside::below;
    fields.summary.insideCount = static_cast<std::size_t>(metaValue<std::int64_t>(path, metadata, "inside_count"));
    fields.summary.replacedCount = static_cast<std::size_t>(metaValue<std::int64_t>(path, metadata, "replaced_count"));
    fields.summary.finiteMin = metaValue<float>(path, metadata, "finite_min");
    fields.summary.finiteMax = metaValue<float>(path, metadata, "finite_max");
    fields.summary.solidMin = metaIndex(path, metadata, "solid_min");
    fields.summary.solidMax = metaIndex(path, metadata, "solid_max");
    fields.source = metaValue<std::string>(path, metadata, "source");

    const glm::i64vec3 size(metaIndex(path, metadata, "size"));
    const auto allocate = [&] { return makeGrid(path, size, fields.worldFromGrid); };
    fields.level = allocate();
    fields.swept.distance = allocate();
    for (auto& octant : fields.swept.visibility.octants) octant = allocate();
    const openvdb::CoordBBox box(openvdb::Coord(0),
                                 openvdb::Coord(metaValue<openvdb::Vec3i>(path, metadata, "size")) - openvdb::Coord(1));
    for (auto& [name, view] : gridsOf(fields)) {
      std::size_t entry = 0;
      while (entry < archive.entries().size() && archive.entries()[entry].name != name) ++entry;
      if (entry == archive.entries().size() || !archive.entries()[entry].grid->isType<openvdb::FloatGrid>())
        throw InputError(fmt::format("{}: expected a float grid '{}', found none", path, name));
      const auto grid = openvdb::gridConstPtrCast<openvdb::FloatGrid>(archive.read(entry));
      openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(box, view.data);
      openvdb::tools::copyToDense(*grid, dense);
    }
    return fields;
  });
}

}  // namespace isolume
