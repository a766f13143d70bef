// The JSON that --report writes: what a benchmark or a batch reads back.
#pragma once

#include <cstddef>
#include <string>

#include "src/jobs/provenance.h"
#include "src/jobs/stage_log.h"
#include "src/jobs/surface.h"

namespace isolume {

/// Size of a file that was just written; 0 for what has no size (a pipe).
std::size_t fileBytes(const std::string& path);

/// An object with `command`, `version`, `input` (`path`, `sha256`, `format`, `type`), `voxels`, `dims`, `threads`,
/// `stages` (array of `name`, `seconds`, `bytes`; see stage_log.h), `seconds` (the whole job), `peak_rss_bytes`, and
/// `settings` (all of them, defaults resolved). Written atomically; OutputError.
void writeReport(const std::string& path, const StageLog& log, const Surface& surface, const Provenance& provenance);

}  // namespace isolume
