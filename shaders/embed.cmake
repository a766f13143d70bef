# Writes a C++ file that holds each of FILES (relative to ROOT) as a string, under its name "shaders/...".
set(text "#include \"shaders/embedded_shaders.h\"\n\nnamespace isolume {\n\n")
string(APPEND text "const std::vector<EmbeddedShader>& embeddedShaders() {\n  static const std::vector<EmbeddedShader> shaders{\n")
foreach(file IN LISTS FILES)
  # Every byte as an escape: as plain text, CMake would stumble over semicolons and brackets, and C++ over long strings.
  file(READ "${ROOT}/${file}" content HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" content "${content}")
  string(REPLACE "\\x0a" "\\x0a\"\n       \"" content "${content}")
  string(APPEND text "      {\"shaders/${file}\",\n       \"${content}\"},\n")
endforeach()
string(APPEND text "  };\n  return shaders;\n}\n\n}  // namespace isolume\n")
file(WRITE "${OUT}" "${text}")
