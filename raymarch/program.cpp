#include "program.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "gpu_error.h"

namespace isolume {
namespace {

GlShader compile(GLenum stage, const ShaderSource& source) {
  GlShader shader = GlShader::create(stage);
  const char* text = source.text.c_str();
  glShaderSource(shader.name(), 1, &text, nullptr);
  glCompileShader(shader.name());
  GLint compiled = GL_FALSE, length = 0;
  glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled) return shader;
  glGetShaderiv(shader.name(), GL_INFO_LOG_LENGTH, &length);
  std::vector<char> log(static_cast<std::size_t>(std::max(length, 1)));
  glGetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
  const std::string message = rewriteLog(log.data(), source.files);
  throw GpuError(message.empty() ? source.files.front() + ": does not compile, and the driver does not say why"
                                 : message);
}

}  // namespace

GlProgram buildProgram(const std::string& vertexName, const std::string& fragmentName, const ShaderLookup& lookUp) {
  const GlShader vertex = compile(GL_VERTEX_SHADER, resolveIncludes(vertexName, lookUp));
  const GlShader fragment = compile(GL_FRAGMENT_SHADER, resolveIncludes(fragmentName, lookUp));
  GlProgram program = GlProgram::create();
  for (const GlShader* shader : {&vertex, &fragment}) glAttachShader(program.name(), shader->name());
  glLinkProgram(program.name());
  for (const GlShader* shader : {&vertex, &fragment}) glDetachShader(program.name(), shader->name());
  GLint linked = GL_FALSE, length = 0;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked) return program;
  glGetProgramiv(program.name(), GL_INFO_LOG_LENGTH, &length);
  std::vector<char> log(static_cast<std::size_t>(std::max(length, 1)));
  glGetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw GpuError(fmt::format("{} + {}: does not link: {}", vertexName, fragmentName, rewriteLog(log.data(), {})));
}

}  // namespace isolume
