/* What the C API promises, as a C99 program sees it: pictures, arrays, and an error for each wrong
 * call, after which the system is as it was. Prints nothing if all holds. */

#include <displayfile_c.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

#define EXPECT(condition)                                                     \
  do {                                                                        \
    if (!(condition)) {                                                       \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
      ++failures;                                                             \
    }                                                                         \
  } while (0)

/* The call must do what it is told. */
#define DO(system, call)                                                               \
  do {                                                                                 \
    if ((call) != DF_OK) {                                                             \
      fprintf(stderr, "%s:%d: %s: %s\n", __FILE__, __LINE__, #call, df_error(system)); \
      ++failures;                                                                      \
    }                                                                                  \
  } while (0)

/* The call must be refused with these words, and the display file stay. */
static void expect_refused(df_system* system, int result, const char* words, int line) {
  if (result != DF_ERROR || strstr(df_error(system), words) == NULL) {
    fprintf(stderr, "line %d: returned %d, \"%s\": expected \"%s\"\n", line, result,
            df_error(system), words);
    ++failures;
  }
}
#define REFUSED(system, call, words) expect_refused(system, call, words, __LINE__)

static char* copy_of_dump(df_system* system) {
  const char* text = NULL;
  size_t length = 0;
  char* copy;
  DO(system, df_dump(system, &text, &length));
  copy = (char*)malloc(length + 1);
  memcpy(copy, text, length + 1);
  return copy;
}

static const char kProgram[] =
    "set-line-style none\n"
    "set-window 0 1 0 1\nset-view-depth -1 0\n"
    "set-hidden-line-removal on\nset-back-face-removal off\n"
    "open-segment 1\n"
    "set-fill-style solid 1 0 0\npolygon-abs-3 0 0 0  1 0 1  1 1 1  0 1 0\n"
    "set-fill-style solid 0 0 1\npolygon-abs-3 0 0 1  1 0 0  1 1 0  0 1 1\n"
    "close-segment\n";

/* After the program: a line behind both polygons. */
static const char kLineBehind[] =
    "set-line-style solid 0 0 0 1\nopen-segment 2\n"
    "move-abs-3 0.4 0.2 0.1\nline-abs-3 0.6 0.2 0.1\nclose-segment\n";

static void test_routines(void) {
  char version[40];
  size_t i, found = 0;
  for (i = 0; i < df_routines(); ++i) {
    EXPECT(df_routine_name(i) != NULL && df_routine_arguments(i) != NULL);
    EXPECT(strlen(df_routine_meaning(i)) > 0 && strlen(df_routine_section(i)) > 0);
    if (strcmp(df_routine_name(i), "polygon-abs-3") == 0) ++found;
  }
  EXPECT(found == 1);
  EXPECT(df_routine_name(df_routines()) == NULL);
  EXPECT(df_routine_arguments((size_t)-1) == NULL);
  EXPECT(df_routine_meaning(df_routines()) == NULL && df_routine_section(df_routines()) == NULL);
  sprintf(version, "%d.%d.%d", DF_VERSION_MAJOR, DF_VERSION_MINOR, DF_VERSION_PATCH);
  EXPECT(strcmp(df_version(), version) == 0);
}

static void test_pictures(void) {
  enum { kSide = 40, kPixels = kSide * kSide };
  static uint8_t rgba[4 * kPixels];
  static int32_t ids[kPixels];
  static double depth[kPixels];
  df_options options = DF_OPTIONS_INIT;
  const char* bytes = NULL;
  size_t length = 0;
  df_seen seen = {sizeof(df_seen), 0, 0, 0, 0, 0.0};
  df_system* system = df_create();
  int k;
  DO(system, df_replay(system, kProgram, sizeof kProgram - 1, "squares.draw"));
  options.width = options.height = kSide;
  for (k = 0; k < 3; ++k) {
    static const char* const kMethods[] = {"bsp", "z-buffer", NULL};
    int x, y;
    options.method = kMethods[k];
    DO(system, df_draw(system, &options, kPixels, rgba, ids, depth));
    for (y = 0; y < kSide; ++y) {
      for (x = 0; x < kSide; ++x) {
        const int p = y * kSide + x, red = x >= kSide / 2;
        const double z = (x + 0.5) / kSide;
        EXPECT(rgba[4 * p] == (red ? 255 : 0) && rgba[4 * p + 1] == 0);
        EXPECT(rgba[4 * p + 2] == (red ? 0 : 255) && rgba[4 * p + 3] == 255);
        EXPECT(ids[p] == (red ? 0 : 1));
        EXPECT(fabs(depth[p] - (red ? z : 1.0 - z)) < 1e-9);
      }
    }
  }
  DO(system, df_draw(system, &options, kPixels, rgba, NULL, NULL));
  DO(system, df_draw_as(system, &options, "svg", &bytes, &length));
  EXPECT(length > 100 && strlen(bytes) == length && strncmp(bytes, "<", 1) == 0);
  DO(system, df_draw_as(system, &options, ".ppm", &bytes, &length));
  EXPECT(length == sizeof "P6\n40 40\n255" + 3 * kPixels);
  DO(system, df_pick(system, &options, 30.5, 20.5, 0.0, &seen));
  EXPECT(seen.is_seen == 1 && seen.kind == DF_SEEN_POLYGON && seen.pick == 0 && seen.segment == 1);
  DO(system, df_pick(system, &options, 300.0, 20.0, 0.0, &seen));
  EXPECT(seen.is_seen == 0);
  /* No options: 512 x 512. */
  REFUSED(system, df_draw(system, NULL, kPixels, rgba, NULL, NULL), "expected 262144");
  df_destroy(system);
}

/* Colours are the mean of 4 x 4 samples of a pixel unless others are set. The squares meet in the
 * middle of the picture, which is that of a column of pixels. */
static void test_samples(void) {
  enum { kSide = 13, kMiddle = kSide / 2 };
  static uint8_t usual[4 * kSide * kSide], set[4 * kSide * kSide];
  static int32_t ids[2][kSide * kSide];
  df_options options = DF_OPTIONS_INIT;
  df_system* system = df_create();
  DO(system, df_replay(system, kProgram, sizeof kProgram - 1, "squares.draw"));
  options.width = options.height = kSide;
  DO(system, df_draw(system, &options, kSide * kSide, usual, ids[0], NULL));
  EXPECT(usual[4 * kMiddle] == 128 && usual[4 * kMiddle + 2] == 128);
  EXPECT(usual[4 * (kMiddle - 1) + 2] == 255 && usual[4 * (kMiddle + 1)] == 255);
  options.samples = 4;
  DO(system, df_draw(system, &options, kSide * kSide, set, NULL, NULL));
  EXPECT(memcmp(usual, set, sizeof set) == 0);
  options.samples = 1;
  DO(system, df_draw(system, &options, kSide * kSide, set, ids[1], NULL));
  EXPECT(set[4 * kMiddle] + set[4 * kMiddle + 2] == 255 && set[4 * kMiddle] % 255 == 0);
  EXPECT(memcmp(ids[0], ids[1], sizeof ids[0]) == 0);
  df_destroy(system);
}

/* Rows of a picture, and what a call may use at most. */
static void test_rows_and_limits(void) {
  enum { kSide = 12, kRows = 3 };
  static uint8_t whole[4 * kSide * kSide], part[4 * kSide * kRows];
  df_options options = DF_OPTIONS_INIT;
  df_system* system = df_create();
  DO(system, df_replay(system, kProgram, sizeof kProgram - 1, "squares.draw"));
  options.width = options.height = kSide;
  options.method = "z-buffer";
  DO(system, df_draw(system, &options, kSide * kSide, whole, NULL, NULL));
  options.first_row = 5;
  options.end_row = 5 + kRows;
  DO(system, df_draw(system, &options, kSide * kRows, part, NULL, NULL));
  EXPECT(memcmp(part, whole + 4 * 5 * kSide, sizeof part) == 0);
  REFUSED(system, df_draw(system, &options, kSide * kSide, whole, NULL, NULL), "expected 36");
  options.first_row = -1;
  options.end_row = 2147483647;
  REFUSED(system, df_draw(system, &options, kSide, part, NULL, NULL), "room for");
  options.first_row = 8;
  options.end_row = kSide + 1;
  REFUSED(system, df_draw(system, &options, 5 * kSide, whole, NULL, NULL), "rows 8 up to 13");
  options.first_row = options.end_row = 0;
  options.method = "bsp";
  DO(system, df_call(system, "open-segment", "9"));
  DO(system, df_call(system, "sphere-3", "0 0 0 1 64"));
  DO(system, df_call(system, "close-segment", NULL));
  options.most_comparisons = 1;
  REFUSED(system, df_draw(system, &options, kSide * kSide, whole, NULL, NULL), "1 comparisons");
  options.most_comparisons = 0;
  options.most_bytes = 1;
  REFUSED(system, df_draw(system, &options, kSide * kSide, whole, NULL, NULL), "limit is 1");
  options.most_bytes = 0;
  options.most_seconds = NAN;
  REFUSED(system, df_draw(system, &options, kSide * kSide, whole, NULL, NULL), "most_seconds");
  df_destroy(system);
}

static void test_pieces(void) {
  df_options options = DF_OPTIONS_INIT;
  df_pieces pieces;
  df_system* system = df_create();
  size_t k, areas = 0;
  memset(&pieces, 0, sizeof pieces);
  pieces.size = sizeof pieces;
  DO(system, df_replay(system, kProgram, sizeof kProgram - 1, NULL));
  options.method = "map";
  DO(system, df_drawn_pieces(system, &options, &pieces));
  EXPECT(pieces.pieces == 2 && pieces.first[0] == 0 && pieces.size == sizeof pieces);
  for (k = 0; k < pieces.pieces; ++k) {
    uint32_t i;
    double area = 0.0;
    EXPECT(pieces.kinds[k] == DF_SOLID && pieces.segments[k] == 1);
    EXPECT(pieces.line_kinds[k] == DF_LINE_NONE);
    EXPECT(pieces.fills[3 * k] == (pieces.picks[k] == 0 ? 1.0 : 0.0));
    for (i = pieces.first[k]; i < pieces.first[k + 1]; ++i) {
      const uint32_t next = i + 1 < pieces.first[k + 1] ? i + 1 : pieces.first[k];
      const double *p = &pieces.points[3 * i], *q = &pieces.points[3 * next];
      area += p[0] * q[1] - q[0] * p[1];
    }
    if (fabs(area) == 1.0) ++areas; /* twice a half */
  }
  EXPECT(areas == 2);
  options.method = "depth-sort";
  DO(system, df_drawn_pieces(system, &options, &pieces));
  EXPECT(pieces.pieces == 3);
  options.method = "franklin";
  DO(system, df_drawn_pieces(system, &options, &pieces));
  EXPECT(pieces.pieces == 0); /* no line style */
  DO(system, df_replay(system, kLineBehind, sizeof kLineBehind - 1, NULL));
  options.method = "none";
  DO(system, df_drawn_pieces(system, &options, &pieces));
  EXPECT(pieces.pieces == 3);
  options.hidden_lines = "dashed";
  REFUSED(system, df_drawn_pieces(system, &options, &pieces), "which 'none' does not");
  options.method = "map";
  DO(system, df_drawn_pieces(system, &options, &pieces));
  EXPECT(pieces.pieces == 3);
  for (k = 0; k < pieces.first[3]; ++k) EXPECT(pieces.cuts[k] == 0); /* the line is all hidden */
  df_destroy(system);
}

/* The font of texts, and letters as strokes or outlines where fonts are installed. */
static void test_lettering(void) {
  static const char kText[] = "open-segment 1\nmove-abs-2 0 0\ntext \"I\"\nclose-segment\n";
  df_options options = DF_OPTIONS_INIT;
  const char* bytes = NULL;
  size_t length = 0;
  df_system* system = df_create();
  DO(system, df_replay(system, kText, sizeof kText - 1, NULL));
  DO(system, df_draw_as(system, &options, "svg", &bytes, &length));
  EXPECT(strstr(bytes, "font-family:sans-serif;") != NULL && strstr(bytes, "<text") != NULL);
  options.font = "DejaVu Serif";
  DO(system, df_draw_as(system, &options, "svg", &bytes, &length));
  EXPECT(strstr(bytes, "font-family:'DejaVu Serif',sans-serif;") != NULL);
  options.text = "lines";
  REFUSED(system, df_draw_as(system, &options, "svg", &bytes, &length),
          "text 'lines': expected text or outlines");
  options.text = NULL;
  options.font = "";
  REFUSED(system, df_draw_as(system, &options, "svg", &bytes, &length), "font ''");
  options.font = "a;b";
  REFUSED(system, df_draw_as(system, &options, "svg", &bytes, &length), "font 'a;b'");
  options.font = "hershey";
  if (df_draw_as(system, &options, "svg", &bytes, &length) == DF_OK) {
    EXPECT(strstr(bytes, "<text") == NULL);
    options.text = "outlines";
    REFUSED(system, df_draw_as(system, &options, "svg", &bytes, &length), "have no outlines");
  } else {
    EXPECT(strstr(df_error(system), "hershey-fonts-data") != NULL);
  }
  options.font = NULL;
  options.text = "outlines";
  if (df_draw_as(system, &options, "svg", &bytes, &length) == DF_OK) {
    EXPECT(strstr(bytes, "<text") == NULL);
  } else {
    EXPECT(strstr(df_error(system), "Cairo") != NULL);
  }
  df_destroy(system);
}

static void test_meshes(void) {
  static const double kVertices[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 1};
  static const uint32_t kCorners[] = {0, 1, 2, 3, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  static const uint32_t kSides[] = {4, 3, 3, 3, 3};
  static const double kColours[] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 0, 1, 1};
  static const int32_t kPicks[] = {10, 11, 12, 13, 14};
  static const double kNormals[] = {0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, 1};
  static const uint32_t kOutside[] = {0, 1, 5};
  df_mesh mesh = DF_MESH_INIT;
  df_pieces pieces;
  df_system* system = df_create();
  char *before, *after;
  double infinite[15];
  memset(&pieces, 0, sizeof pieces);
  pieces.size = sizeof pieces;
  mesh.vertices = kVertices;
  mesh.vertex_count = 5;
  mesh.corners = kCorners;
  mesh.corner_count = 16;
  mesh.sides = kSides;
  mesh.polygon_count = 5;
  REFUSED(system, df_polygons(system, &mesh), "no segment open");
  REFUSED(system, df_call(system, "set-line-kind-style", "creese 1"), "did you mean 'crease'?");
  DO(system, df_call(system, "set-line-kind-style", "hidden 0.5 dashed 2 1"));
  REFUSED(system, df_call(system, "leader-3", "0 0 0 \"a\""), "no segment open");
  DO(system, df_call(system, "set-annotation-size", "2.5 mm"));
  DO(system, df_call(system, "set-line-style", "none"));
  DO(system, df_call(system, "set-hidden-line-removal", "off"));
  DO(system, df_call(system, "open-segment", "4"));
  mesh.colours = kColours;
  mesh.colour_count = 5;
  mesh.picks = kPicks;
  mesh.pick_count = 5;
  DO(system, df_polygons(system, &mesh));
  DO(system, df_drawn_pieces(system, NULL, &pieces));
  EXPECT(pieces.pieces == 5 && pieces.picks[4] == 14 && pieces.fills[3 * 3] == 1.0);
  before = copy_of_dump(system);

  mesh.size = 4;
  REFUSED(system, df_polygons(system, &mesh), "df_mesh: size 4");
  mesh.size = sizeof mesh;
  REFUSED(system, df_polygons(system, NULL), "df_mesh: expected it, not null");
  mesh.vertices = NULL;
  REFUSED(system, df_polygons(system, &mesh), "the vertices: expected it, not null");
  mesh.vertices = kVertices;
  mesh.corners = kOutside;
  mesh.corner_count = 3;
  mesh.sides = NULL;
  REFUSED(system, df_polygons(system, &mesh), "corner 2: vertex 5: there are 5 vertices: expected 0 to 4");
  mesh.corners = kCorners;
  mesh.corner_count = 16;
  REFUSED(system, df_polygons(system, &mesh), "16 corners");
  mesh.sides = kSides;
  mesh.pick_count = 4;
  REFUSED(system, df_polygons(system, &mesh), "4 pick identifiers of 5 polygons");
  mesh.pick_count = 5;
  mesh.colour_count = 2;
  REFUSED(system, df_polygons(system, &mesh), "2 fill styles of 5 polygons");
  mesh.colour_count = 1;
  mesh.normals = kNormals;
  mesh.normal_count = 2;
  REFUSED(system, df_polygons(system, &mesh), "2 normals of 5 vertices");
  mesh.normal_count = 0;
  REFUSED(system, df_polygons(system, &mesh), "the normals: an empty array");
  mesh.normal_count = 5;
  mesh.colour_count = 0;
  REFUSED(system, df_polygons(system, &mesh), "the colours: an empty array");
  mesh.colour_count = 1;
  mesh.pick_count = 0;
  REFUSED(system, df_polygons(system, &mesh), "the pick identifiers: an empty array");
  mesh.picks = NULL;
  mesh.polygon_count = 0;
  mesh.corner_count = 3;
  REFUSED(system, df_polygons(system, &mesh), "the sides: an empty array");
  mesh.corner_count = 0;
  DO(system, df_polygons(system, &mesh)); /* no polygons */
  mesh.corner_count = 16;
  mesh.polygon_count = 5;
  mesh.picks = kPicks;
  mesh.pick_count = 5;
  memcpy(infinite, kVertices, sizeof infinite);
  infinite[7] = HUGE_VAL;
  mesh.vertices = infinite;
  REFUSED(system, df_polygons(system, &mesh), "inf");
  mesh.vertices = kVertices;
  after = copy_of_dump(system);
  EXPECT(strcmp(before, after) == 0);
  free(before);
  free(after);
  DO(system, df_polygons(system, &mesh));
  DO(system, df_drawn_pieces(system, NULL, &pieces));
  EXPECT(pieces.pieces == 10);
  df_destroy(system);
}

static void test_errors(void) {
  static uint8_t rgba[4];
  static const double kNumbers[] = {0.1, 0.2, 0.3};
  double not_a_number[3] = {0.0, 0.0, 0.0};
  struct {
    df_options options;
    int later;
  } newer;
  df_options options = DF_OPTIONS_INIT;
  df_pieces pieces;
  df_seen seen = {0, 0, 0, 0, 0, 0.0};
  const char* bytes = NULL;
  size_t length = 0;
  char *before, *after;
  df_system* system = df_create();
  EXPECT(strcmp(df_error(system), "") == 0);
  EXPECT(strcmp(df_error(NULL), "") != 0);
  EXPECT(df_call(NULL, "open-segment", "1") == DF_ERROR);
  EXPECT(df_draw(NULL, NULL, 0, NULL, NULL, NULL) == DF_ERROR);
  df_destroy(NULL);
  df_stop(NULL);
  df_stop(system); /* between calls: nothing */
  DO(system, df_replay(system, kProgram, sizeof kProgram - 1, "squares.draw"));
  before = copy_of_dump(system);

  REFUSED(system, df_call(system, NULL, ""), "the routine's name");
  REFUSED(system, df_call(system, "fly-3", "1 2 3"), "unknown routine 'fly-3'");
  REFUSED(system, df_call(system, "move-abs-3", NULL), "0 arguments, expected 3");
  REFUSED(system, df_call(system, "open-segment", "1"), "in use");
  REFUSED(system, df_call(system, "close-segment", NULL), "no segment open");
  REFUSED(system, df_call_numbers(system, "line-abs-3", kNumbers, 3), "no segment open");
  REFUSED(system, df_call_numbers(system, "line-abs-3", kNumbers, 2), "2 arguments, expected 3");
  REFUSED(system, df_call_numbers(system, "line-abs-3", NULL, 3), "the numbers");
  not_a_number[1] = NAN;
  REFUSED(system, df_call_numbers(system, "move-abs-3", not_a_number, 3), "finite");
  REFUSED(system, df_replay(system, "open-segment x", 14, "a.draw"), "a.draw:1:14: ");
  REFUSED(system, df_replay(system, NULL, 3, "a.draw"), "the drawing program");
  REFUSED(system, df_replay_file(system, "/no/such/file.draw"), "/no/such/file.draw");
  REFUSED(system, df_replay_file(system, NULL), "the path");
  REFUSED(system, df_import_mesh(system, "/no/such/file.obj"), "/no/such/file.obj");
  REFUSED(system, df_replay_file(system, "-"), "the path: -: expected a file's name");
  REFUSED(system, df_import_mesh(system, "-"), "the path: -: expected a file's name");
  REFUSED(system, df_draw_file(system, NULL, "-"), "the path: -: expected a file's name");
  REFUSED(system, df_set_aspect_ratio(system, -1.0), "aspect");

  options.width = options.height = 1;
  REFUSED(system, df_draw(system, &options, 1, NULL, NULL, NULL), "the pixels' memory");
  options.method = "magic";
  REFUSED(system, df_draw(system, &options, 1, rgba, NULL, NULL), "'magic'");
  options.method = NULL;
  options.precision = "roughly";
  REFUSED(system, df_draw(system, &options, 1, rgba, NULL, NULL), "'roughly'");
  options.precision = NULL;
  options.background = 7;
  REFUSED(system, df_draw(system, &options, 1, rgba, NULL, NULL), "background 7");
  options.background = DF_BACKGROUND_SOLID;
  options.background_colour[2] = 1.5;
  REFUSED(system, df_draw(system, &options, 1, rgba, NULL, NULL), "1.5");
  options.background = DF_BACKGROUND_AS_SET;
  options.width = -3;
  REFUSED(system, df_draw(system, &options, 1, rgba, NULL, NULL), "expected");
  options.width = 1;
  options.samples = 1000;
  REFUSED(system, df_draw(system, &options, 1, rgba, NULL, NULL), "1000 samples");
  options.samples = 0;
  options.most_seconds = -1.0;
  REFUSED(system, df_draw(system, &options, 1, rgba, NULL, NULL), "most_seconds");
  options.most_seconds = 0.0;
  options.size = 1;
  REFUSED(system, df_draw(system, &options, 1, rgba, NULL, NULL), "df_options: size 1");
  options.size = offsetof(df_options, method) + 3; /* half a pointer */
  REFUSED(system, df_draw(system, &options, 1, rgba, NULL, NULL), "df_options: size");
  options.size = sizeof options;
  DO(system, df_draw(system, &options, 1, rgba, NULL, NULL));

  /* A caller of a later version: what it says must be known. */
  memset(&newer, 0, sizeof newer);
  newer.options = options;
  newer.options.size = sizeof newer;
  DO(system, df_draw(system, &newer.options, 1, rgba, NULL, NULL));
  newer.later = 1;
  REFUSED(system, df_draw(system, &newer.options, 1, rgba, NULL, NULL), "larger than version");
  /* One of an earlier version: only the picture's size. */
  options.size = offsetof(df_options, method);
  options.method = "magic";
  DO(system, df_draw(system, &options, 1, rgba, NULL, NULL));
  options.size = sizeof options;
  options.method = NULL;

  REFUSED(system, df_draw_as(system, NULL, NULL, &bytes, &length), "the format");
  REFUSED(system, df_draw_as(system, NULL, "gif", &bytes, &length), "expected one of");
  REFUSED(system, df_draw_as(system, NULL, "svg", NULL, &length), "the pointer to the bytes");
  REFUSED(system, df_draw_as(system, NULL, "svg", &bytes, NULL), "where the length goes");
  REFUSED(system, df_draw_file(system, NULL, "/no/such/folder/a.png"), "no folder");
  REFUSED(system, df_dump(system, NULL, NULL), "where the text goes");
  REFUSED(system, df_drawn_pieces(system, NULL, NULL), "df_pieces");
  memset(&pieces, 0, sizeof pieces);
  REFUSED(system, df_drawn_pieces(system, NULL, &pieces), "df_pieces: size 0");
  REFUSED(system, df_pick(system, NULL, 1, 1, 0, NULL), "df_seen");
  REFUSED(system, df_pick(system, NULL, 1, 1, 0, &seen), "df_seen: size 0");
  after = copy_of_dump(system);
  EXPECT(strcmp(before, after) == 0);
  EXPECT(strcmp(df_error(system), "") == 0);
  free(before);
  free(after);
  df_destroy(system);
}

/* Draws the same with both, and expects the same pixels, and the same SVG. */
static void expect_same_pictures(df_system* a, df_system* b) {
  enum { PIXELS = 40 * 30 };
  static uint8_t rgba[2][4 * PIXELS];
  static int32_t ids[2][PIXELS];
  static const char* const methods[] = {"z-buffer", "bsp", "map", "franklin"};
  size_t k;
  for (k = 0; k < sizeof methods / sizeof methods[0]; ++k) {
    df_options options = DF_OPTIONS_INIT;
    const int is_of_lines = strcmp(methods[k], "franklin") == 0;
    const char *svg, *other_svg;
    size_t length, other_length;
    options.width = 40;
    options.height = 30;
    options.method = methods[k];
    DO(a, df_draw(a, &options, PIXELS, rgba[0], is_of_lines ? NULL : ids[0], NULL));
    DO(b, df_draw(b, &options, PIXELS, rgba[1], is_of_lines ? NULL : ids[1], NULL));
    EXPECT(memcmp(rgba[0], rgba[1], sizeof rgba[0]) == 0);
    EXPECT(memcmp(ids[0], ids[1], sizeof ids[0]) == 0);
    DO(a, df_draw_as(a, &options, "svg", &svg, &length));
    DO(b, df_draw_as(b, &options, "svg", &other_svg, &other_length));
    EXPECT(length == other_length && memcmp(svg, other_svg, length) == 0);
  }
}

static void test_another_eye(void) {
  static const char program[] =
      "set-perspective 3 2 6\nset-fill-style solid 1 0 0\nopen-segment 1\n"
      "polygon-abs-3 -0.5 -0.5 0  0.5 -0.5 0  0 0.5 0\nset-fill-style solid 0 0 1\n"
      "polygon-abs-3 0 -0.5 -0.5  0 -0.5 0.5  0 0.5 0\nclose-segment\n";
  df_system* system = df_create();
  df_system* other = df_create();
  df_view view, turned;
  double box[6];
  int32_t truth[12], ids[12];
  uint8_t rgba[48];
  df_options options = DF_OPTIONS_INIT;
  const char* text;
  size_t length;

  memset(&view, 0, sizeof view);
  view.size = sizeof view;
  REFUSED(system, df_drawn_view(system, &view), "df_retain");
  REFUSED(system, df_look_from(system, &view), "df_retain");
  REFUSED(system, df_box(system, box), "df_retain");
  REFUSED(system, df_program(system, &text, &length), "df_retain");
  DO(other, df_call(other, "set-pick-id", "7"));
  REFUSED(other, df_retain(other), "before all of them");
  df_destroy(other);
  other = df_create();

  DO(system, df_set_aspect_ratio(system, 1.5));
  DO(system, df_retain(system));
  DO(system, df_retain(system));
  REFUSED(system, df_box(system, box), "nothing is visible");
  DO(system, df_replay(system, program, strlen(program), "test"));
  DO(system, df_box(system, box));
  EXPECT(box[0] == -0.5 && box[1] == -0.5 && box[2] == -0.5);
  EXPECT(box[3] == 0.5 && box[4] == 0.5 && box[5] == 0.5);
  DO(system, df_drawn_view(system, &view));
  EXPECT(view.is_perspective && view.projection[0] == 3.0 && view.projection[2] == 6.0);

  /* From there, what a program in that view draws. */
  turned = view;
  turned.projection[0] = -2.0;
  turned.window[0] = -1.5;
  DO(system, df_look_from(system, &turned));
  DO(system, df_program(system, &text, &length));
  DO(other, df_replay(other, text, length, "turned"));
  expect_same_pictures(system, other);
  DO(system, df_call(system, "set-visibility", "1 off"));
  DO(other, df_call(other, "set-visibility", "1 off"));
  expect_same_pictures(system, other);
  DO(system, df_call(system, "set-visibility", "1 on"));
  DO(system, df_look_from(system, NULL));

  /* A view that does not fit together changes nothing. */
  turned.up[0] = turned.up[1] = 0.0;
  turned.up[2] = 1.0;
  REFUSED(system, df_look_from(system, &turned), "");
  turned.up[2] = 0.0;
  REFUSED(system, df_look_from(system, &turned), "");
  turned.size = 3;
  REFUSED(system, df_look_from(system, &turned), "df_view: size 3");
  REFUSED(system, df_drawn_view(system, NULL), "df_view");
  REFUSED(system, df_box(system, NULL), "the box");

  options.width = 4;
  options.height = 3;
  DO(system, df_draw(system, &options, 12, rgba, ids, NULL));
  if (df_truth(system, &options, 12, truth, NULL) == DF_OK) {
    EXPECT(memcmp(truth, ids, sizeof ids) == 0);
    REFUSED(system, df_truth(system, &options, 11, truth, NULL), "room for 11 pixels");
    REFUSED(system, df_truth(system, &options, 12, NULL, NULL), "the item buffer's memory");
  } else {
    EXPECT(strstr(df_error(system), "GMP") != NULL);
  }

  options.method = "bsp";
  DO(system, df_steps(system, &options, 0, &text, &length));
  EXPECT(length > 0 && text[0] == '{');
  REFUSED(system, df_steps(system, &options, 1, &text, &length), "steps");
  REFUSED(system, df_steps(system, &options, 0, NULL, &length), "where the text goes");
  options.method = "none";
  REFUSED(system, df_steps(system, &options, 0, &text, &length), "expected");
  REFUSED(system, df_steps(system, NULL, 0, &text, &length), "expected one with steps");

  /* Several views are not one. */
  DO(system, df_call(system, "set-window", "-2 2 -2 2"));
  DO(system, df_call(system, "open-segment", "2"));
  DO(system, df_call(system, "polygon-abs-3", "0 0 0  1 0 0  0 1 0"));
  DO(system, df_call(system, "close-segment", NULL));
  REFUSED(system, df_drawn_view(system, &view), "different views");
  REFUSED(system, df_look_from(system, &view), "different views");
  df_destroy(other);
  df_destroy(system);
}

int main(int argc, char** argv) {
  if (argc == 4) { /* PROGRAM METHOD OUTPUT: draws it */
    df_options options = DF_OPTIONS_INIT;
    df_system* system = df_create();
    options.width = options.height = 200;
    options.method = argv[2];
    DO(system, df_replay_file(system, argv[1]));
    DO(system, df_draw_file(system, &options, argv[3]));
    df_destroy(system);
    return failures == 0 ? 0 : 1;
  }
  test_routines();
  test_pictures();
  test_samples();
  test_rows_and_limits();
  test_pieces();
  test_lettering();
  test_meshes();
  test_another_eye();
  test_errors();
  return failures == 0 ? 0 : 1;
}
