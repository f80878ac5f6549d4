// Writes the package's types: displayfile.d.ts, and after it a method for each user routine of the
// compiled program beside it.
//   node make_types.js PACKAGE TYPES
'use strict';

const fs = require('fs');
const path = require('path');

const [folder, types] = process.argv.slice(2);
const { load } = require(path.resolve(folder, 'displayfile.js'));

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
