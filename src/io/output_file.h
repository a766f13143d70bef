// Files appear whole or not at all: bytes go to a temporary name in the same folder, then are renamed.
//
// The temporary name is hidden (".isolume-..."), created exclusively, with the permissions that the umask leaves. A
// symbolic link is followed: the file that it names is replaced, not the link. A name that is neither a file nor free
// (a device, a pipe: /dev/stdout) cannot be renamed over, so bytes go straight into it. An existing file that is
// write-protected stays. Not synced to the disk: a file is whole after a crash of the program, not of the machine.
// Thread-safe; one file is written at a time.
#pragma once

#include <string>
#include <string_view>

namespace isolume {

/// OutputError with the path and the system's reason: folder missing, no permission, disk full. The temporary file is
/// removed on failure, and by the handler of SIGINT and SIGTERM (installInterruptHandler).
void writeFileAtomically(const std::string& path, std::string_view bytes);

/// Fails early with the same OutputError as writing would, before minutes of work: folder missing or not writable.
/// Touches nothing.
void checkWritable(const std::string& path);

/// From now on SIGINT and SIGTERM remove an unfinished temporary file, print one line and exit with 130 or 143 at once.
void installInterruptHandler();

}  // namespace isolume
