// From named GLSL files to the text that a driver compiles, and from the driver's complaints back to file and line.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace isolume {

/// Text of a shader file by name ("shaders/lib/ray_box.glsl"); empty if there is none.
using ShaderLookup = std::function<std::string_view(std::string_view name)>;
/// The files embedded in this library.
std::string_view embeddedShader(std::string_view name);

/// A file's number travels in the line number: GLSL's own source-string number is lost by Mesa in all but syntax
/// errors.
inline constexpr int kLinesPerFile = 10000;

struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  ///< lines of file i are numbered from i * kLinesPerFile + 1
};

/// Replaces each `#include "path"` (relative to shaders/) by that file's text, once per file; a second include of the
/// same file is dropped. #line directives keep the numbers of every file (offset, see above). GpuError if a file does
/// not exist.
ShaderSource resolveIncludes(std::string_view name, const ShaderLookup& lookUp = embeddedShader);

/// The driver's log with line numbers turned back to file and line, "shaders/march_octants.frag:42: ...", in one line.
/// Understands the forms of Mesa "0:10042(7): error", NVIDIA "0(10042) : error" and AMD / Intel "ERROR: 0:10042: ".
std::string rewriteLog(std::string_view log, const std::vector<std::string>& files);

}  // namespace isolume
