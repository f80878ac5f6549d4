/* Display File for C99: a display-file, retained-mode 3D graphics system (interp/c/README.md).
 *
 * A df_system is one application's system: its view, styles, segments, and data cached between
 * pictures. Functions that return int return DF_OK, or DF_ERROR after an error, with a message in
 * df_error(); the state is then what it was before the call. Strings are UTF-8 and end with a zero
 * byte unless passed with a length. The system owns all memory that a function returns; it is valid
 * until the next call on the system.
 *
 * A system accepts one call at a time. A concurrent call from another thread returns DF_BUSY and
 * has no effect; df_error() reports this to that thread until its next call on the system. All
 * other messages and returned memory are for the thread that made the call, until another thread
 * calls. Systems are independent of each other.
 *
 * Paths are names of files; "-", the command's standard input and output, is an error.
 *
 * Structures begin with their size in bytes, set by the caller or a DF_..._INIT macro: later
 * versions of the library add members at the end and treat those missing from a shorter structure
 * as 0.
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

/* The version of this header, and that of the library at run time, such as "1.2.3". */
#define DF_VERSION_MAJOR 0
#define DF_VERSION_MINOR 2
#define DF_VERSION_PATCH 0
DF_API const char* df_version(void);

/* Returns null if out of memory. */
DF_API df_system* df_create(void);
/* Must not be called during another call on the system. Null has no effect. */
DF_API void df_destroy(df_system* system);
/* The message of the last call on the system if it returned DF_ERROR, otherwise empty. After
 * DF_BUSY, until this thread's next call on the system: that it is busy. */
DF_API const char* df_error(const df_system* system);

/* ---- User routines ------------------------------------------------------------------------------
 * By their names in drawing programs, such as "polygon-abs-3".
 */

DF_API size_t df_routines(void);
/* Null if out of range. The arguments in words, such as "x y z"; empty if there are none. */
DF_API const char* df_routine_name(size_t routine);
DF_API const char* df_routine_arguments(size_t routine);
DF_API const char* df_routine_meaning(size_t routine); /* in sentences, with defaults in brackets */
DF_API const char* df_routine_section(size_t routine); /* the topic, such as "View" */

/* Arguments as words: df_call(system, "set-fill-style", "solid 1 0 0"). Null: none. */
DF_API int df_call(df_system* system, const char* routine, const char* arguments);
/* Arguments as numbers, used exactly. Null: none. */
DF_API int df_call_numbers(df_system* system, const char* routine, const double* numbers,
                           size_t count);

/* Runs a drawing program. Messages begin name:line:column. Lines before an error keep their
 * effect. */
DF_API int df_replay(df_system* system, const char* text, size_t length, const char* name);
DF_API int df_replay_file(df_system* system, const char* path);
/* Enters a mesh from a file, in a view fitted to it if no window was set. */
DF_API int df_import_mesh(df_system* system, const char* path);
/* Width over height of the pictures in which segments opened from now on are drawn. */
DF_API int df_set_aspect_ratio(df_system* system, double aspect);

/* Many polygons for the open segment, several times as fast as one by one. Unused arrays are null;
 * a non-null empty array, for polygons that have corners, is an error. */
typedef struct {
  size_t size;            /* sizeof(df_mesh) */
  const double* vertices; /* x y z of each */
  size_t vertex_count;
  const uint32_t* corners; /* indices of vertices, polygon after polygon */
  size_t corner_count;
  const uint32_t* sides; /* per polygon; null: three each */
  size_t polygon_count;  /* with sides */
  const double* colours; /* red green blue in [0,1], one for all or per polygon; null: as set */
  size_t colour_count;
  const int32_t* picks; /* pick identifiers, one per polygon; null: as set */
  size_t pick_count;
  const double* normals; /* x y z, one per vertex; null: none */
  size_t normal_count;
} df_mesh;
#define DF_MESH_INIT \
  { sizeof(df_mesh), NULL, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0 }
DF_API int df_polygons(df_system* system, const df_mesh* mesh);

/* ---- Drawing ------------------------------------------------------------------------------------
 */

/* Members that are 0 or null stand for the application's setting or the default. */
typedef struct {
  size_t size;              /* sizeof(df_options) */
  int width, height;        /* pixels; of a PDF, points; 512 */
  const char* method;       /* hidden-surface method: "map", "z-buffer", "franklin", ... */
  const char* scope;        /* "segment" or "all" */
  const char* precision;    /* "exact", or "roundoff=1e-9" */
  const char* hidden_lines; /* "none" or "dashed" */
  const char* device;       /* for pixels: "software" or "osmesa" */
  int background;           /* DF_BACKGROUND_... */
  double background_colour[3];
  int samples;               /* per pixel side; default 4, or as many as fit; see df_draw */
  int threads;               /* maximum; default 1 */
  uint64_t most_pieces;      /* limit on pieces into which a sort cuts polygons */
  double most_seconds;       /* limit on the time of one call */
  int first_row, end_row;    /* for pixels: draw only these rows of the picture, from the top;
                                both 0: all */
  uint64_t most_comparisons; /* limit on comparisons of polygons and lines in one call */
  uint64_t most_bytes;       /* limit on the memory of one operation's tables */
} df_options;
enum { DF_BACKGROUND_AS_SET = 0, DF_BACKGROUND_SOLID = 1, DF_BACKGROUND_NONE = 2 };
#define DF_OPTIONS_INIT                                                                          \
  {                                                                                              \
    sizeof(df_options), 0, 0, NULL, NULL, NULL, NULL, NULL, 0, {0.0, 0.0, 0.0}, 0, 0, 0, 0.0, 0, \
        0, 0, 0                                                                                  \
  }

