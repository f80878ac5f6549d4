// The scenes to choose from: the gallery's drawing programs as they were edited, and files that are
// dropped on the page.
'use strict';

const kMeshFiles = /\.(obj|off|ply|stl)$/i;
const kProgramFiles = /\.draw$/i;

const kBeforeMesh = (name) => `# ${name} is drawn after this drawing program, and what it sets acts on the mesh:
# set-fill-style solid 0.85 0.6 0.4
# set-shading phong
# rotate-x-3 -90
`;

class Gallery {
  #scenes = new Map();
  #select;
  #pick;
  #refuse;

  /** Fills `place` with a choice and a button for files; pick(scene) is called with a copy of
   *  {name, program, mesh} when one is chosen, refuse(error) with what is wrong with a file. */
  constructor(place, scenes, pick, refuse) {
    this.#pick = pick;
    this.#refuse = refuse;
    const file = element('input', { type: 'file', id: 'file', accept: '.draw,.obj,.off,.ply,.stl',
      class: 'visually-hidden', change: () => { this.take(file.files[0]); file.value = ''; } });
    const label = labelled_select('Scene', 'scene', [], (name) => this.choose(name));
    this.#select = label.querySelector('select');
    place.replaceChildren(label, file, element('label', { for: 'file', class: 'button' }, 'Open a file …'),
      element('span', { class: 'help' },
        'or drop one on the page: a drawing program, or a mesh in OBJ, OFF, PLY or STL'));
    for (const scene of scenes) this.add(scene);
  }

  add(scene) {
    if (!this.#scenes.has(scene.name)) this.#select.append(element('option', { value: scene.name }, scene.name));
    this.#scenes.set(scene.name, { ...scene });
  }

  has(name) {
    return this.#scenes.has(name);
  }

  choose(name) {
    this.#select.value = name;
    return this.#pick({ ...this.#scenes.get(name) });
  }

  /** What was edited stays while the page is open. */
  keep(name, program) {
    this.#scenes.get(name).program = program;
  }

  /** A file of a drawing program or a mesh; a mesh comes with an empty program before it. */
  take(file) {
    if (file) this.#read(file).catch(this.#refuse);
  }

  async #read(file) {
    const { name } = file;
    if (kProgramFiles.test(name)) {
      this.add({ name, program: await file.text() });
    } else if (kMeshFiles.test(name)) {
      this.add({ name, program: kBeforeMesh(name), mesh: { name, bytes: new Uint8Array(await file.arrayBuffer()) } });
    } else {
      throw new Error(`${name}: expected a drawing program (.draw) or a mesh (.obj, .off, .ply, .stl)`);
    }
    await this.choose(name);
  }
}

/** Files that are dropped anywhere on the page. */
function take_dropped_files(gallery) {
  const is_file = (event) => [...event.dataTransfer.types].includes('Files');
  const over = (is_over) => document.body.classList.toggle('dropping', is_over);
  addEventListener('dragover', (event) => {
    if (!is_file(event)) return;
    event.preventDefault();
    over(true);
  });
  addEventListener('dragleave', (event) => { if (!event.relatedTarget) over(false); });
  addEventListener('drop', (event) => {
    over(false);
    if (!is_file(event)) return;
    event.preventDefault();
    gallery.take(event.dataTransfer.files[0]);
  });
}
