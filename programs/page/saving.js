// What is saved of a viewer's picture: files that are those of the command.
'use strict';

/** The name of the scene, without its extension; of another picture than the program's, another. */
function name_to_save(viewer) {
  const name = viewer.given.name.replace(/\.[a-z]+$/i, '');
  return viewer.is_changed ? `${name}-view` : name;
}

/** What draws the very picture, where the saved drawing program is. */
function command_line(viewer) {
  const { width, height, samples } = viewer.options;
  const name = name_to_save(viewer);
  const antialiased = samples ? ` --samples ${samples}` : '';
  return `displayfile draw ${name}.draw -o ${name}.png --size ${width}x${height}${antialiased}`;
}

async function save_png(viewer) {
  if (!viewer.picture.rgba) {
    viewer.say('Only the command draws texts in pixels: save the drawing program, or SVG.');
    return;
  }
  save_file(`${name_to_save(viewer)}.png`, await png_file(viewer.picture), 'image/png');
}

const what_is_shown = ({ key, view, options }) => ({ key, view, options });

async function save_svg(viewer) {
  const { svg } = await viewer.drawer.ask('svg', what_is_shown(viewer));
  save_file(`${name_to_save(viewer)}.svg`, svg, 'image/svg+xml');
}

async function save_program(viewer) {
  const request = { ...what_is_shown(viewer), settings: viewer.settings };
  const { program, isTheSame } = await viewer.drawer.ask('save', request);
  save_file(`${name_to_save(viewer)}.draw`, program, 'text/plain');
  viewer.say(isTheSame
    ? 'Saved. Drawn again, the program gives the picture shown here, byte for byte as SVG.'
    : 'Saved, but drawn again, the program gives a picture different from the one shown here.');
}

/** The buttons. What is drawn is at rest before it is saved. */
function save_controls(viewer) {
  const saving = (save) => async () => {
    if (!viewer.given) return;
    try {
      await viewer.redrawn();
      await save(viewer);
    } catch (refused) {
      viewer.say(refused.message);
    }
  };
  const button = (said, save) => element('button', { type: 'button', click: saving(save) }, said);
  return element('div', { class: 'saving', role: 'group', 'aria-label': 'Save' },
    button('Save PNG', save_png), button('Save SVG', save_svg), button('Save drawing program', save_program));
}
