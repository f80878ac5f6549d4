// Writes what of the package is made from the compiled programs: their bytes, compressed by LZMA and in
// base64, as a page in one file has them with it; and the types, which are displayfile.d.ts and a
// method for each user routine.
//   node make_package.js PACKAGE TYPES
'use strict';

const fs = require('fs');
const path = require('path');
const { packed } = require('./packed.js');

const [folder, types] = process.argv.slice(2);
const { load } = require(path.resolve(folder, 'displayfile.js'));

for (const name of ['displayfile-module.wasm', 'displayfile-viewer.wasm']) {
  const program = path.join(folder, name);
  const bytes = packed(fs.readFileSync(program));
  fs.writeFileSync(`${program}.lzma.base64`, bytes.toString('base64'));
}

load().then(({ routines }) => {
  const methods = routines.map(({ name, arguments: words }) => {
    const method = name.replace(/-(.)/g, (_, letter) => letter.toUpperCase());
    return `  /** ${words === '' ? name : `${name} ${words}`} */\n` +
      `  ${method}(${words === '' ? '' : '...values: Words[]'}): void;\n`;
  });
  const text = fs.readFileSync(types, 'utf8') +
    '\n/** The user routines of drawing programs; their arguments are told in words. */\n' +
    `export interface UserRoutines {\n${methods.join('')}}\n`;
  fs.writeFileSync(path.join(folder, 'displayfile.d.ts'), text);
});
