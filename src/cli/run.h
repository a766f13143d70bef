// The whole program behind main(): parse, run one job, turn what goes wrong into one line and an exit code.
#pragma once

namespace isolume {

/// 0 success, 1 a defect of the program itself, 2 usage, 3 input (also: too little memory for it), 4 GPU, 5 output, 6 a
/// comparison beyond its limits. After SIGINT or SIGTERM the process ends inside with 130 or 143.
int runProgram(int argc, char** argv);

}  // namespace isolume
