/** Display File in JavaScript: the C API compiled to WebAssembly. */

/** Arguments of a user routine, as drawing programs have them: numbers are taken exactly, true and
 *  false are on and off, arrays are their elements one after another. */
export type Words = number | string | boolean | Iterable<Words>;

export interface Options {
  /** Pixels; 512. */
  width?: number;
  height?: number;
  /** A hidden-surface method: "map", "z-buffer", "franklin", ...; else as the application set. */
  method?: string;
  /** "segment" or "all". */
  scope?: string;
  /** "exact", or "roundoff=1e-9". */
  precision?: string;
  hiddenLines?: 'none' | 'dashed';
  /** Red, green and blue in [0,1]; else as the application set. */
  background?: [number, number, number] | 'none';
  /** Samples along a pixel's side, 1 to 16; 4, or as many as a picture of this size may have. */
  samples?: number;
  /** That a sort may cut polygons into. */
  mostPieces?: number;
  /** That one call may take. */
  mostSeconds?: number;
}

export interface DrawOptions extends Options {
  /** Also the item buffer. */
  ids?: boolean;
  /** Also the depths. */
  depth?: boolean;
}

export interface Picture {
  width: number;
  height: number;
  /** Top row first, as an ImageData takes it. */
  rgba: Uint8ClampedArray;
  /** The pick identifier of the fill seen at each pixel; -1: none. */
  ids?: Int32Array;
  /** 0 on the back plane, 1 on the front plane; minus infinity: none. */
  depth?: Float64Array;
}

export interface Mesh {
  /** x y z of each. */
  vertices: ArrayLike<number>;
  /** Indices of vertices, polygon after polygon. */
  corners: ArrayLike<number>;
  /** How many corners each polygon has; else three each. */
  sides?: ArrayLike<number>;
  /** Red, green and blue in [0,1], of one for all or of each polygon. */
  colours?: ArrayLike<number>;
  /** Pick identifiers, one of each polygon. */
  picks?: ArrayLike<number>;
  /** x y z of each vertex. */
  normals?: ArrayLike<number>;
}

/** What is drawn, in order. Piece k has the points first[k] to first[k + 1]. */
export interface Pieces {
  /** 0: solid, 1: hollow, 2: line. */
  kinds: Uint8Array;
  first: Uint32Array;
  /** x y z of each point: x and y in [0,1], y up, larger z nearer. */
  points: Float64Array;
  /** Of each point: 0 if the side that ends there is not drawn. */
  sides: Uint8Array;
  fills: Float64Array;
  lineColours: Float64Array;
  lineWidths: Float64Array;
  /** 0: solid, 1: dashed, 2: none. */
  lineKinds: Uint8Array;
  picks: Int32Array;
  segments: Int32Array;
  /** Of each point: 1 if a line, or a side that is drawn, is cut there. */
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

/** What the system could not carry out; the state is then what it was before the call. */
export class DisplayFileError extends Error {
  file?: string;
  line?: number;
  column?: number;
}

/** One application's system: its view, styles and segments. */
export interface System extends UserRoutines {
  /** Lets go of its memory. Nothing may be asked of it after that. */
  free(): void;
  /** Any user routine by its name, such as "polygon-abs-3". */
  call(routine: string, ...values: Words[]): void;
  /** A drawing program. What its lines did before one that is wrong stays. */
  replay(program: string | Uint8Array, name?: string): void;
  /** A mesh's file (OBJ, OFF, PLY, STL), in a view that is fitted to it if no window was set. */
  importMesh(name: string, bytes: Uint8Array): void;
  /** The width over the height of the pictures that segments opened from now on are drawn as. */
  setAspectRatio(aspect: number): void;
  /** Many polygons, into the open segment. */
  mesh(mesh: Mesh): void;
  draw(options?: DrawOptions): Picture;
  /** The bytes of a file. */
  drawAs(format: 'svg' | 'ppm', options?: Options): Uint8Array;
  svg(options?: Options): string;
  /** Every instruction of the display file. */
  dump(): string;
  pieces(options?: Options): Pieces;
  /** What is seen at a place in pixels from the upper left corner; lines within `reach` pixels come
   *  before fills. */
  pick(x: number, y: number, options?: Options & { reach?: number }): Seen | null;
  /** The exact item buffer, by the definition of truth alone. Slow. */
  truth(options?: { width?: number; height?: number }): { width: number; height: number; ids: Int32Array };
  /** How a method finds what is seen, step by step: what `displayfile steps -o steps.json` writes. */
  steps(options: { method: string; width?: number; height?: number; mostSteps?: number }): object;
  /** Keeps what is drawn before viewing, and all calls as a drawing program: the first call on a
   *  system, except for its aspect ratio. */
  retain(): void;
  /** The one view in which the visible segments were drawn; an error if there were several. */
  view(): View;
  /** Around what is visible, in world coordinates. */
  box(): { least: number[]; greatest: number[] };
  /** From now on drawing, picking, pieces, the dump and the program are what they would be if the
   *  application had set that view, to the last bit; null: as it did set it. */
  lookFrom(view: View | null): void;
  /** All that was called, as a drawing program, in the view that is looked from. */
  program(): string;
}

export interface DisplayFile {
  version: string;
  /** The user routines, with their arguments in words. */
  routines: { name: string; arguments: string }[];
  System: new () => System;
  DisplayFileError: typeof DisplayFileError;
}

/** Loads the compiled program; `wasm` is its bytes, where a page has them with it. */
export function load(options?: { wasm?: Uint8Array | ArrayBuffer }): Promise<DisplayFile>;
