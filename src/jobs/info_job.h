// `isolume info`: what is in a file, before anybody renders it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "src/io/volume.h"

namespace isolume {

struct InfoJob {
  std::string input;
  ReadOptions read;
  bool json = false;
  bool quiet = false;
};

/// Everything that `info` tells, as one JSON object: `input`, `format`, `type`, `files`, `grids` (VDB), `dims`,
/// `voxels`, `spacing`, `origin`, `direction` (three columns), `world`, `bounds`, `extent`, `values` (`min`, `max`,
/// `mean`, `nan`, `inf`, `histogram`), `isovalue`, `isovalue_choice`, `inside`, `notes`; for a fields file `fields`. A
/// VDB with several scalar grids and none chosen has `grids` alone.
nlohmann::ordered_json gatherInfo(const InfoJob& job);

/// The same for people. One trailing newline.
std::string infoText(const nlohmann::ordered_json& info);

void runInfoJob(const InfoJob& job);

}  // namespace isolume
