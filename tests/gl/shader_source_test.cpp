#include "raymarch/shader_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "raymarch/context.h"
#include "raymarch/gpu_error.h"
#include "raymarch/program.h"

namespace isolume {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

ShaderLookup fromMap(std::map<std::string, std::string, std::less<>> files) {
  return [files = std::move(files)](std::string_view name) -> std::string_view {
    const auto found = files.find(name);
    return found == files.end() ? std::string_view() : std::string_view(found->second);
  };
}

TEST(ShaderSource, IncludesOnceAndKeepsLineNumbers) {
  // A file included twice appears once, and #line directives number every file by its own lines.
  const ShaderSource source = resolveIncludes(
      "shaders/a.frag", fromMap({{"shaders/a.frag", "one\n#include \"b.glsl\"\n#include \"c.glsl\"\nfour\n"},
                                 {"shaders/b.glsl", "b1\n#include \"c.glsl\"\nb3\n"},
                                 {"shaders/c.glsl", "c1\n"}}));
  EXPECT_EQ(source.text, "one\n#line 10001\nb1\n#line 20001\nc1\n#line 10003\nb3\n#line 3\n\nfour\n");
  EXPECT_THAT(source.files, ::testing::ElementsAre("shaders/a.frag", "shaders/b.glsl", "shaders/c.glsl"));
}

TEST(ShaderSource, MissingIncludeNamesBothFiles) {
  // A wrong include tells where it stands.
  try {
    resolveIncludes("shaders/a.frag", fromMap({{"shaders/a.frag", "one\n#include \"gone.glsl\"\n"}}));
    FAIL() << "no error";
  } catch (const GpuError& error) {
    EXPECT_STREQ(error.what(), "shaders/a.frag:2: shaders/gone.glsl: no such shader file");
  }
}

TEST(ShaderSource, RewritesTheLogsOfAllDrivers) {
  // The three forms in which drivers name a position become file and line; other lines stay.
  const std::vector<std::string> files{"shaders/a.frag", "shaders/b.glsl"};
  EXPECT_EQ(rewriteLog("0:10042(7): error: no\n", files), "shaders/b.glsl:42: error: no");
  EXPECT_EQ(rewriteLog("0(42) : error C0000: no\n", files), "shaders/a.frag:42: error C0000: no");
  EXPECT_EQ(rewriteLog("ERROR: 0:10042: 'x' : no\nERROR: 1 compilation error\n\n", files),
            "shaders/b.glsl:42: 'x' : no; ERROR: 1 compilation error");
}

// The real sources with one line of one file replaced.
struct BrokenShader {
  std::string file, text;
  int line;  // of the mistake
  BrokenShader(std::string name, const std::string& original, const std::string& replacement)
      : file(std::move(name)), text(embeddedShader(file)) {
    const std::size_t at = text.find(original);
    EXPECT_NE(at, std::string::npos) << file << " no longer contains: " << original;
    line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    text.replace(at, original.size(), replacement);
  }
  std::string message() const {
    try {
      buildProgram("shaders/fullscreen.vert", "shaders/march_octants.frag", [this](std::string_view name) {
        return name == file ? std::string_view(text) : embeddedShader(name);
      });
    } catch (const GpuError& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST(ShaderSource, BrokenShaderReportsFileAndLine) {
  // A mistake in the shader itself and one in an included file are reported at their own file and line, in one line.
  const auto context = makeContext("osmesa");
  const BrokenShader main("shaders/march/main.glsl", "Hit hit = trace(ray);", "Hit hit = undeclared(ray);");
  EXPECT_THAT(main.message(), StartsWith("shaders/march/main.glsl:" + std::to_string(main.line) + ": error"));
  EXPECT_THAT(main.message(), HasSubstr("undeclared"));
  EXPECT_THAT(main.message(), ::testing::Not(HasSubstr("\n")));
  const BrokenShader included("shaders/lib/cell_cubic.glsl", "float low = bracket.low;", "float low = bracket.lowest;");
  EXPECT_THAT(included.message(),
              StartsWith("shaders/lib/cell_cubic.glsl:" + std::to_string(included.line) + ": error"));
}

}  // namespace
}  // namespace isolume
