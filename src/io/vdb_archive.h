// Reading and writing VDB files through a stream of our own. For the translation units that use OpenVDB only.
//
// openvdb::io::File neither notices a file that ends too soon nor says where a grid ends, and openvdb::io::Stream
// cannot write the table of offsets that lets a reader skip grids. Their base class can do both.
#pragma once

#include <openvdb/io/Archive.h>
#include <openvdb/openvdb.h>

#include <fstream>
#include <string>
#include <vector>

#include "errors.h"

namespace isolume {

void initializeVdb();  ///< registers OpenVDB's types; cheap after the first call

/// Runs code that may throw OpenVDB's or the stream's exceptions; they become one InputError with the path.
template <class Call>
auto guardVdb(const std::string& path, Call call) {
  try {
    return call();
  } catch (const InputError&) {
    throw;
  } catch (const std::ios_base::failure&) {
    throw InputError(path + ": expected a whole VDB file, found one that ends too soon or is damaged");
  } catch (const std::bad_alloc&) {
    throw InputError(path + ": out of memory, or a damaged VDB file");
  } catch (const std::exception& error) {
    throw InputError(path + ": expected a VDB file, found: " + error.what());
  }
}

/// An open VDB file: what it contains is read at once, grids on request.
class VdbArchive : private openvdb::io::Archive {
 public:
  explicit VdbArchive(const std::string& path);

  struct Entry {
    std::string name;  ///< NAME, or NAME[i] where names repeat or are empty
    openvdb::io::GridDescriptor descriptor;
    openvdb::GridBase::Ptr grid;  ///< metadata and transform; the whole grid in files without offsets
    bool complete = false;        ///< the tree is there too
  };
  const std::vector<Entry>& entries() const { return entries_; }
  const openvdb::MetaMap& metadata() const { return metadata_; }

  /// The grid with its tree, read anew at each call. A grid that shares its tree with another one gets that tree.
  openvdb::GridBase::Ptr read(std::size_t entry);

 private:
  void readOneByOne(std::int32_t count);
  void readTable(std::int32_t count, std::int64_t fileSize);
  const Entry& parentOf(const Entry& entry) const;

  std::string path_;
  std::ifstream stream_;
  openvdb::MetaMap metadata_;
  std::vector<Entry> entries_;
};

/// A VDB file in memory, with the table of offsets. Lossless.
std::string encodeVdbFile(const openvdb::GridCPtrVec& grids, const openvdb::MetaMap& metadata);

}  // namespace isolume
