#include "src/cli/run.h"

int main(int argc, char** argv) { return isolume::runProgram(argc, argv); }
