// The product's page.
'use strict';

/** The scene that is shown first. */
const kFirstScene = 'gears.draw';

async function start_index_page() {
  const { wasm, scenes, width, height, stepsPage } = JSON.parse(document.getElementById('data').text);
  const place = document.getElementById('viewer');
  const before = [...place.childNodes];
  try {
    const drawer = new Drawer();
    const { version, routines } = await drawer.ask('start', { wasm });
    document.getElementById('version').textContent = version;
    await show_parts({ drawer, routines, scenes, place, width, height, stepsPage });
  } catch (error) {
    place.replaceChildren(...before);
    document.getElementById('why-still').textContent = `Nothing can be drawn here: ${error.message}`;
  }
  document.documentElement.dataset.ready = Math.round(performance.now());
}

async function show_parts({ drawer, routines, scenes, place, width, height, stepsPage }) {
  const viewer = new Viewer(place, drawer, { width, height });
  document.documentElement.viewer = viewer;
  const table = new SpeedTable(document.getElementById('speed-table'), viewer);
  const steps = new StepByStep(document.getElementById('step-by-step'), viewer, stepsPage);
  let shown;
  const draw = async (program, keeps_view) => {
    gallery.keep(shown.name, program);
    table.clear();
    steps.clear();
    try {
      await viewer.show({ ...shown, program }, keeps_view);
      editor.show_error(undefined);
    } catch (refused) {
      if (!keeps_view) viewer.clear(shown.name);
      editor.show_error(refused);
    }
  };
  const editor = new Editor(document.getElementById('editor'), (program) => draw(program, true));
  editor.routines = routines;
  const gallery = new Gallery(document.getElementById('gallery'), scenes, (scene) => {
    shown = scene;
    editor.text = scene.program;
    history.replaceState(null, '', `#${encodeURIComponent(scene.name)}`);
    return draw(scene.program, false);
  }, (error) => editor.show_error(error));
  take_dropped_files(gallery);
  const asked = decodeURIComponent(location.hash.slice(1));
  const first = [asked, kFirstScene, scenes[0].name].find((name) => gallery.has(name));
  await gallery.choose(first);
  new Sheets(document.getElementById('sheets'), drawer).draw();
}

start_index_page();
