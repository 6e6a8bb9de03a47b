// Draws the foot of the wall as a translucent rim. The wall has no top; the rim is as high as lets
// the balls behind it be seen.
#pragma once

#include "render/gl.h"

namespace wells {

class WallPass {
 public:
  WallPass();
  void draw() const;

 private:
  GLuint glassProgram_ = 0;
  GLuint edgeProgram_ = 0;
  GLuint vertexArray_ = 0;
};

}  // namespace wells
