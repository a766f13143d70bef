// The commands with their options, as the command-line library knows them, and the jobs that these fill in.
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "src/jobs/compare_job.h"
#include "src/jobs/fields_job.h"
#include "src/jobs/info_job.h"
#include "src/jobs/reference_job.h"
#include "src/jobs/render_job.h"
#include "src/jobs/sample_job.h"

namespace isolume {

/// Options hold references into it, so it stays where it is.
struct CommandParser {
  CLI::App app{"Isolume renders isosurfaces of volumes with swept ambient occlusion, without a window.", "isolume"};
  RenderJob render;
  InfoJob info;
  FieldsJob fields;
  SampleJob sample;
  ReferenceJob reference;
  CompareJob compare;
  std::vector<CLI::App*> commands;  ///< in the order in which help lists them

  CommandParser();
  CommandParser(const CommandParser&) = delete;
  CommandParser& operator=(const CommandParser&) = delete;

 private:
  CLI::App& add(const char* name, const char* description);
  void addSample();
};

}  // namespace isolume
