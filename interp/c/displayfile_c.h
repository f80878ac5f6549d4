/** @file
 * Display File for C99: a display-file, retained-mode 3D graphics system (interp/c/README.md).
 *
 * A df_system is one application's system: its view, styles, segments, and data cached between
 * pictures. Functions that return int return DF_OK, or DF_ERROR after an error, with a message in
 * df_error(); the state is then what it was before the call. It is an error of each function if the
 * system, or a pointer that is not described as optional, is null, and if memory runs out. Strings
 * are UTF-8 and end with a zero byte unless passed with a length. The system owns all memory that a
 * function returns; it is valid until the next call on the system.
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
 * as 0. It is an error if the size is not that of any version, or if members that this version does
 * not know are not 0.
 */
#ifndef DISPLAYFILE_C_H
#define DISPLAYFILE_C_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(displayfile_c_EXPORTS) /* as CMake compiles the library */
#define DF_API __declspec(dllexport)
#elif defined(_WIN32)
#define DF_API __declspec(dllimport)
#elif defined(__GNUC__)
#define DF_API __attribute__((visibility("default")))
#else
#define DF_API
#endif

#ifdef __cplusplus
extern "C" {
#endif
/* NOLINTBEGIN(modernize-use-using): C has typedef alone. */

/** @defgroup c_systems Systems
 * @{ */

/** Results of functions that return int. */
enum df_result {
  DF_OK = 0,    /**< done */
  DF_ERROR = 1, /**< an error, with a message in df_error() */
  DF_BUSY = 2   /**< refused: another thread's call on the system is in progress */
};

/** One application's system. */
typedef struct df_system df_system;

/** The version of this header (displayfile/stability.md). */
#define DF_VERSION_MAJOR 0
/** Likewise. */
#define DF_VERSION_MINOR 2
/** Likewise. */
#define DF_VERSION_PATCH 0
/** The version of the library at run time.
 * @return such as "1.2.3"; it stays valid */
DF_API const char* df_version(void);

/** Makes a system.
 * @return the system, for df_destroy(); null if out of memory */
DF_API df_system* df_create(void);
/** Destroys a system, and all memory that its functions returned. Must not be called during another
 * call on the system.
 * @param system null has no effect */
DF_API void df_destroy(df_system* system);
/** The message of the last call on the system.
 * @param system the system
 * @return the message if the call returned DF_ERROR, otherwise empty; after DF_BUSY, until this
 *     thread's next call on the system, that it is busy. It is never null. */
DF_API const char* df_error(const df_system* system);

/** @}
 * @defgroup c_routines User routines
 * By their names in drawing programs, such as "polygon-abs-3"
 * (displayfile/text/drawing_programs.md).
 * @{ */

/** The number of user routines.
 * @return the number; routines are numbered from 0 */
DF_API size_t df_routines(void);
/** The name of a user routine.
 * @param routine its number
 * @return the name, such as "polygon-abs-3"; null if the number is out of range */
DF_API const char* df_routine_name(size_t routine);
/** The arguments of a user routine.
 * @param routine its number
 * @return in words, such as "x y z", and empty if there are none; null if the number is out of
 *     range */
DF_API const char* df_routine_arguments(size_t routine);
/** The meaning of a user routine.
 * @param routine its number
 * @return in sentences, with defaults in brackets; null if the number is out of range */
DF_API const char* df_routine_meaning(size_t routine);
/** The topic of a user routine.
 * @param routine its number
 * @return such as "View"; routines of a topic are adjacent. Null if the number is out of range. */
DF_API const char* df_routine_section(size_t routine);

/** Calls a user routine with arguments as words: df_call(system, "set-fill-style", "solid 1 0 0").
 * @param system the system
 * @param routine the routine's name
 * @param arguments as in a drawing program, on one line; null: none
 * @return DF_OK; DF_ERROR for an unknown routine, for arguments that are not those of the routine,
 *     and for what the routine itself refuses, such as a polygon outside of a segment; DF_BUSY */
DF_API int df_call(df_system* system, const char* routine, const char* arguments);
/** Calls a user routine with arguments as numbers, used exactly.
 * @param system the system
 * @param routine the routine's name
 * @param numbers the arguments; null if there are none
 * @param count the number of arguments
 * @return as df_call() */
DF_API int df_call_numbers(df_system* system, const char* routine, const double* numbers,
                           size_t count);

/** Runs a drawing program.
 * @param system the system
 * @param text the program, in UTF-8; null if `length` is 0
 * @param length its length in bytes
 * @param name the program's name in messages; null: "drawing program"
 * @return DF_OK; DF_ERROR for a line that is not understood or refused, for text that is not UTF-8,
 *     and for a segment left open. The message begins name:line:column; lines before the error keep
 *     their effect. DF_BUSY. */
DF_API int df_replay(df_system* system, const char* text, size_t length, const char* name);
/** Runs the drawing program in a file.
 * @param system the system
 * @param path the file
 * @return as df_replay(), and DF_ERROR if the file cannot be read */
DF_API int df_replay_file(df_system* system, const char* path);
/** Enters a mesh from a file, in a view fitted to it if no window was set.
 * @param system the system
 * @param path the file: OBJ, OFF, PLY, STL, or a format that displayfile-import reads, such as glTF
 * @return DF_OK; DF_ERROR if the file cannot be read or is not a mesh of its format, or if a
 * segment is open; DF_BUSY */
DF_API int df_import_mesh(df_system* system, const char* path);
/** Sets the shape of the pictures in which segments opened from now on are drawn. Without it, a
 * picture that is not square stretches what it shows.
 * @param system the system
 * @param aspect width over height; 1 if this function is not called
 * @return DF_OK; DF_ERROR if it is not a positive number within the limit of coordinates, or a
 *     segment is open; DF_BUSY */
DF_API int df_set_aspect_ratio(df_system* system, double aspect);

/** Many polygons. Unused arrays are null; a non-null empty array, for polygons that have corners,
 * is an error. */
typedef struct {
  size_t size;             /**< sizeof(df_mesh) */
  const double* vertices;  /**< x y z of each, in world coordinates */
  size_t vertex_count;     /**< points, not numbers */
  const uint32_t* corners; /**< indices of vertices, polygon after polygon */
  size_t corner_count;     /**< of all polygons together */
  const uint32_t* sides;   /**< number of corners per polygon; null: three each */
  size_t polygon_count;    /**< entries of `sides`; unused if that is null */
  const double* colours;   /**< red green blue in [0,1], one for all or per polygon; null: as set */
  size_t colour_count;     /**< colours, not numbers */
  const int32_t* picks;    /**< pick identifiers, one per polygon; null: as set */
  size_t pick_count;       /**< entries of `picks` */
  const double* normals;   /**< x y z, one per vertex; null: none */
  size_t normal_count;     /**< normals, not numbers */
} df_mesh;
/** A df_mesh of no polygons. */
#define DF_MESH_INIT \
  { sizeof(df_mesh), NULL, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0 }
/** Enters many polygons into the open segment, several times as fast as one by one.
 * @param system the system
 * @param mesh the polygons
 * @return DF_OK; DF_ERROR if no segment is open, an array is null though its count is not 0, counts
 *     do not match, an index is out of range, or a number is one that the routines refuse; DF_BUSY
 */
DF_API int df_polygons(df_system* system, const df_mesh* mesh);

/** @}
 * @defgroup c_drawing Drawing
 * Options may be null: the application's settings and the defaults.
 * @{ */

/** Options of a picture. Members that are 0 or null stand for the application's setting or the
 * default. */
typedef struct {
  size_t size;                 /**< sizeof(df_options) */
  int width;                   /**< in pixels; of a PDF, in points; default 512 */
  int height;                  /**< likewise */
  const char* method;          /**< hidden-surface method: "map", "z-buffer", "franklin", ... */
  const char* scope;           /**< "segment" or "all" */
  const char* precision;       /**< "exact", or "roundoff=1e-9" */
  const char* hidden_lines;    /**< "none" or "dashed" */
  const char* device;          /**< for pixels: "software" or "osmesa" */
  int background;              /**< DF_BACKGROUND_... */
  double background_colour[3]; /**< red green blue in [0,1], with DF_BACKGROUND_SOLID */
  int samples;                 /**< per pixel side; default 4, or as many as fit; see df_draw() */
  int threads;                 /**< maximum; default 1 */
  uint64_t most_pieces;        /**< limit on pieces into which a sort cuts polygons */
  double most_seconds;         /**< limit on the time of one call */
  int first_row;               /**< for pixels: draw only the rows of the picture from this one, */
  int end_row;                 /**< and up to before this one, from the top; both 0: all */
  uint64_t most_comparisons;   /**< limit on comparisons of polygons and lines in one call */
  uint64_t most_bytes;         /**< limit on the memory of one operation's tables */
  const char* line_order; /**< "entry" or "depth": which of two lines is drawn over the other */
  double line_halo;       /**< with "depth": the gap beside the farther one, in pixels */
  const char* font;       /**< of texts: the name of a font of the system, or "hershey", or
                               "hershey:NAME" for letters of strokes; default "sans-serif" */
  const char* text; /**< letters in vectors: "text", or "outlines", the same in every viewer */
} df_options;
/** Values of df_options.background. */
enum df_background {
  DF_BACKGROUND_AS_SET = 0, /**< as the application has set it */
  DF_BACKGROUND_SOLID = 1,  /**< background_colour */
  DF_BACKGROUND_NONE = 2    /**< transparent */
};
/** Options that are all as set or default. */
#define DF_OPTIONS_INIT                                                                          \
  {                                                                                              \
    sizeof(df_options), 0, 0, NULL, NULL, NULL, NULL, NULL, 0, {0.0, 0.0, 0.0}, 0, 0, 0, 0.0, 0, \
        0, 0, 0, NULL, 0.0, NULL, NULL                                                           \
  }

/** Draws into the caller's memory, top row first.
 *
 * Colours are antialiased: the mean of 4 x 4 samples per pixel unless `samples` is set, 1 with
 * "osmesa" and "plain-z-buffer"; ids and depth are those of the pixel's centre.
 * @param system the system
 * @param options null: none
 * @param pixels the room of the arrays: must be width times height, or width times the number of
 *     rows if rows are set
 * @param rgba 4 bytes per pixel: red, green, blue, alpha
 * @param ids the pick identifier of the visible fill per pixel, -1: none; or null
 * @param depth the depth of the visible fill per pixel, minus infinity: none; or null
 * @return DF_OK; DF_ERROR for an option out of range, an unknown method or device, options that
 *     exclude each other, room of another size, a limit that is reached, and after df_stop();
 *     DF_BUSY */
DF_API int df_draw(df_system* system, const df_options* options, size_t pixels, uint8_t* rgba,
                   int32_t* ids, double* depth);
/** Draws into a file in memory.
 * @param system the system
 * @param options null: none
 * @param format "svg", "pdf", "eps", "png" or "ppm", or with pens "dxf"
 * @param bytes gets the address of the file's bytes
 * @param length gets their number
 * @return as df_draw(), and DF_ERROR for an unknown format */
DF_API int df_draw_as(df_system* system, const df_options* options, const char* format,
                      const char** bytes, size_t* length);
/** Draws into a file. It is written completely or not at all.
 * @param system the system
 * @param options null: none
 * @param path the file; its extension sets the format
 * @return as df_draw(), and DF_ERROR for an unknown extension or a file that cannot be written */
DF_API int df_draw_file(df_system* system, const df_options* options, const char* path);

/** Every instruction of the display file, as text (programs/manual/dumps.md).
 * @param system the system
 * @param text gets the address of the text
 * @param length gets its length in bytes
 * @return DF_OK; DF_ERROR; DF_BUSY */
DF_API int df_dump(df_system* system, const char** text, size_t* length);

/** The pieces of a vector drawing, in drawing order, as arrays. */
typedef struct {
  size_t size;                /**< sizeof(df_pieces), set by the caller */
  size_t pieces;              /**< their number */
  const uint8_t* kinds;       /**< DF_SOLID, ... per piece */
  const uint32_t* first;      /**< index of each piece's first point; one extra entry at the end */
  const double* points;       /**< x y z of each: x and y in [0,1], y up, larger z nearer */
  const uint8_t* sides;       /**< per point: 0 if the side that ends there is not drawn */
  const double* fills;        /**< red green blue per piece */
  const double* line_colours; /**< likewise */
  const double* line_widths;  /**< in pixels, per piece */
  const uint8_t* line_kinds;  /**< DF_LINE_SOLID, ... per piece */
  const int32_t* picks;       /**< pick identifiers per piece; -1: none */
  const int32_t* segments;    /**< names, per piece */
  const uint8_t* cuts;        /**< per point: 1 if a line, or a drawn side, is cut there */
} df_pieces;
/** Entries of df_pieces.kinds. */
enum df_piece_kind {
  DF_SOLID = 0,  /**< a filled polygon */
  DF_HOLLOW = 1, /**< a polygon without a fill */
  DF_LINE = 2    /**< a line */
};
/** Entries of df_pieces.line_kinds. */
enum df_line_kind {
  DF_LINE_SOLID = 0,  /**< drawn through */
  DF_LINE_DASHED = 1, /**< dashed */
  DF_LINE_NONE = 2    /**< not drawn */
};
/** Returns the pieces of a vector drawing. With "depth-sort" and "bsp": all polygons from back to
 * front, including hidden ones; with "map": the visible pieces only, and so with "auto", which is
 * the map unless only lines are visible; with a method that finds lines: the visible lines.
 * @param system the system
 * @param options null: none
 * @param pieces its size is set by the caller; gets the arrays
 * @return as df_draw() */
DF_API int df_drawn_pieces(df_system* system, const df_options* options, df_pieces* pieces);

/** The item that is visible at a place of a picture. */
typedef struct {
  size_t size;  /**< sizeof(df_seen), set by the caller */
  int is_seen;  /**< 0: nothing is visible, and the other members are unused */
  int kind;     /**< DF_SEEN_POLYGON, ... */
  int32_t pick; /**< pick identifier; -1: none */
  int segment;  /**< its name */
  double depth; /**< 0 on the back plane, 1 on the front plane */
} df_seen;
/** Values of df_seen.kind. */
enum df_seen_kind {
  DF_SEEN_POLYGON = 0, /**< a fill */
  DF_SEEN_EDGE = 1,    /**< a side of a polygon */
  DF_SEEN_LINE = 2     /**< a line */
};
/** Picks what the picture with these options shows at a place.
 * @param system the system
 * @param options null: none
 * @param x from the left edge of the picture, in pixels
 * @param y from the upper edge, in pixels
 * @param reach lines that are visible within this number of pixels of the pixel's centre take
 *     precedence over fills, the nearest first; 0: only fills are picked
 * @param seen its size is set by the caller; gets what is visible in the pixel that holds (x, y)
 * @return as df_draw(), and DF_ERROR for a place that is not finite or a reach out of range;
 * outside of the picture nothing is visible */
DF_API int df_pick(df_system* system, const df_options* options, double x, double y, double reach,
                   df_seen* seen);

/** The exact item buffer by the definition of truth alone (interp/truth/truth.md): in integers of
 * any length, sharing no code with the methods. Slow.
 * @param system the system
 * @param options only width and height apply; null: none
 * @param pixels the room of the arrays: must be width times height
 * @param ids the pick identifier of the visible fill per pixel, top row first; -1: none
 * @param depth its depth, minus infinity: none; or null
 * @return DF_OK; DF_ERROR for a size out of range, room of another size, a limit that is reached,
 *     and after df_stop(); DF_BUSY */
DF_API int df_truth(df_system* system, const df_options* options, size_t pixels, int32_t* ids,
                    double* depth);

/** The steps of a method as JSON (interp/steps/README.md).
 * @param system the system
 * @param options only width, height and method apply; the method must be set
 * @param most_steps more are an error; 0: the default limit
 * @param text gets the address of the text
 * @param length gets its length in bytes
 * @return as df_draw(), and DF_ERROR for a method without steps or too many steps */
DF_API int df_steps(df_system* system, const df_options* options, size_t most_steps,
                    const char** text, size_t* length);

/** @}
 * @defgroup c_eye Another eye
 * The same scene in another view, without entering it anew.
 * @{ */

/** Retains primitives before viewing, and all calls as a drawing program. Must be the first call on
 * a system, except df_set_aspect_ratio(). A second call has no effect.
 * @param system the system
 * @return DF_OK; DF_ERROR if a routine was called before; DF_BUSY */
DF_API int df_retain(df_system* system);

/** The view parameters, as their user routines take them. */
typedef struct {
  size_t size;               /**< sizeof(df_view), set by the caller */
  double reference_point[3]; /**< x y z of set-view-reference-point */
  double plane_normal[3];    /**< x y z of set-view-plane-normal */
  double up[3];              /**< x y z of set-view-up */
  double distance;           /**< of set-view-distance */
  int is_perspective;        /**< 1: set-perspective, 0: set-parallel */
  double projection[3];      /**< the centre of projection, or else its direction */
  double depth[2];           /**< of the front and the back plane (set-view-depth) */
  int clips_front;           /**< 1 with set-front-plane-clipping on */
  int clips_back;            /**< 1 with set-back-plane-clipping on */
  double window[4];          /**< x_min x_max y_min y_max of set-window */
  double viewport[4];        /**< likewise, of set-viewport */
} df_view;

/** The view in which all visible segments were drawn.
 * @param system a system that retains
 * @param view its size is set by the caller; gets the view
 * @return DF_OK; DF_ERROR if segments were drawn in several views, or without df_retain(); DF_BUSY
 */
DF_API int df_drawn_view(df_system* system, df_view* view);
/** The bounding box of the visible segments in world coordinates.
 * @param system a system that retains
 * @param box gets the least x y z, then the greatest
 * @return DF_OK; DF_ERROR if it is empty, if segments were drawn in several views, or without
 *     df_retain(); DF_BUSY */
DF_API int df_box(df_system* system, double box[6]);
/** Draws, picks, dumps and records from now on as if the application had set this view, bit for
 * bit.
 * @param system a system that retains
 * @param view null: the application's own view
 * @return DF_OK; DF_ERROR for a view that the routines refuse, if segments were drawn in several
 *     views, or without df_retain(), and the view is then what it was; DF_BUSY */
DF_API int df_look_from(df_system* system, const df_view* view);
/** All calls as a drawing program, in the view of df_look_from().
 * @param system a system that retains
 * @param text gets the address of the text
 * @param length gets its length in bytes
 * @return DF_OK; DF_ERROR without df_retain(); DF_BUSY */
DF_API int df_program(df_system* system, const char** text, size_t* length);

/** @}
 * @defgroup c_stop Stopping
 * @{ */

/** Stops the current call on the system soon, with DF_ERROR. Any thread or signal handler may call
 * it. No effect between calls.
 * @param system null has no effect */
DF_API void df_stop(df_system* system);

/** @} */

/* NOLINTEND(modernize-use-using) */
#ifdef __cplusplus
}
#endif

#endif
