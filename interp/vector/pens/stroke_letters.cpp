#include "interp/vector/pens/stroke_letters.h"

#include <algorithm>
#include <array>

#include "displayfile/text/characters.h"

namespace displayfile {

namespace {

/// A character's strokes, with blanks between them: each point is x, 0 to 4, and y, 2 on the base
/// line, 6 on top of small letters, 8 on top of capitals.
struct Glyph {
  std::string_view character;
  std::string_view strokes;
};

constexpr std::string_view kBox = "0208383202";
constexpr auto kGlyphs = std::to_array<Glyph>({
    {"0", "123243473818070312"},
    {"1", "072822 1232"},
    {"2", "07183847460242"},
    {"3", "07183847463515 354443321203"},
    {"4", "32380444"},
    {"5", "480805354443321203"},
    {"6", "473818070312324344351504"},
    {"7", "084812"},
    {"8", "15060718384746351504031232434435"},
    {"9", "031232434738180706153546"},
    {"A", "022842 1434"},
    {"B", "02083847463505 3544433202"},
    {"C", "4738180703123243"},
    {"D", "02082847432202"},
    {"E", "48080242 0535"},
    {"F", "480802 0535"},
    {"G", "47381807031232434525"},
    {"H", "0802 4842 0545"},
    {"I", "0802"},
    {"J", "3833221203"},
    {"K", "0802 4804 1542"},
    {"L", "080242"},
    {"M", "0208254842"},
    {"N", "02084248"},
    {"O", "123243473818070312"},
    {"P", "02083847463505"},
    {"Q", "123243473818070312 2442"},
    {"R", "02083847463505 2542"},
    {"S", "473818070615354443321203"},
    {"T", "0848 2822"},
    {"U", "080312324348"},
    {"V", "082248"},
    {"W", "0812253248"},
    {"X", "0248 0842"},
    {"Y", "082548 2522"},
    {"Z", "08480242"},
    {"a", "16263532 341403122233"},
    {"b", "08022233352606"},
    {"c", "3526160503122233"},
    {"d", "38321203051636"},
    {"e", "04343526160503122233"},
    {"f", "28181712 0626"},
    {"g", "3631201001 361605031232"},
    {"h", "0802 0516263532"},
    {"i", "0602 0708"},
    {"j", "161100 1718"},
    {"k", "0802 3604 1432"},
    {"l", "080312"},
    {"m", "0206 05162522 25364542"},
    {"n", "0206 0516263532"},
    {"o", "122233352616050312"},
    {"p", "00062635332202"},
    {"q", "30361605031232"},
    {"r", "0206 051626"},
    {"s", "35261605142433221203"},
    {"t", "18132232 0626"},
    {"u", "0603122233 3632"},
    {"v", "061226"},
    {"w", "0612253246"},
    {"x", "0236 0632"},
    {"y", "06031232 36312010"},
    {"z", "06360232"},
    {".", "0203"},
    {",", "131201"},
    {"-", "0535"},
    {"+", "0545 2723"},
    {"/", "0238"},
    {"(", "18060412"},
    {")", "08161402"},
    {":", "0203 0506"},
    {"'", "0806"},
    {"\"", "0806 2826"},
    {"=", "0434 0636"},
    {"_", "0242"},
    {"?", "07182837361514 1312"},
    {"!", "0804 0302"},
    {"\u00d7", "1335 1533"},
    {"\u00b0", "0716271807"},
    {"\u00d8", "123243473818070312 0248"},
    {"\u2212", "0535"},
});

constexpr double kHeight = 6.0;  // of capitals, in the unit of the table
constexpr double kAcross = 0.9 / kHeight, kGap = 1.6, kBlank = 2.5;

}  // namespace

StrokeLetters stroke_letters(std::string_view characters) {
  StrokeLetters letters;
  double start = 0.0;
  while (!characters.empty()) {
    const std::string_view character =
        characters.substr(0, std::max<std::size_t>(1, utf8_length(characters)));
    characters.remove_prefix(character.size());
    if (character == " ") {
      start += kBlank;
      continue;
    }
    const auto glyph = std::ranges::find(kGlyphs, character, &Glyph::character);
    const std::string_view strokes = glyph == kGlyphs.end() ? kBox : glyph->strokes;
    double widest = 0.0;
    bool is_down = false;
    Point2 pen(0.0);
    for (std::size_t i = 0; i < strokes.size();) {
      if (strokes[i] == ' ') {
        is_down = false;
        ++i;
        continue;
      }
      const double x = strokes[i] - '0', y = strokes[i + 1] - '0';
      const Point2 to(kAcross * (start + x), (y - 2.0) / kHeight);
      if (is_down) letters.strokes.emplace_back(pen, to);
      pen = to;
      is_down = true;
      widest = std::max(widest, x);
      i += 2;
    }
    letters.width = kAcross * (start + widest);
    start += widest + kGap;
  }
  return letters;
}

}  // namespace displayfile
