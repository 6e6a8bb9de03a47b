// OpenGL as libOSMesa exports it. Only this folder's sources include it.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
// After osmesa.h, which sets up the calling convention.
#include <GL/glext.h>
