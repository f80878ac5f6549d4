// The page of one scene.
'use strict';

/** Ready when the first picture is there; until then, and where that fails, the still stays. */
async function start_viewer_page() {
  const { wasm, scenes, width, height, method, precision, scope, hiddenLines } =
    JSON.parse(document.getElementById('data').text);
  const place = document.getElementById('viewer');
  const still = [...place.childNodes];
  try {
    const drawer = new Drawer();
    await drawer.ask('start', { wasm });
    const viewer = new Viewer(place, drawer, { width, height, settings: { method, precision, scope, hiddenLines } });
    document.documentElement.viewer = viewer;
    await viewer.show(scenes[0]);
  } catch (error) {
    place.replaceChildren(...still);
    document.getElementById('why-still').textContent = `A still picture: ${error.message}`;
  }
  document.documentElement.dataset.ready = Math.round(performance.now());
}

document.getElementById('name').textContent = document.title;
start_viewer_page();
