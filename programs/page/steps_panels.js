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
        this.scrollTo(panel.body, '.role-active, .role-root, .role-compared, .role-front, .role-back');
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
      this.scrollTo(panel.body, '.role-active, .role-root, .role-compared');
    }
  }

  /** Brings what is marked to the middle of a panel that does not show all. */
  scrollTo(body, selector) {
    if (body.scrollHeight <= body.clientHeight && body.scrollWidth <= body.clientWidth) return;
    const marked = body.querySelector(selector);
    if (!marked) return;
    const outer = body.getBoundingClientRect(), inner = marked.getBoundingClientRect();
    body.scrollTop += inner.top + inner.height / 2 - outer.top - outer.height / 2;
    body.scrollLeft += inner.left + inner.width / 2 - outer.left - outer.width / 2;
  }

  content(panel, change) {
    const segments = (change || {}).segments || [];
    if (panel.kind === 'profile') return this.chart(segments, this.depthRange(), 'Depths along the row');
    if (panel.kind === 'graph') {
      return this.chart(segments, [0, Math.max(1, ...segments.map((s) => s[1]))], 'Counts along the line');
    }
    const rows = this.story.rows(change);
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

  /** The depths of all that the scene has, which the charts of all steps share. */
  depthRange() {
    if (!this.range) {
      let low = Infinity, high = -Infinity;
      for (const piece of this.story.data.pieces) {
        for (let k = 2; k < piece.points.length; k += 3) {
          low = Math.min(low, piece.points[k]);
          high = Math.max(high, piece.points[k]);
        }
      }
      this.range = [low, high];
    }
    return this.range;
  }

  /** Segments, each from x0, y0 to x1, y1: x from 0 to 1, y in the range, upward. */
  chart(segments, [low, high], what) {
    const kWide = 300, kHigh = 110, kRim = 8;
    const svg = StepsPicture.element('svg', {
      viewBox: `0 0 ${kWide} ${kHigh}`, class: 'chart', role: 'img', preserveAspectRatio: 'none',
      'aria-label': segments.length ? `${what}, in ${segments.length} parts` : `${what}: nothing`,
    });
    const y = (value) => kHigh - kRim - (high > low ? (value - low) / (high - low) : 0.5) * (kHigh - 2 * kRim);
    for (const [x0, y0, x1, y1, piece, role] of segments) {
      svg.append(StepsPicture.element('path', {
        d: `M${x0 * kWide} ${y(y0).toFixed(2)}L${x1 * kWide} ${y(y1).toFixed(2)}`,
        class: `chart-line role-${role}`,
        ...(piece >= 0 ? {style: `stroke:${this.story.colourOf(piece)}`} : {}),
      }));
    }
    return svg;
  }

  /** The depth of what each pixel shows, the nearest of all that the scene has white. */
  depths(ids) {
    const {width, height, data} = this.story;
    const [low, high] = this.depthRange();
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