/* Draws into the caller's memory, top row first. rgba holds 4 * pixels bytes; ids (pick identifier
 * of the visible fill, -1: none) and depth (minus infinity: none) hold `pixels` numbers or are
 * null. `pixels` must be width times height, or width times the number of rows if rows are set.
 * Options may be null, here and below.
 *
 * Colours are antialiased: the mean of 4 x 4 samples per pixel unless `samples` is set, 1 with
 * "osmesa" and "plain-z-buffer"; ids and depth are those of the pixel's centre. */
DF_API int df_draw(df_system* system, const df_options* options, size_t pixels, uint8_t* rgba,
                   int32_t* ids, double* depth);
/* Returns the bytes of a file in this format: "svg", "pdf", "eps", "png" or "ppm". */
DF_API int df_draw_as(df_system* system, const df_options* options, const char* format,
                      const char** bytes, size_t* length);
/* Draws into a file; its extension sets the format. It is written completely or not at all. */
DF_API int df_draw_file(df_system* system, const df_options* options, const char* path);

/* Every instruction of the display file, as text. */
DF_API int df_dump(df_system* system, const char** text, size_t* length);

/* The pieces of a vector drawing, in drawing order, as arrays. With "depth-sort" and "bsp": all
 * polygons from back to front, including hidden ones; with "map": the visible pieces only, and so
 * with "auto", which is the map unless only lines are visible; with a method that finds lines: the
 * visible lines. */
typedef struct {
  size_t size; /* sizeof(df_pieces), set by the caller */
  size_t pieces;
  const uint8_t* kinds;       /* DF_SOLID, ... */
  const uint32_t* first;      /* index of each piece's first point; one extra entry at the end */
  const double* points;       /* x y z of each: x and y in [0,1], y up, larger z nearer */
  const uint8_t* sides;       /* per point: 0 if the side that ends there is not drawn */
  const double* fills;        /* red green blue per piece */
  const double* line_colours; /* likewise */
  const double* line_widths;  /* in pixels */
  const uint8_t* line_kinds;  /* DF_LINE_SOLID, ... */
  const int32_t* picks;       /* pick identifiers; -1: none */
  const int32_t* segments;    /* names */
  const uint8_t* cuts;        /* per point: 1 if a line, or a drawn side, is cut there */
} df_pieces;
enum { DF_SOLID = 0, DF_HOLLOW = 1, DF_LINE = 2 };
enum { DF_LINE_SOLID = 0, DF_LINE_DASHED = 1, DF_LINE_NONE = 2 };
DF_API int df_drawn_pieces(df_system* system, const df_options* options, df_pieces* pieces);

/* Picks what the picture with these options shows in the pixel that holds (x, y), in pixels from
 * the upper left corner; lines within `reach` pixels take precedence over fills. */
typedef struct {
  size_t size;  /* sizeof(df_seen), set by the caller */
  int is_seen;  /* 0: nothing is visible, and the other members are unused */
  int kind;     /* DF_SEEN_POLYGON, ... */
  int32_t pick; /* pick identifier; -1: none */
  int segment;
  double depth; /* 0 on the back plane, 1 on the front plane */
} df_seen;
enum { DF_SEEN_POLYGON = 0, DF_SEEN_EDGE = 1, DF_SEEN_LINE = 2 };
DF_API int df_pick(df_system* system, const df_options* options, double x, double y, double reach,
                   df_seen* seen);

/* The exact item buffer, and depth if not null, by the definition of truth alone: in integers of
 * any length, sharing no code with the methods. Slow. Only width and height of the options apply.
 */
DF_API int df_truth(df_system* system, const df_options* options, size_t pixels, int32_t* ids,
                    double* depth);

/* The steps of a method as JSON (interp/steps/README.md), at most most_steps; 0: the default limit.
 * Only width, height and method of the options apply. */
DF_API int df_steps(df_system* system, const df_options* options, size_t most_steps,
                    const char** text, size_t* length);

/* ---- Another eye --------------------------------------------------------------------------------
 */

/* Retains primitives before viewing, and all calls as a drawing program. Must be the first call on
 * a system, except df_set_aspect_ratio. */
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

/* The view in which all visible segments were drawn; DF_ERROR if there are several. */
DF_API int df_drawn_view(df_system* system, df_view* view);
/* Bounding box of the visible segments in world coordinates: least x y z, then greatest; DF_ERROR
 * if it is empty. */
DF_API int df_box(df_system* system, double box[6]);
/* Draws, picks, dumps and records from now on as if the application had set this view, bit for bit;
 * null: the application's own view. */
DF_API int df_look_from(df_system* system, const df_view* view);
/* All calls as a drawing program, in the view of df_look_from. */
DF_API int df_program(df_system* system, const char** text, size_t* length);

/* Stops the current call on the system soon, with DF_ERROR. Any thread or signal handler may call
 * it. No effect between calls. */
DF_API void df_stop(df_system* system);

/* NOLINTEND(modernize-use-using) */
#ifdef __cplusplus
}
#endif

#endif
