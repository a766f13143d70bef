// Files appear whole or not at all: bytes go to a temporary name in the same folder, then are renamed.
#pragma once

#include <string>
#include <string_view>

namespace isolume {

/// OutputError with the path and the system's reason: folder missing, no permission, disk full. The temporary file is
/// removed on failure, and by the handler of SIGINT and SIGTERM (installInterruptHandler).
void writeFileAtomically(const std::string& path, std::string_view bytes);

/// Fails early with the same OutputError as writing would, before minutes of work: folder missing or not writable.
void checkWritable(const std::string& path);

/// From now on SIGINT and SIGTERM remove an unfinished temporary file, print one line and exit with 130 or 143 at once.
void installInterruptHandler();

}  // namespace isolume
