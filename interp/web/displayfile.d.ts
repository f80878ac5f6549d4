/** Display File in JavaScript: the C API compiled to WebAssembly. */

/** Arguments of a user routine, as in drawing programs: numbers are used exactly, true and false mean
 *  on and off, arrays are flattened. */
export type Words = number | string | boolean | Iterable<Words>;

export interface Options {
  /** In pixels; default 512. */
  width?: number;
  height?: number;
  /** A hidden-surface method: "map", "z-buffer", "franklin", ...; default: the application's. */
  method?: string;
  /** "segment" or "all". */
  scope?: string;
  /** "exact", or "roundoff=1e-9". */
  precision?: string;
  hiddenLines?: 'none' | 'dashed';
  /** Which of two lines that overlap is drawn over the other: the one entered later, or the nearer. */
  lineOrder?: 'entry' | 'depth';
  /** With "depth": the gap beside a line where another one crosses in front of it, in pixels. */
  lineHalo?: number;
  /** Of texts in SVG: the name of a font that the viewer has; default "sans-serif". Fonts of strokes are
   *  files, which pages do not read: "hershey" is refused. */
  font?: string;
  /** Letters in SVG as text; outlines need Cairo, which pages do not have. */
  text?: 'text';
  /** Red, green and blue in [0,1]; default: the application's. */
  background?: [number, number, number] | 'none';
  /** Samples per pixel side, 1 to 16; default 4, or as many as a picture of this size may have. */
  samples?: number;
  /** Limit on the pieces into which a sort cuts polygons. */
  mostPieces?: number;
  /** Limit on the time of one call. */
  mostSeconds?: number;
}

export interface DrawOptions extends Options {
  /** Also return the item buffer. */
  ids?: boolean;
  /** Also return the depths. */
  depth?: boolean;
}

export interface Picture {
  width: number;
  height: number;
  /** Top row first, as in ImageData. */
  rgba: Uint8ClampedArray;
  /** The pick identifier of the visible fill at each pixel; -1: none. */
  ids?: Int32Array;
  /** 0 on the back plane, 1 on the front plane; minus infinity: none. */
  depth?: Float64Array;
}

export interface Mesh {
  /** x y z of each. */
  vertices: ArrayLike<number>;
  /** Indices of vertices, polygon after polygon. */
  corners: ArrayLike<number>;
  /** The number of corners of each polygon; default: three each. */
  sides?: ArrayLike<number>;
  /** Red, green and blue in [0,1], one colour for all or one per polygon. */
  colours?: ArrayLike<number>;
  /** Pick identifiers, one per polygon. */
  picks?: ArrayLike<number>;
  /** x y z, one normal per vertex. */
  normals?: ArrayLike<number>;
}

/** Drawn pieces in drawing order. Piece k has the points first[k] to first[k + 1]. */
export interface Pieces {
  /** 0: solid, 1: hollow, 2: line. */
  kinds: Uint8Array;
  first: Uint32Array;
  /** x y z of each point: x and y in [0,1], y up, larger z nearer. */
  points: Float64Array;
  /** Per point: 0 if the side that ends there is not drawn. */
  sides: Uint8Array;
  fills: Float64Array;
  lineColours: Float64Array;
  lineWidths: Float64Array;
  /** 0: solid, 1: dashed, 2: none. */
  lineKinds: Uint8Array;
  picks: Int32Array;
  segments: Int32Array;
  /** Per point: 1 if a line, or a drawn side, is cut there. */
  cuts: Uint8Array;
}

/** The view parameters, as their user routines take them. */
export interface View {
  referencePoint: number[];
  planeNormal: number[];
  up: number[];
  distance: number;
  perspective: boolean;
  /** The centre of projection, or else its direction. */
  projection: number[];
  /** The front and the back plane. */
  front: number;
  back: number;
  frontClipping: boolean;
  backClipping: boolean;
  /** x_min, x_max, y_min, y_max. */
  window: number[];
  viewport: number[];
}

export interface Seen {
  kind: 'polygon' | 'edge' | 'line';
  /** Pick identifier; -1: none. */
  pick: number;
  segment: number;
  /** 0 on the back plane, 1 on the front plane. */
  depth: number;
}

/** Thrown for an invalid call, which leaves the state unchanged. */
export class DisplayFileError extends Error {
  file?: string;
  line?: number;
  column?: number;
}

/** One application's system: its view, styles and segments. */
export interface System extends UserRoutines {
  /** Frees its memory. It must not be used afterwards. */
  free(): void;
  /** Calls a user routine by its name, such as "polygon-abs-3". */
  call(routine: string, ...values: Words[]): void;
  /** Runs a drawing program. Lines before an error keep their effect. */
  replay(program: string | Uint8Array, name?: string): void;
  /** Enters a mesh from a file's bytes (OBJ, OFF, PLY, STL), in a view fitted to it if no window was
   *  set. */
  importMesh(name: string, bytes: Uint8Array): void;
  /** Sets the width over height of the pictures in which segments opened from now on are drawn. */
  setAspectRatio(aspect: number): void;
  /** Enters many polygons into the open segment. */
  mesh(mesh: Mesh): void;
  draw(options?: DrawOptions): Picture;
  /** The bytes of a file. */
  drawAs(format: 'svg' | 'ppm', options?: Options): Uint8Array;
  svg(options?: Options): string;
  /** Every instruction of the display file. */
  dump(): string;
  pieces(options?: Options): Pieces;
  /** The primitive visible at a point, in pixels from the upper left corner; lines within `reach`
   *  pixels take precedence over fills. */
  pick(x: number, y: number, options?: Options & { reach?: number }): Seen | null;
  /** The exact item buffer, by the definition of truth alone. Slow. */
  truth(options?: { width?: number; height?: number }): { width: number; height: number; ids: Int32Array };
  /** The steps of a method, as `displayfile steps -o steps.json` writes them. */
  steps(options: { method: string; width?: number; height?: number; mostSteps?: number }): object;
  /** Retains primitives before viewing, and all calls as a drawing program. Must be the first call
   *  on a system, except setAspectRatio. */
  retain(): void;
  /** The view in which all visible segments were drawn; throws if there are several. */
  view(): View;
  /** Bounding box of the visible segments, in world coordinates. */
  box(): { least: number[]; greatest: number[] };
  /** Draws, picks, dumps and records from now on as if the application had set this view, bit for
   *  bit; null: the application's own view. */
  lookFrom(view: View | null): void;
  /** All calls as a drawing program, in the view of lookFrom. */
  program(): string;
}

export interface DisplayFile {
  version: string;
  /** The user routines, with their arguments in words. */
  routines: { name: string; arguments: string }[];
  System: new () => System;
  DisplayFileError: typeof DisplayFileError;
}

/** Loads the compiled program; `wasm` is its bytes, for pages that contain them. */
export function load(options?: { wasm?: Uint8Array | ArrayBuffer }): Promise<DisplayFile>;
