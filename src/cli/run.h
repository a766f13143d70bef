// The whole program behind main(): parse, run one job, turn what goes wrong into one line and an exit code.
#pragma once

#include <functional>
#include <string>

namespace isolume {

/// 0 success, 1 a defect of the program itself, 2 usage, 3 input (also: too little memory for it), 4 GPU, 5 output, 6 a
/// comparison beyond its limits. After SIGINT or SIGTERM the process ends inside with 130 or 143.
int runProgram(int argc, char** argv);

/// What runProgram() makes of errors, for any program: work()'s exit code, or one line `NAME: error: ...` on standard
/// error and the code of the exception that it threw.
int runReporting(const std::string& name, const std::function<int()>& work);

}  // namespace isolume
