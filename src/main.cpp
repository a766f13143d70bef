#include <cstdio>
#include <cstdlib>

#include "src/cli/run.h"

int main(int argc, char** argv) {
  const int code = isolume::runProgram(argc, argv);
  // A job that fails early ends while a thread may still be loading the image codec's libraries. Running destructors of
  // libraries beside that crashes; everything of ours is closed by now.
  std::fflush(nullptr);
  std::_Exit(code);
}
