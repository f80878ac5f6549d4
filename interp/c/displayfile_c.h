/* Display File for C99: a display-file, retained-mode 3D graphics system (interp/c/README.md).
 *
 * A df_system is one application's system: its view, styles, segments, and what is kept from one
 * picture to the next. Functions that return int return DF_OK, or DF_ERROR after an error, whose
 * message df_error() tells; the state is then what it was before the call. Strings are UTF-8 and
 * end with a zero byte unless a length goes with them. Memory that a function hands out is the
 * system's, and stays until the next call on it.
 *
 * A system is for one call at a time. One that comes from another thread meanwhile returns DF_BUSY
 * and does nothing, and df_error() tells that thread so until its next call on the system. Other
 * messages, and memory that is handed out, are for the thread whose call it was, before another
 * thread calls. Systems are independent of each other.
 *
 * Paths are names of files; "-", by which the command means standard input and output, is an error.
 *
 * Structures begin with their own size in bytes, which the caller sets, as the DF_..._INIT macros
 * do: later versions of the library add members at the end, and take a shorter structure for one
 * whose other members are 0.
 */
#ifndef DISPLAYFILE_C_H
#define DISPLAYFILE_C_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define DF_API __attribute__((visibility("default")))
#else
#define DF_API
#endif

#ifdef __cplusplus
extern "C" {
#endif
/* NOLINTBEGIN(modernize-use-using): C has typedef alone. */

enum { DF_OK = 0, DF_ERROR = 1, DF_BUSY = 2 };

typedef struct df_system df_system;

DF_API const char* df_version(void); /* "0.1.0" */

/* Null if there is no memory. */
DF_API df_system* df_create(void);
/* Not while a call on it goes on. Null is nothing. */
DF_API void df_destroy(df_system* system);
/* Why the last call on the system returned DF_ERROR; empty if it did not. After DF_BUSY, until this
 * thread's next call on the system: that it is busy. */
DF_API const char* df_error(const df_system* system);

/* ---- User routines ------------------------------------------------------------------------------
 * By their names in drawing programs, such as "polygon-abs-3".
 */

DF_API size_t df_routines(void);
/* Null beyond the last. The arguments in words, such as "x y z"; empty if there are none. */
DF_API const char* df_routine_name(size_t routine);
DF_API const char* df_routine_arguments(size_t routine);
DF_API const char* df_routine_meaning(size_t routine); /* in sentences, with defaults in brackets */
DF_API const char* df_routine_section(size_t routine); /* what it is about, such as "View" */

/* With arguments as words: df_call(system, "set-fill-style", "solid 1 0 0"). Null is none. */
DF_API int df_call(df_system* system, const char* routine, const char* arguments);
/* With arguments that are numbers; they are taken exactly. Null if there are none. */
DF_API int df_call_numbers(df_system* system, const char* routine, const double* numbers,
                           size_t count);

/* A drawing program; the name is for messages, which begin name:line:column. What its lines did
 * before one that is wrong stays. */
DF_API int df_replay(df_system* system, const char* text, size_t length, const char* name);
DF_API int df_replay_file(df_system* system, const char* path);
/* A mesh's file, in a view that is fitted to it if no window was set. */
DF_API int df_import_mesh(df_system* system, const char* path);
/* The width over the height of the pictures that segments opened from now on are drawn as. */
DF_API int df_set_aspect_ratio(df_system* system, double aspect);

/* Many polygons, into the open segment, several times as fast as one by one. What is left out is
 * null: an array of none, for polygons that have corners, is an error. */
typedef struct {
  size_t size;            /* sizeof(df_mesh) */
  const double* vertices; /* x y z of each */
  size_t vertex_count;
  const uint32_t* corners; /* indices of vertices, polygon after polygon */
  size_t corner_count;
  const uint32_t* sides; /* of each polygon; null: three of each */
  size_t polygon_count;  /* with sides */
  const double* colours; /* red green blue in [0,1], of one for all or one each; null: as set */
  size_t colour_count;
  const int32_t* picks; /* pick identifiers, one each; null: as set */
  size_t pick_count;
  const double* normals; /* x y z, one of each vertex; null: none */
  size_t normal_count;
} df_mesh;
#define DF_MESH_INIT \
  { sizeof(df_mesh), NULL, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0 }
DF_API int df_polygons(df_system* system, const df_mesh* mesh);

/* ---- Drawing ------------------------------------------------------------------------------------
 */

/* Members that are 0 or null stand for what the application set, or what is usual. */
typedef struct {
  size_t size;              /* sizeof(df_options) */
  int width, height;        /* pixels; of a PDF, points; 512 */
  const char* method;       /* hidden-surface method: "map", "z-buffer", "franklin", ... */
  const char* scope;        /* "segment" or "all" */
  const char* precision;    /* "exact", or "roundoff=1e-9" */
  const char* hidden_lines; /* "none" or "dashed" */
  const char* device;       /* of pixels: "software" or "osmesa" */
  int background;           /* DF_BACKGROUND_... */
  double background_colour[3];
  int samples;               /* along a pixel's side: 4, or as many as fit; see df_draw */
  int threads;               /* at most: 1 */
  uint64_t most_pieces;      /* that a sort may cut polygons into */
  double most_seconds;       /* that one call may take */
  int first_row, end_row;    /* of pixels: these rows alone, from the top, as they are in the whole;
                                both 0: all */
  uint64_t most_comparisons; /* of polygons and lines with each other, that one call may make */
  uint64_t most_bytes;       /* of memory, that the tables of one operation may take */
} df_options;
enum { DF_BACKGROUND_AS_SET = 0, DF_BACKGROUND_SOLID = 1, DF_BACKGROUND_NONE = 2 };
#define DF_OPTIONS_INIT                                                                          \
  {                                                                                              \
    sizeof(df_options), 0, 0, NULL, NULL, NULL, NULL, NULL, 0, {0.0, 0.0, 0.0}, 0, 0, 0, 0.0, 0, \
        0, 0, 0                                                                                  \
  }

/* Colours are antialiased: the mean of 4 x 4 samples of a pixel unless `samples` has another
 * number, or 1 by "osmesa" and "plain-z-buffer"; ids and depth are those of the pixel's centre.
 *
 * Options may be null here as below. Into the caller's memory, top row first: rgba has room for
 * 4 * pixels bytes; ids (pick identifier of the fill seen, -1 for none) and depth (minus infinity
 * for none), if not null, for as many numbers. `pixels` is how many there is room for: it must be
 * width times height, or with rows that are said, width times so many. */
DF_API int df_draw(df_system* system, const df_options* options, size_t pixels, uint8_t* rgba,
                   int32_t* ids, double* depth);
/* The bytes of a file: "svg", "pdf", "eps", "png" or "ppm". */
DF_API int df_draw_as(df_system* system, const df_options* options, const char* format,
                      const char** bytes, size_t* length);
/* Into a file, whose extension says its format. It appears whole or not at all. */
DF_API int df_draw_file(df_system* system, const df_options* options, const char* path);

/* Every instruction of the display file, as text. */
DF_API int df_dump(df_system* system, const char** text, size_t* length);

/* What is drawn in vectors, in order, as arrays. By "depth-sort" and "bsp" all polygons from back
 * to front, also those that others hide; by "map" the visible pieces only, and so by "auto", which
 * is the map unless there are only lines to see; by a method that finds lines, the visible lines.
 */
typedef struct {
  size_t size; /* sizeof(df_pieces), set by the caller */
  size_t pieces;
  const uint8_t* kinds;       /* DF_SOLID, ... */
  const uint32_t* first;      /* of the points of each; one more at the end */
  const double* points;       /* x y z of each: x and y in [0,1], y up, larger z nearer */
  const uint8_t* sides;       /* of each point: 0 if the side that ends there is not drawn */
  const double* fills;        /* red green blue of each piece */
  const double* line_colours; /* likewise */
  const double* line_widths;  /* in pixels */
  const uint8_t* line_kinds;  /* DF_LINE_SOLID, ... */
  const int32_t* picks;       /* pick identifiers; -1: none */
  const int32_t* segments;    /* names */
  const uint8_t* cuts;        /* of each point: 1 if a line, or a drawn side, is cut there */
} df_pieces;
enum { DF_SOLID = 0, DF_HOLLOW = 1, DF_LINE = 2 };
enum { DF_LINE_SOLID = 0, DF_LINE_DASHED = 1, DF_LINE_NONE = 2 };
DF_API int df_drawn_pieces(df_system* system, const df_options* options, df_pieces* pieces);

/* What the picture with these options shows in the pixel that holds (x, y), in pixels from the upper
 * left corner; lines within `reach` pixels come before fills. */
typedef struct {
  size_t size;  /* sizeof(df_seen), set by the caller */
  int is_seen;  /* 0: nothing, and the rest means nothing */
  int kind;     /* DF_SEEN_POLYGON, ... */
  int32_t pick; /* pick identifier; -1: none */
  int segment;
  double depth; /* 0 on the back plane, 1 on the front plane */
} df_seen;
enum { DF_SEEN_POLYGON = 0, DF_SEEN_EDGE = 1, DF_SEEN_LINE = 2 };
DF_API int df_pick(df_system* system, const df_options* options, double x, double y, double reach,
                   df_seen* seen);

/* The exact item buffer, and depth if not null, by the definition of truth alone: whole numbers of
 * any length, nothing shared with the methods. Slow. Of the options width and height count. */
DF_API int df_truth(df_system* system, const df_options* options, size_t pixels, int32_t* ids,
                    double* depth);

/* How a method finds what is seen, step by step, as JSON (interp/steps/README.md): at most so many
 * steps, 0 for the usual limit. Of the options width, height and method count. */
DF_API int df_steps(df_system* system, const df_options* options, size_t most_steps,
                    const char** text, size_t* length);

/* ---- Another eye --------------------------------------------------------------------------------
 */

/* Keeps what is drawn before viewing, and all calls as a drawing program: the first call on a
 * system, except for its aspect ratio. */
DF_API int df_retain(df_system* system);

/* The view parameters, as their user routines take them. */
typedef struct {
  size_t size; /* sizeof(df_view), set by the caller */
  double reference_point[3], plane_normal[3], up[3];
  double distance;
  int is_perspective;
  double projection[3]; /* the centre of projection, or else its direction */
  double depth[2];      /* of the front and the back plane */
  int clips_front, clips_back;
  double window[4], viewport[4]; /* x_min x_max y_min y_max */
} df_view;

/* The one view in which the visible segments were drawn; DF_ERROR if there were several. */
DF_API int df_drawn_view(df_system* system, df_view* view);
/* The least x y z of what is visible and the greatest, in world coordinates; DF_ERROR if nothing
 * is. */
DF_API int df_box(df_system* system, double box[6]);
/* From now on drawing, picking, pieces, the dump and the program are what they would be if the
 * application had set that view, to the last bit; null: as it did set it. */
DF_API int df_look_from(df_system* system, const df_view* view);
/* All that was called, as a drawing program, in the view that is looked from. */
DF_API int df_program(df_system* system, const char** text, size_t* length);

/* Ends the call on the system that goes on, soon, with DF_ERROR. Any thread may call it, and a
 * signal handler. Between calls it does nothing. */
DF_API void df_stop(df_system* system);

/* NOLINTEND(modernize-use-using) */
#ifdef __cplusplus
}
#endif

#endif
