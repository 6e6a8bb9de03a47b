// Text into pictures, by FreeType. One line at a time, no layout beyond that.
#pragma once

#include <map>
#include <memory>
#include <string_view>
#include <vector>

#include "render/image.h"

struct FT_LibraryRec_;
struct FT_FaceRec_;

namespace wells {

class Font {
 public:
  /// DejaVu Sans, capitals and descenders together about `pixels` high. Throws std::runtime_error,
  /// naming the file, when it cannot be read.
  explicit Font(int pixels);

  /// pixels from one line's baseline to the next.
  int lineHeight() const { return lineHeight_; }
  /// pixels from the baseline to the top of capitals.
  int capitalHeight() const { return capitalHeight_; }

  /// Of UTF-8 text, pixels. What the font lacks and what is not UTF-8 shows as a box.
  int width(std::string_view text);
  /// `left` and `baseline` in pixels from the image's upper left corner.
  void draw(Image& image, int left, int baseline, std::string_view text, Color color);

 private:
  struct Glyph {
    int left, top, width, height, advance;  // pixels
    std::vector<std::uint8_t> coverage;     // 0 .. 255, rows of `width`
  };
  struct CloseLibrary {
    void operator()(FT_LibraryRec_* library) const;
  };
  struct CloseFace {
    void operator()(FT_FaceRec_* face) const;
  };

  const Glyph& glyph(char32_t character);

  std::unique_ptr<FT_LibraryRec_, CloseLibrary> library_;
  std::unique_ptr<FT_FaceRec_, CloseFace> face_;
  std::map<char32_t, Glyph> glyphs_;
  int lineHeight_ = 0;
  int capitalHeight_ = 0;
};

}  // namespace wells
