'use strict';

/** The data structures beside the picture, each as what it is: lists, tables, trees, profiles. */
class StepsPanels {
  constructor(story, place) {
    this.story = story;
    this.panels = story.data.panels.map((panel, number) => this.build(panel, number, place));
  }

  build(panel, number, place) {
    const section = document.createElement('section');
    section.className = `panel panel-${panel.kind}`;
    const heading = document.createElement('h2');
    heading.textContent = panel.title;
    const body = document.createElement('div');
    body.className = 'panel-body';
    section.append(heading, body);
    place.append(section);
    const tree = panel.kind === 'tree' ? new StepsTree(this.story, number) : null;
    return {panel, number, body, section, tree, shown: undefined};
  }

  show(at, ids) {
    for (const panel of this.panels) {
      if (panel.tree) {
        panel.body.replaceChildren(panel.tree.element(at));
        continue;
      }
      if (panel.panel.kind === 'depths') {
        panel.body.replaceChildren(this.depths(ids));
        continue;
      }
      const change = this.story.panel(panel.number, at);
      if (change === panel.shown && change !== undefined) continue;
      panel.shown = change;
      panel.body.replaceChildren(this.content(panel.panel, change));
      const marked = panel.body.querySelector('.role-active, .role-root, .role-compared');
      if (marked && panel.body.scrollHeight > panel.body.clientHeight) {
        panel.body.scrollTop = Math.max(0, marked.offsetTop - panel.body.clientHeight / 2);
      }
    }
  }

  content(panel, change) {
    if (panel.kind === 'profile') return this.profile((change || {}).segments || []);
    const rows = (change || {}).rows || [];
    if (rows.length === 0) return this.nothing();
    return panel.kind === 'table' ? this.table(panel.columns.split('|'), rows) : this.list(rows);
  }

  nothing() {
    const empty = document.createElement('p');
    empty.className = 'empty';
    empty.textContent = 'empty';
    return empty;
  }

  swatch(piece) {
    const swatch = document.createElement('span');
    swatch.className = 'swatch';
    if (piece >= 0) swatch.style.background = this.story.colourOf(piece);
    return swatch;
  }

  list(rows) {
    const list = document.createElement('ol');
    list.className = 'chips';
    for (const [piece, role, text] of rows) {
      const item = document.createElement('li');
      item.className = `role-${role}`;
      if (piece >= 0) item.append(this.swatch(piece));
      item.append(text);
      list.append(item);
    }
    return list;
  }

  table(columns, rows) {
    const table = document.createElement('table');
    const head = table.createTHead().insertRow();
    for (const column of columns) {
      const cell = document.createElement('th');
      cell.scope = 'col';
      cell.textContent = column;
      head.append(cell);
    }
    const body = table.createTBody();
    for (const [piece, role, ...cells] of rows) {
      const row = body.insertRow();
      row.className = `role-${role}`;
      cells.forEach((text, k) => {
        const cell = row.insertCell();
        if (k === 0 && piece >= 0) cell.append(this.swatch(piece));
        cell.append(text);
      });
    }
    return table;
  }

  /** Segments over the picture's width; what is nearer to the viewer is higher. */
  profile(segments) {
    const kWide = 300, kHigh = 110, kRim = 6;
    const svg = StepsPicture.element('svg', {
      viewBox: `0 0 ${kWide} ${kHigh}`, class: 'profile', role: 'img', preserveAspectRatio: 'none',
      'aria-label': segments.length ? `Depths along the row, of ${segments.length} runs` : 'Nothing is on the row',
    });
    const depths = segments.flatMap((s) => [s[1], s[3]]);
    const low = Math.min(...depths), high = Math.max(...depths);
    const y = (z) => kHigh - kRim - (high > low ? (z - low) / (high - low) : 0.5) * (kHigh - 2 * kRim);
    for (const [x0, z0, x1, z1, piece, role] of segments) {
      svg.append(StepsPicture.element('path', {
        d: `M${x0 * kWide} ${y(z0).toFixed(2)}L${x1 * kWide} ${y(z1).toFixed(2)}`,
        class: `profile-line role-${role}`,
        ...(piece >= 0 ? {style: `stroke:${this.story.colourOf(piece)}`} : {}),
      }));
    }
    return svg;
  }

  /** The depth of what each pixel shows, the nearest of all that the scene has white. */
  depths(ids) {
    const {width, height, data} = this.story;
    if (!this.range) {
      const corners = data.pieces.flatMap((piece) => piece.points.filter((_, k) => k % 3 === 2));
      this.range = [Math.min(...corners), Math.max(...corners)];
    }
    const [low, high] = this.range;
    const canvas = document.createElement('canvas');
    canvas.className = 'depths';
    canvas.width = width;
    canvas.height = height;
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', 'The depth at each pixel, the nearer the lighter');
    const image = new ImageData(width, height);
    ids.forEach((polygon, k) => {
      let grey = 0;
      if (polygon >= 0) {
        const [z0, dzDx, dzDy] = data.polygons[polygon].plane;
        const x = ((k % width) + 0.5) / width, y = 1 - (Math.floor(k / width) + 0.5) / height;
        const z = z0 + dzDx * x + dzDy * y;
        grey = 60 + 195 * (high > low ? Math.min(Math.max((z - low) / (high - low), 0), 1) : 1);
      }
      image.data.set([grey, grey, grey, 255], 4 * k);
    });
    canvas.getContext('2d').putImageData(image, 0, 0);
    return canvas;
  }
}
