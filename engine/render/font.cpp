#include "render/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <stdexcept>
#include <string>

namespace wells {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

/// Takes the first character off `text`, which must not be empty.
char32_t takeCharacter(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  if (length == 0 || length > text.size()) {
    text.remove_prefix(1);
    return kReplacement;
  }
  char32_t character = length == 1 ? lead : lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) {
      text.remove_prefix(i);
      return kReplacement;
    }
    character = (character << 6) | (byte(i) & 0x3Fu);
  }
  text.remove_prefix(length);
  return character;
}

}  // namespace

void Font::CloseLibrary::operator()(FT_LibraryRec_* library) const {
  FT_Done_FreeType(library);
}
void Font::CloseFace::operator()(FT_FaceRec_* face) const {
  FT_Done_Face(face);
}

Font::Font(int pixels) {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) throw std::runtime_error("FreeType does not start");
  library_.reset(library);
  FT_Face face = nullptr;
  if (FT_New_Face(library, WELLS_FONT_FILE, 0, &face) != 0) {
    throw std::runtime_error("cannot read the font " WELLS_FONT_FILE
                             "; Debian's package fonts-dejavu-core has it");
  }
  face_.reset(face);
  FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(pixels));
  lineHeight_ = static_cast<int>(face->size->metrics.height / 64);
  capitalHeight_ = glyph(U'H').top;
}

const Font::Glyph& Font::glyph(char32_t character) {
  const auto known = glyphs_.find(character);
  if (known != glyphs_.end()) return known->second;
  Glyph made{};
  if (FT_Load_Char(face_.get(), character, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) == 0) {
    const FT_GlyphSlot slot = face_->glyph;
    made = {slot->bitmap_left,
            slot->bitmap_top,
            static_cast<int>(slot->bitmap.width),
            static_cast<int>(slot->bitmap.rows),
            static_cast<int>((slot->advance.x + 32) / 64),
            {}};
    for (int row = 0; row < made.height; ++row) {
      const unsigned char* from = slot->bitmap.buffer + row * slot->bitmap.pitch;
      made.coverage.insert(made.coverage.end(), from, from + made.width);
    }
  }
  return glyphs_.emplace(character, std::move(made)).first->second;
}

int Font::width(std::string_view text) {
  int sum = 0;
  while (!text.empty()) sum += glyph(takeCharacter(text)).advance;
  return sum;
}

void Font::draw(Image& image, int left, int baseline, std::string_view text, Color color) {
  while (!text.empty()) {
    const Glyph& g = glyph(takeCharacter(text));
    for (int row = 0; row < g.height; ++row) {
      for (int column = 0; column < g.width; ++column) {
        const int coverage = g.coverage[std::size_t(row * g.width + column)];
        if (coverage == 0) continue;
        blendPixel(image, left + g.left + column, baseline - g.top + row, color, coverage / 255.0);
      }
    }
    left += g.advance;
  }
}

}  // namespace wells
