// The ways to make a context, one factory each. Each throws a GpuError that says why it cannot.
#pragma once

#include <memory>

#include "context.h"

namespace isolume {

std::unique_ptr<Context> makeOsmesaContext();
std::unique_ptr<Context> makeEglContext();

/// Loads the GL entry points of the context that has just been made current, through the backend's own look-up (two
/// backends in one process have different ones). GpuError unless it offers OpenGL 4.5.
using GlFunction = void (*)();
void loadGl(std::string_view backend, GlFunction (*lookUp)(const char* name));

}  // namespace isolume
