'use strict';

/** A tree as it grows: each node has from the start the place that it has in the whole tree. */
class StepsTree {
  constructor(story, panel) {
    this.story = story;
    this.panel = panel;
    this.nodes = story.nodes[panel];
    this.place();
  }

  /** In order: what is below a node on its first branches lies left of it, the rest right. */
  place() {
    const below = new Map();
    const roots = [];
    for (const node of this.nodes.values()) {
      if (node.parent < 0) roots.push(node);
      else below.set(node.parent, [...(below.get(node.parent) || []), node]);
    }
    for (const children of below.values()) children.sort((a, b) => a.branch - b.branch);
    let across = 0;
    this.depth = 0;
    const todo = roots.reverse().map((node) => ({node, level: 0, opened: false}));
    while (todo.length > 0) {
      const {node, level, opened} = todo.pop();
      if (opened) {
        node.x = across++;
        node.y = level;
        this.depth = Math.max(this.depth, level);
        continue;
      }
      const children = below.get(node.id) || [];
      const most = Math.max(1, ...children.map((child) => child.branch));
      const after = children.filter((child) => child.branch > most / 2);
      const before = children.filter((child) => child.branch <= most / 2);
      const wait = (child) => todo.push({node: child, level: level + 1, opened: false});
      after.reverse().forEach(wait);
      todo.push({node, level, opened: true});
      before.reverse().forEach(wait);
    }
    this.across = across;
  }

  element(at) {
    const kWide = 44, kHigh = 46, kRadius = 15;
    const width = Math.max(1, this.across) * kWide, height = (this.depth + 1) * kHigh;
    const svg = StepsPicture.element('svg', {
      viewBox: `0 0 ${width} ${height}`, class: 'tree', role: 'img', style: `max-width:${width}px;min-width:${Math.min(width, 20 * this.across)}px`,
    });
    const x = (node) => (node.x + 0.5) * kWide, y = (node) => (node.y + 0.5) * kHigh;
    const links = [], dots = [], told = [];
    const marked = this.rolesOfStep(at);
    const lit = this.litNodes(at);
    for (const node of this.nodes.values()) {
      const look = StepsStory.lastUntil(node.looks, at);
      if (!look) continue;
      const parent = this.nodes.get(node.parent);
      if (parent) {
        links.push(StepsPicture.element('path', {d: `M${x(parent)} ${y(parent)}L${x(node)} ${y(node)}`}));
        told.push(`${look.text} under ${StepsStory.lastUntil(parent.looks, at).text}`);
      } else {
        told.push(`root ${look.text}`);
      }
      const role = lit.get(node.id) || marked.get(look.piece) || look.role;
      const bare = look.piece < 0;  // a node that holds nothing of the scene: no more than a dot
      const group = StepsPicture.element('g', {class: `node role-${role}${bare ? ' bare' : ''}`});
      const long = !bare && look.text.length > 4;
      const radius = bare ? kRadius / 2 : kRadius;
      group.append(
          StepsPicture.element('rect', {
            x: x(node) - (long ? kWide / 2 - 2 : radius), y: y(node) - radius,
            width: long ? kWide - 4 : 2 * radius, height: 2 * radius, rx: long ? 4 : radius,
            ...(look.piece >= 0 ? {style: `fill:${this.story.colourOf(look.piece)}`} : {}),
          }),
          StepsPicture.element('text', {x: x(node), y: y(node)}, bare ? '' : long ? look.text.slice(0, 7) : look.text),
          StepsPicture.element('title', {}, look.text));
      dots.push(group);
    }
    svg.setAttribute('aria-label', told.length ? `Tree: ${told.slice(0, 60).join('; ')}` : 'The tree is empty');
    const link_group = StepsPicture.element('g', {class: 'links'});
    link_group.append(...links);
    svg.append(link_group, ...dots);
    return svg;
  }

  /** The nodes that the step lights by their numbers. */
  litNodes(at) {
    const rows = this.story.rows(this.story.panel(this.panel, at));
    return new Map(rows.map(([, role, number]) => [Number(number), role]));
  }

  rolesOfStep(at) {
    const marks = at < 0 ? [] : this.story.steps[at].marks || [];
    return new Map(marks.filter(([kind]) => kind === 'piece').map(([, role, piece]) => [piece, role]));
  }
}
