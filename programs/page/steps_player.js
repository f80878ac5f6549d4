'use strict';

/** The page: controls, keys, the listing, the sentence; and `steps`, for who drives it by script. */
class StepsPlayer {
  constructor(story) {
    this.story = story;
    this.at = -1;  // before the first step
    this.timer = 0;
    this.element = (id) => document.getElementById(id);
    this.picture = new StepsPicture(story, this.element('pixels'), this.element('overlay'));
    this.panels = new StepsPanels(story, this.element('panels'));
    this.element('picture').style.aspectRatio = `${story.width} / ${story.height}`;
    this.element('title').textContent = `${story.data.title}: ${document.title}`;
    this.element('source').textContent = story.data.source;
    this.element('code').textContent = story.data.code;
    this.buildListing();
    this.connect();
    this.goToAddress();
  }

  /** The step that the address names (#step=N, 0 before the first); the last if it names none. */
  goToAddress() {
    const named = /^#step=(\d+)$/.exec(location.hash);
    this.go(named ? Number(named[1]) - 1 : this.story.count - 1);
  }

  static kSpeeds = [['1 a second', 1000], ['4 a second', 250], ['15 a second', 66], ['60 a second', 16],
                    ['fastest', 0]];

  buildListing() {
    this.listing = this.story.data.listing.map(([indent, text], line) => {
      const item = document.createElement('li');
      const runs = this.story.steps.some((step) => step.line === line);
      const words = document.createElement(runs ? 'button' : 'span');
      words.style.paddingInlineStart = `${0.4 + 1.2 * indent}em`;
      words.textContent = text;
      if (runs) {
        words.type = 'button';
        words.title = 'To the next step that runs this line';
        words.addEventListener('click', () => this.go(this.story.nextOnLine(line, this.at)));
      }
      item.append(words);
      this.element('listing').append(item);
      return item;
    });
  }

  connect() {
    const act = {
      first: () => this.go(-1),
      back: () => this.go(this.at - 1),
      next: () => this.go(this.at + 1),
      last: () => this.go(this.story.count - 1),
      play: () => this.play(this.timer === 0),
    };
    for (const [id, does] of Object.entries(act)) {
      this.element(id).addEventListener('click', () => {
        if (id !== 'play') this.play(false);
        does();
      });
    }
    for (const [name, milliseconds] of StepsPlayer.kSpeeds) {
      this.element('speed').add(new Option(name, String(milliseconds)));
    }
    this.element('speed').value = '250';
    this.element('speed').addEventListener('change', () => {
      if (this.timer !== 0) this.play(true);
    });
    const slider = this.element('slider');
    slider.max = String(this.story.count);
    slider.addEventListener('input', () => {
      this.play(false);
      this.go(Number(slider.value) - 1);
    });
    for (const id of ['show-outlines', 'show-names']) {
      this.element(id).addEventListener('change', () => this.go(this.at));
    }
    document.addEventListener('keydown', (event) => this.key(event, act));
    window.addEventListener('hashchange', () => {
      this.play(false);
      this.goToAddress();
    });
  }

  key(event, act) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const on = event.target.tagName;
    if (on === 'SELECT' || (on === 'BUTTON' && event.key === ' ')) return;
    if (on === 'INPUT' && event.target.type === 'checkbox' && event.key === ' ') return;
    const does = {ArrowRight: 'next', ArrowLeft: 'back', Home: 'first', End: 'last', ' ': 'play'}[event.key];
    if (!does) return;
    event.preventDefault();
    if (does !== 'play') this.play(false);
    act[does]();
  }

  /** Plays on from here, from the beginning if this is the end; or stops. */
  play(on) {
    clearInterval(this.timer);
    this.timer = 0;
    if (on) {
      if (this.at >= this.story.count - 1) this.go(-1);
      const pause = Number(this.element('speed').value);
      this.timer = setInterval(() => {
        this.go(this.at + (pause === 0 ? 8 : 1));
        if (this.at >= this.story.count - 1) this.play(false);
      }, pause || 16);
    }
    const button = this.element('play');
    button.textContent = on ? '❚❚ stop' : '▶ play';
    button.setAttribute('aria-label', on ? 'Stop' : 'Play');
    button.setAttribute('aria-pressed', String(on));
    // What goes by quickly is not read out.
    this.element('sentence').setAttribute('aria-live', on ? 'off' : 'polite');
  }

  go(to) {
    const at = Math.min(Math.max(to, -1), this.story.count - 1);
    this.at = at;
    const step = at < 0 ? null : this.story.steps[at];
    this.picture.show(at, {outlines: this.element('show-outlines').checked, names: this.element('show-names').checked});
    this.panels.show(at, this.picture.ids);
    this.element('picture').setAttribute('aria-label', this.picture.described());
    this.element('slider').value = String(at + 1);
    this.element('slider').setAttribute('aria-valuetext', `step ${at + 1} of ${this.story.count}`);
    this.element('count').textContent = `${at + 1} / ${this.story.count}`;
    this.element('sentence').textContent = step ? step.say : this.before();
    this.showLine(step ? step.line : -1);
    this.showLegend(step ? step.marks || [] : []);
    this.element('first').disabled = this.element('back').disabled = at < 0;
    this.element('last').disabled = this.element('next').disabled = at >= this.story.count - 1;
    history.replaceState(null, '', `#step=${at + 1}`);
  }

  before() {
    const n = this.story.data.polygons.length;
    return `${n} ${n === 1 ? 'polygon or line' : 'polygons and lines'}, ${this.story.count} steps.`;
  }

  showLine(line) {
    this.listing.forEach((item, k) => {
      item.classList.toggle('runs', k === line);
      if (k === line) item.setAttribute('aria-current', 'step');
      else item.removeAttribute('aria-current');
    });
  }

  /** The marks by what they are, with the names of pieces. */
  showLegend(marks) {
    const words = {root: 'looked at', compared: 'compared', front: 'in front', back: 'behind', on: 'in the plane',
                   cut: 'cut', active: 'under work', seen: 'seen', hidden: 'hidden', tagged: 'tagged', upper: 'upper perimeter', lower: 'lower perimeter'};
    const roles = new Map();
    for (const [kind, role, piece] of marks) {
      if (!roles.has(role)) roles.set(role, new Set());
      if (kind === 'piece') roles.get(role).add(this.story.nameOf(piece));
    }
    this.element('legend').replaceChildren(...[...roles].filter(([role]) => words[role]).map(([role, names]) => {
      const item = document.createElement('li');
      item.className = `role-${role}`;
      item.textContent = names.size ? `${words[role]}: ${[...names].slice(0, 12).join(', ')}` : words[role];
      return item;
    }));
  }
}

const steps = (() => {
  const story = new StepsStory(JSON.parse(document.getElementById('data').textContent));
  const player = new StepsPlayer(story);
  document.documentElement.dataset.ready = String(Math.ceil(performance.now()));
  return {
    count: story.count,
    go: (step) => player.go(step - 1),  // 0 is before the first
    step: () => player.at + 1,
    /** Pick identifiers of what is seen, top row first, -1 for none. */
    ids: () => Array.from(player.picture.ids, (k) => (k < 0 ? -1 : story.data.polygons[k].pick)),
    /** R, G, B of each pixel on the canvas. */
    colours: () => {
      const {data} = document.getElementById('pixels').getContext('2d').getImageData(0, 0, story.width, story.height);
      return Array.from(data).filter((_, k) => k % 4 !== 3);
    },
  };
})();
