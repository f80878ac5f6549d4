// What may be chosen of a picture: [value, words], '' being what the drawing program says.
'use strict';

const kAsProgram = ['', 'the program’s'];

const kMethods = [
  [undefined, [kAsProgram, ['auto', 'auto']]],
  ['Hidden surfaces', [['z-buffer', 'z-buffer'], ['scan-line', 'scan line'], ['scan-line-z', 'scan-line z-buffer'],
    ['ray-cast', 'ray casting'], ['world-ray-cast', 'ray casting before viewing'], ['warnock', 'Warnock'],
    ['bsp', 'BSP tree'], ['depth-sort', 'depth sort'], ['map', 'map of visible pieces']]],
  ['Not exact', [['none', 'none: in order of entry'], ['back-face', 'back-face check only'],
    ['plain-z-buffer=double', 'plain z-buffer, double'], ['plain-z-buffer=float', 'plain z-buffer, float'],
    ['plain-z-buffer=32', 'plain z-buffer, 32 bits'], ['plain-z-buffer=24', 'plain z-buffer, 24 bits'],
    ['plain-z-buffer=16', 'plain z-buffer, 16 bits']]],
  ['Textbook forms', [['plain-scan-line', 'plain scan line'], ['plain-warnock', 'plain Warnock'],
    ['plain-bsp', 'plain BSP tree'], ['plain-appel', 'plain Appel']]],
  ['Hidden lines', [['franklin', 'Franklin'], ['roberts', 'Roberts'], ['appel', 'Appel'],
    ['perimeter', 'perimeter, of one surface'], ['colour-rule', 'colour rule']]],
];

const kLineMethods = new Set(['franklin', 'roberts', 'appel', 'perimeter', 'plain-appel', 'colour-rule']);
/** They see the same at each pixel: one may draw for another while the figure turns. */
const kExactMethods = new Set(['scan-line', 'scan-line-z', 'ray-cast', 'world-ray-cast', 'warnock', 'bsp',
  'depth-sort', 'map', 'plain-scan-line', 'plain-warnock', 'plain-bsp']);

const kPrecisions = [[undefined, [kAsProgram, ['exact', 'exact'],
  ...[15, 12, 9, 6, 3].map((digits) => [`roundoff=1e-${digits}`, `roundoff 1e-${digits}`])]]];

const kLines = [[undefined, [kAsProgram, ['none', 'none'], ['all', 'all sides'],
  ['outline boundary crease', 'outline and creases'],
  ['outline boundary crease intersection', 'and where polygons meet']]]];

const kHiddenLines = [[undefined, [kAsProgram, ['none', 'not drawn'], ['dashed', 'dashed']]]];

const kShadings = [[undefined, [kAsProgram, ['flat', 'flat'], ['gouraud', 'Gouraud'], ['phong', 'Phong']]]];

/** As many along a pixel's side as a picture has where nothing is set. */
const kUsualSamples = 4;
const words_of_samples = (n) => (n === 1 ? 'one per pixel' : `${n} × ${n} per pixel`);
/** Where none are set, in words. A plain z-buffer holds all samples of a picture in memory, and has one. */
function words_of_usual_samples(method) {
  return `default: ${words_of_samples(/^(colour-rule=)?plain-z-buffer/.test(method) ? 1 : kUsualSamples)}`;
}
const kSamples = [[undefined, [['', words_of_usual_samples('')],
  ...[1, 2, 3, 4].map((n) => [String(n), words_of_samples(n)])]]];

const kBackgrounds = [[undefined, [kAsProgram, ['none', 'transparent'], ['1 1 1', 'white'], ['0 0 0', 'black']]]];

/** How it reads in a sentence. */
function words_of_method(method) {
  for (const [, choices] of kMethods) {
    const found = choices.find(([value]) => value === method);
    if (found) return found[1];
  }
  return method;
}
