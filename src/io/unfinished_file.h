// The one temporary file that may be unfinished, known to the handler of SIGINT and SIGTERM, which removes it.
#pragma once

#include <string>

namespace isolume {

/// Creates an empty file that the interrupt handler removes until it is published or discarded. One at a time per
/// process: the caller holds a lock. While a name appears or is renamed, the signals are blocked on this thread and the
/// handler waits on others, so that no interrupt falls between a file and the record of it.
class UnfinishedFile {
 public:
  /// Creates `path` exclusively; descriptor() is -1 and errno says why if that fails.
  explicit UnfinishedFile(const std::string& path);
  ~UnfinishedFile();  ///< removes the file unless it was published
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  int descriptor() const { return descriptor_; }
  bool close();                                ///< false and errno: the last bytes did not reach the file
  bool publish(const std::string& finalPath);  ///< renames; false and errno on failure

 private:
  std::string path_;
  int descriptor_ = -1;
  bool exists_ = false;
};

}  // namespace isolume
