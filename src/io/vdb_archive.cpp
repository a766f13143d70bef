#include "vdb_archive.h"

#include <fmt/format.h>

#include <sstream>

#include "byte_hash.h"
#include "input_file.h"

namespace isolume {
namespace {

/// The base class keeps writing with offsets to itself and to openvdb::io::File.
class Writer : public openvdb::io::Archive {
 public:
  void writeTo(std::ostream& out, const openvdb::GridCPtrVec& grids, const openvdb::MetaMap& metadata) const {
    Archive::write(out, grids, /*seekable=*/true, metadata);
  }
};

}  // namespace

void initializeVdb() { openvdb::initialize(); }

VdbArchive::VdbArchive(const std::string& path) : path_(path) {
  initializeVdb();
  const InputFile file(path);
  const auto fileSize = static_cast<std::int64_t>(file.size());
  // The format's version follows the magic number. OpenVDB itself would go on with a warning on the terminal.
  std::uint32_t version = 0;
  file.readAt(sizeof(std::int64_t), &version, sizeof(version));
  if (version > openvdb::OPENVDB_FILE_VERSION)
    throw InputError(fmt::format("{}: expected VDB format {} or earlier, found {}", path,
                                 static_cast<std::uint32_t>(openvdb::OPENVDB_FILE_VERSION), version));
  stream_.open(path, std::ios::binary);
  stream_.exceptions(std::ios::failbit | std::ios::badbit);
  readHeader(stream_);
  setFormatVersion(stream_);
  setLibraryVersion(stream_);
  setDataCompression(stream_);
  metadata_.readMeta(stream_);
  const std::int32_t count = readGridCount(stream_);
  if (inputHasGridOffsets()) {
    readTable(count, fileSize);
  } else {
    readOneByOne(count);
  }
}

void VdbArchive::readTable(std::int32_t count, std::int64_t fileSize) {
  for (std::int32_t i = 0; i < count; ++i) {
    Entry entry;
    entry.grid = entry.descriptor.read(stream_);
    const openvdb::io::GridDescriptor& d = entry.descriptor;
    entry.name = openvdb::io::GridDescriptor::nameAsString(d.uniqueName());
    if (d.getEndPos() > fileSize)
      throw InputError(fmt::format("{}: expected at least {} bytes (grid '{}'), found {}", path_, d.getEndPos(),
                                   entry.name, fileSize));
    if (d.getGridPos() < 0 || d.getGridPos() > d.getEndPos())
      throw InputError(
          fmt::format("{}: expected grid '{}' at a place in the file, found {}", path_, entry.name, d.getGridPos()));
    d.seekToGrid(stream_);
    readGridCompression(stream_);
    entry.grid->readMeta(stream_);
    entry.grid->readTransform(stream_);
    d.seekToEnd(stream_);
    entries_.push_back(std::move(entry));
  }
}

void VdbArchive::readOneByOne(std::int32_t count) {
  for (std::int32_t i = 0; i < count; ++i) {
    Entry entry;
    entry.grid = entry.descriptor.read(stream_);
    entry.name = openvdb::io::GridDescriptor::nameAsString(entry.descriptor.uniqueName());
    readGrid(entry.grid, entry.descriptor, stream_);
    entry.complete = true;
    if (entry.descriptor.isInstance()) entry.grid->setTree(parentOf(entry).grid->baseTreePtr());
    entries_.push_back(std::move(entry));
  }
}

const VdbArchive::Entry& VdbArchive::parentOf(const Entry& entry) const {
  for (const Entry& other : entries_)
    if (other.descriptor.uniqueName() == entry.descriptor.instanceParentName() && !other.descriptor.isInstance())
      return other;
  throw InputError(
      fmt::format("{}: expected the grid that '{}' shares its values with, found none", path_, entry.name));
}

openvdb::GridBase::Ptr VdbArchive::read(std::size_t index) {
  const Entry& entry = entries_.at(index);
  if (entry.complete) return entry.grid;
  const auto load = [this](const openvdb::io::GridDescriptor& descriptor) {
    openvdb::GridBase::Ptr grid = openvdb::GridBase::createGrid(descriptor.gridType());
    grid->setSaveFloatAsHalf(descriptor.saveFloatAsHalf());
    descriptor.seekToGrid(stream_);
    readGrid(grid, descriptor, stream_);
    return grid;
  };
  openvdb::GridBase::Ptr grid = load(entry.descriptor);
  if (entry.descriptor.isInstance()) grid->setTree(load(parentOf(entry).descriptor)->baseTreePtr());
  return grid;
}

std::string encodeVdbFile(const openvdb::GridCPtrVec& grids, const openvdb::MetaMap& metadata) {
  initializeVdb();
  Writer writer;
  // Blosc decodes several times faster than zip; neither changes a bit of an active value.
  writer.setCompression(
      (openvdb::io::Archive::hasBloscCompression() ? openvdb::io::COMPRESS_BLOSC : openvdb::io::COMPRESS_ZIP) |
      openvdb::io::COMPRESS_ACTIVE_MASK);
  std::ostringstream out(std::ios::binary);
  out.exceptions(std::ios::failbit | std::ios::badbit);
  writer.writeTo(out, grids, metadata);
  std::string bytes = std::move(out).str();
  // OpenVDB puts a random identifier here; the same content shall give the same file.
  constexpr std::size_t kIdAt = 21, kIdLength = 36;
  bytes.replace(kIdAt, kIdLength, kIdLength, '0');
  const std::uint64_t first = hashBytes(bytes), second = hashBytes(std::string_view(bytes).substr(kIdAt));
  bytes.replace(kIdAt, kIdLength,
                fmt::format("{:08x}-{:04x}-{:04x}-{:04x}-{:012x}", first >> 32, first >> 16 & 0xffff, first & 0xffff,
                            second >> 48, second & 0xffffffffffff));
  return bytes;
}

}  // namespace isolume
