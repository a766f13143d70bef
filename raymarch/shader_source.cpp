#include "shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "gpu_error.h"
#include "shaders/embedded_shaders.h"

namespace isolume {
namespace {

constexpr std::string_view kFolder = "shaders/";

// The path of `#include "path"`, or empty.
std::string includedPath(const std::string& line) {
  static const std::regex pattern(R"re(^\s*#\s*include\s+"([^"]+)"\s*$)re");
  std::smatch match;
  return std::regex_match(line, match, pattern) ? match[1].str() : std::string();
}

std::string lineDirective(int line, std::size_t file) {
  return fmt::format("#line {}\n", file * kLinesPerFile + static_cast<std::size_t>(line));
}

void append(ShaderSource& source, const std::string& name, const std::string& from, const ShaderLookup& lookUp) {
  const std::string_view text = lookUp(name);
  if (text.empty()) throw GpuError(fmt::format("{}: no such shader file", from.empty() ? name : from + ": " + name));
  const std::size_t number = source.files.size();
  source.files.push_back(name);
  if (number > 0) source.text += lineDirective(1, number);
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int lineNumber = 1; std::getline(lines, line); ++lineNumber) {
    const std::string path = includedPath(line);
    if (path.empty()) {
      source.text += line + '\n';
      continue;
    }
    const std::string included = std::string(kFolder) + path;
    const bool seen = std::find(source.files.begin(), source.files.end(), included) != source.files.end();
    if (!seen) append(source, included, fmt::format("{}:{}", name, lineNumber), lookUp);
    source.text += seen ? "\n" : lineDirective(lineNumber + 1, number);
  }
}

// "file:line: message" if the line of the log starts with a position in one of the known forms.
std::string rewriteLine(const std::string& line, const std::vector<std::string>& files) {
  static const std::regex mesa(R"re(^\d+:(\d+)\(\d+\):\s*(.*)$)re");
  static const std::regex nvidia(R"re(^\d+\((\d+)\)\s*:\s*(.*)$)re");
  static const std::regex khronos(R"re(^(?:ERROR|WARNING):\s*\d+:(\d+):\s*(.*)$)re");
  for (const std::regex& pattern : {mesa, nvidia, khronos}) {
    std::smatch match;
    if (!std::regex_match(line, match, pattern)) continue;
    const std::size_t number = std::stoul(match[1]);
    const std::size_t file = number / kLinesPerFile;
    if (file < files.size()) return fmt::format("{}:{}: {}", files[file], number % kLinesPerFile, match[2].str());
  }
  return line;
}

}  // namespace

std::string_view embeddedShader(std::string_view name) {
  for (const EmbeddedShader& shader : embeddedShaders()) {
    if (shader.name == name) return shader.text;
  }
  return {};
}

ShaderSource resolveIncludes(std::string_view name, const ShaderLookup& lookUp) {
  ShaderSource source;
  append(source, std::string(name), "", lookUp);
  return source;
}

std::string rewriteLog(std::string_view log, const std::vector<std::string>& files) {
  std::istringstream lines{std::string(log)};
  std::string line, text;
  while (std::getline(lines, line)) {
    const std::size_t end = line.find_last_not_of(" \t\r\n");
    if (end == std::string::npos) continue;
    text += fmt::format("{}{}", text.empty() ? "" : "; ", rewriteLine(line.substr(0, end + 1), files));
  }
  return text;
}

}  // namespace isolume
