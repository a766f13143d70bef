// Compiling and linking shader programs.
#pragma once

#include <string>

#include "gl_objects.h"
#include "shader_source.h"

namespace isolume {

/// A vertex and a fragment shader by file name, linked. GpuError with file and line of each complaint of the driver.
GlProgram buildProgram(const std::string& vertexName, const std::string& fragmentName,
                       const ShaderLookup& lookUp = embeddedShader);

}  // namespace isolume
